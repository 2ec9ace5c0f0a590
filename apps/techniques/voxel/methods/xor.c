/* Solids by parity: each fragment turns over what is below it. */
#include "apps/techniques/voxel/methods/methods.h"
#include "apps/techniques/voxel/methods/lists.h"
#include "shaders_c/voxel/methods/parity.h"

#include <string.h>

enum { TARGETS = 4, SLAB = 32, DEPTH = VOXEL_PARITY_DEPTH };

static bool rises_above(const VoxelExtent *extent, float floor)
{
    return extent->high >= floor;
}

/* A surface above the last centre turns over the whole group; up to the next group's first centre,
 * half a voxel beyond its floor, it does so here. */
static bool crosses(const VoxelExtent *extent, float floor)
{
    return extent->high >= floor && extent->low <= floor + DEPTH + 0.5f;
}

/* The triangles of a group of slabs; the top group has those above the volume too. */
static GpGeometry choose_triangles(const VoxelModel *model, Frame *frame,
                                   const VoxelExtent *extents, float floor, bool top)
{
    GpGeometry geometry = voxel_model_geometry(model);
    if (model->motions)
        return geometry;
    const VoxelList all = { NULL, model->triangle_count };
    const VoxelList list = voxel_choose(frame, extents, all, top ? rises_above : crosses, floor);
    uint32_t *indices = frame_alloc(frame, 3 * (size_t)list.count + 1, sizeof *indices);
    for (uint32_t i = 0; indices && i < list.count; i++)
        memcpy(indices + 3 * (size_t)i, model->indices + 3 * (size_t)list.triangles[i],
               3 * sizeof *indices);
    geometry.indices = indices;
    geometry.index_count = 3 * list.count;
    return geometry;
}

static void draw_group(const VoxelModel *model, Frame *frame, const VoxelExtent *extents,
                       uint32_t size, uint32_t group, uint32_t groups)
{
    const bool top = group + 1 == groups;
    VoxelParityUniforms *uniforms = frame_alloc(frame, 1, sizeof *uniforms);
    if (!uniforms)
        return;
    *uniforms = (VoxelParityUniforms){ .size = (float)size,
                                       .patch = (float)group,
                                       .patches = (float)groups,
                                       .floor = (float)(group * DEPTH),
                                       .most = top ? 1e30f : (float)DEPTH };
    voxel_set_motion(model, frame, &uniforms->motion);

    GpGeometry geometry = choose_triangles(model, frame, extents, uniforms->floor, top);
    if (!geometry.index_count)
        return;
    GpDraw *draw = frame_draw(frame, &voxel_parity_program, uniforms, &geometry);
    for (int i = 0; i < TARGETS; i++)
        draw->state.blend[i].op = GP_BLEND_LOGIC_XOR;
    draw->state.raster.scissor = true;
    draw->state.raster.scissor_x1 = (int32_t)size;
    draw->state.raster.scissor_y0 = (int32_t)(group * size);
    draw->state.raster.scissor_y1 = (int32_t)((group + 1) * size);
}

static void copy_slab(Frame *frame, GpSurface *const *targets, const FlatTexture *flat,
                      uint32_t slab, uint32_t groups)
{
    const VoxelParityResolveUniforms uniforms = { .patch = (float)(slab / TARGETS),
                                                  .patches = (float)groups };
    GpDraw *draw = flat_texture_draw(frame, &voxel_parity_resolve_program, &uniforms, flat, slab);
    draw->textures[0].surface = targets[slab % TARGETS];
    draw->textures[1].surface = targets[0];
}

void voxel_xor(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
               const FlatTexture *flat)
{
    const uint32_t size = setting->size, groups = (size + DEPTH - 1) / DEPTH;
    const VoxelExtent *extents = voxel_extents(model, frame);
    GpSurface *targets[TARGETS];
    for (int i = 0; i < TARGETS; i++)
        targets[i] = frame_surface(frame, GP_A8R8G8B8, size, groups * size, 1);
    GpPass *pass = frame_pass(frame, "parity", NULL, NULL, NULL);
    for (int i = 0; i < TARGETS; i++)
        pass->color[i] = (GpColorTarget){ .surface = targets[i], .clear = true };
    for (uint32_t group = 0; group < groups; group++)
        draw_group(model, frame, extents, size, group, groups);

    flat_texture_pass(frame, "solid", flat);
    for (uint32_t slab = 0; slab < flat->slabs; slab++)
        copy_slab(frame, targets, flat, slab, groups);
}
