/* Layered depth images by depth peeling, as far as voxels.
 * source Heidelberger, Teschner and Gross, "Real-time volumetric intersections of deforming
 *        objects", Vision, Modeling and Visualization 2003; Everitt, "Interactive
 *        order-independent transparency", NVIDIA 2001 */
#include "shaders_c/common/cover_shared.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"
#include "shaders_c/voxel/methods/layers.h"

/* --- peeling ---------------------------------------------------------------------------------- */

vertex_shader(voxel_peel_vs, VoxelPeelUniforms, PointVertex, DepthVarying)
{
    *position = m4x4(in->position, c->to_clip);
    out->depth = position->z;
}

/* The shader's own depth goes into the depth buffer too, so that what is compared with the layer
 * before is what was stored there, bit for bit. */
pixel_shader(voxel_peel_first_ps, VoxelPeelUniforms, DepthVarying)
{
    odepth(in->depth);
    return sp4(in->depth);
}

pixel_shader(voxel_peel_next_ps, VoxelPeelUniforms, DepthVarying)
{
    discard(in->depth <= gp_load_local(0).x);
    odepth(in->depth);
    return sp4(in->depth);
}

/* clang-format off */
#define PEEL_DECLARATIONS                                                                          \
    MODEL_2_0, .inputs = { { GP_POSITION, 3 } }, .varyings = { { "depth", 1, GP_LINEAR_SCREEN } }

program(voxel_peel_first_program, voxel_peel_vs, voxel_peel_first_ps, PEEL_DECLARATIONS,
        .writes_depth = true)
program(voxel_peel_next_program, voxel_peel_vs, voxel_peel_next_ps, PEEL_DECLARATIONS,
        .local_reads = 1 << 0, .may_discard = true, .writes_depth = true)
/* clang-format on */

/* --- voxels ----------------------------------------------------------------------------------- */

cover_vertex_shader(voxel_layer_vs, FlatTextureSlab);

pixel_shader(voxel_layer_ps, FlatTextureSlab, CoverVarying)
{
    flt voxel = floor_(texld(0, in->place).x * c->size) - c->base;
    return bits_between(voxel, voxel + 1.0f);
}

pixel_shader(voxel_between_ps, FlatTextureSlab, CoverVarying)
{
    flt entry = texld(0, in->place).x * c->size, exit = texld(1, in->place).x;
    flt first = -floor_(0.5f - entry), end = floor_(exit * c->size + 0.5f);
    end = sel(exit <= 1.0f, end, first);
    return bits_between(first - c->base, end - c->base);
}

/* clang-format off */
#define LAYER_DECLARATIONS MODEL_2_0, COVER_DECLARATIONS

program(voxel_layer_program, voxel_layer_vs, voxel_layer_ps, LAYER_DECLARATIONS,
        .samplers = 1 << 0)
program(voxel_between_program, voxel_layer_vs, voxel_between_ps, LAYER_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1)
/* clang-format on */
