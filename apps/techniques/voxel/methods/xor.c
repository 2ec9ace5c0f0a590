/* Solids by parity: each fragment turns over what is below it. */
#include "apps/techniques/voxel/methods/methods.h"
#include "apps/techniques/voxel/methods/lists.h"
#include "shaders_c/voxel/methods/parity.h"

enum { TARGETS = 4, DEPTH = VOXEL_PARITY_DEPTH };

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

    GpGeometry geometry = voxel_group_triangles(model, frame, extents, uniforms->floor, DEPTH, top);
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
