/* Solids by the winding number: fragments that face up add to what is below them, those that face
 * down subtract. Slab by slab from the top, since counters of all voxels at once would be too
 * many. */
#include "apps/techniques/voxel/methods/lists.h"
#include "apps/techniques/voxel/methods/methods.h"
#include "shaders_c/voxel/methods/winding.h"

enum { TARGETS = 4, GROUPS = 2, SLAB = GROUPS * VOXEL_WINDING_DEPTH };

/* How a kind of counter counts: what it is cleared to stands for 0. Unsigned bytes begin in the
 * middle, or those that go below 0 before they come back would stay there. */
typedef struct Counter {
    GpFormat format;
    float one, none;
    VoxelWindingCounts counts;
} Counter;

static const Counter kinds[] = {
    [VOXEL_HALF] = { GP_A16B16G16R16F, 1, 0, { 1, 0 } },
    [VOXEL_BYTE] = { GP_A8R8G8B8, 1.0f / 255, 128.0f / 255, { 255, 128 } },
};

/* What the passes share. */
typedef struct Winding {
    const VoxelModel *model;
    Frame *frame;
    const VoxelExtent *extents;
    const Counter *counter;
    uint32_t size;
    GpSurface *targets[GROUPS][TARGETS]; /* the lower group, the upper */
    GpSurface *above[2];                 /* sums of all groups above a slab, in turn */
} Winding;

/* Clockwise on the screen, the default's front, is what faces up: the screen's y runs down. */
static void draw_facing(const Winding *w, const VoxelWindingUniforms *uniforms,
                        const GpGeometry *geometry, GpCull culled, GpBlendOp op)
{
    GpDraw *draw = frame_draw(w->frame, &voxel_winding_program, uniforms, geometry);
    draw->state.raster.cull = culled;
    for (int i = 0; i < TARGETS; i++)
        draw->state.blend[i] = (GpBlend){ .op = op, .src = GP_ONE, .dst = GP_ONE };
}

static void count_group(const Winding *w, uint32_t slab, uint32_t group)
{
    const uint32_t floor = slab * SLAB + group * VOXEL_WINDING_DEPTH;
    const bool top = floor + VOXEL_WINDING_DEPTH >= w->size;
    const float none = w->counter->none;
    GpPass *pass = frame_pass(w->frame, "count", NULL, NULL, NULL);
    for (int i = 0; i < TARGETS; i++)
        pass->color[i] = (GpColorTarget){ .surface = w->targets[group][i],
                                          .clear = true,
                                          .clear_color = { none, none, none, none } };
    VoxelWindingUniforms *uniforms =
        floor < w->size ? frame_alloc(w->frame, 1, sizeof *uniforms) : NULL;
    if (!uniforms)
        return;
    *uniforms = (VoxelWindingUniforms){ .size = (float)w->size,
                                        .floor = (float)floor,
                                        .most = top ? 1e30f : VOXEL_WINDING_DEPTH,
                                        .one = w->counter->one };
    voxel_set_motion(w->model, w->frame, &uniforms->motion);
    const GpGeometry geometry = voxel_group_triangles(w->model, w->frame, w->extents,
                                                      uniforms->floor, VOXEL_WINDING_DEPTH, top);
    if (!geometry.index_count)
        return;
    draw_facing(w, uniforms, &geometry, GP_CULL_CCW, GP_BLEND_ADD);
    draw_facing(w, uniforms, &geometry, GP_CULL_CW, GP_BLEND_REV_SUBTRACT);
}

static void fill_slab(const Winding *w, const FlatTexture *flat, uint32_t slab)
{
    flat_texture_pass(w->frame, "solid", flat)->color[0].clear = slab + 1 == flat->slabs;
    GpDraw *draw =
        flat_texture_draw(w->frame, &voxel_winding_slab_program, &w->counter->counts, flat, slab);
    for (int i = 0; i < GROUPS * TARGETS; i++)
        draw->textures[i].surface = w->targets[i / TARGETS][i % TARGETS];
    draw->textures[GROUPS * TARGETS].surface = w->above[slab % 2];
}

/* For the slab below. */
static void sum_up(const Winding *w, uint32_t slab)
{
    frame_pass(w->frame, "sum", w->above[(slab + 1) % 2], NULL, (const float[4]){ 0 });
    GpDraw *draw =
        frame_draw(w->frame, &voxel_winding_sum_program, &w->counter->counts, &flat_texture_cover);
    for (int i = 0; i < GROUPS; i++)
        draw->textures[i].surface = w->targets[i][0];
    draw->textures[GROUPS].surface = w->above[slab % 2];
}

void voxel_winding(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                   const FlatTexture *flat)
{
    const uint32_t size = setting->size;
    Winding w = { .model = model,
                  .frame = frame,
                  .extents = voxel_extents(model, frame),
                  .counter = &kinds[setting->counters],
                  .size = size };
    for (int i = 0; i < GROUPS * TARGETS; i++)
        w.targets[i / TARGETS][i % TARGETS] =
            frame_surface(frame, w.counter->format, size, size, 1);
    for (int i = 0; i < 2; i++)
        w.above[i] = frame_surface(frame, GP_R32F, size, size, 1);
    frame_pass(frame, "sum", w.above[(flat->slabs - 1) % 2], NULL, (const float[4]){ 0 });
    for (uint32_t slab = flat->slabs; slab-- > 0;) {
        for (uint32_t group = 0; group < GROUPS; group++)
            count_group(&w, slab, group);
        fill_slab(&w, flat, slab);
        if (slab > 0)
            sum_up(&w, slab);
    }
}
