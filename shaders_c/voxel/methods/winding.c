/* Winding numbers of voxels by blending.
 * source ours, after the parity of Eisemann and Decoret, "Single-pass GPU solid voxelization for
 *        real-time applications", Graphics Interface 2008: a sum with signs in place of a sum
 *        modulo 2, as shadow volumes count with the stencil (Heidmann, "Real shadows, real time",
 *        Iris Universe 18, 1991) */
#include "shaders_c/common/cover_shared.h"
#include "shaders_c/voxel/methods/motion_shared.h"
#include "shaders_c/voxel/methods/winding.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"

/* --- counting --------------------------------------------------------------------------------- */

typedef struct Varying {
    flt height; /* z above the group's floor */
} Varying;

vertex_shader(voxel_winding_vs, VoxelWindingUniforms, PointVertex, Varying)
{
    float3 q = into_voxels(&c->motion, in->position);
    *position = vec4(q.x * (2.0f / c->size) - 1.0f, 1.0f - q.y * (2.0f / c->size), 0.5f, 1);
    out->height = q.z - c->floor;
}

pixel_shader_targets(voxel_winding_ps, VoxelWindingUniforms, Varying, SlabTargets)
{
    flt below = -floor_(0.5f - in->height); /* centres below the surface */
    below = sel(below <= c->most, below, 0);
    below = min(below, c->size - c->floor);
    for (int i = 0; i < 4; i++) {
        flt rest = below - 4.0f * (float)i;
        out->slab[i] = mul(vec4(sge(rest, 1), sge(rest, 2), sge(rest, 3), sge(rest, 4)), c->one);
    }
}

program(voxel_winding_program, voxel_winding_vs, voxel_winding_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 3 } },
        .varyings = { { "height", 1, GP_LINEAR_SCREEN } })

/* --- slabs ------------------------------------------------------------------------------------ */

cover_vertex_shader(voxel_winding_cover_vs, VoxelWindingCounts);

GP_INLINE flt number_in(const VoxelWindingCounts *c, flt texel)
{
    return texel * c->scale - c->zero;
}

/* Four bits of a byte, from `first` on, where a number and what is above it are not 0. */
GP_INLINE flt bits_where(const VoxelWindingCounts *c, float4 texel, flt above, float first)
{
    const flt numbers[4] = { texel.x, texel.y, texel.z, texel.w };
    flt bits = bcast(0);
    for (int i = 0; i < 4; i++)
        bits = bits + sge(abs_(number_in(c, numbers[i]) + above), 0.5f) * (first * (float)(1 << i));
    return bits;
}

GP_INLINE flt byte_where(const VoxelWindingCounts *c, float4 low, float4 high, flt above)
{
    return (bits_where(c, low, above, 1) + bits_where(c, high, above, 16)) * (1.0f / 255);
}

pixel_shader(voxel_winding_slab_ps, VoxelWindingCounts, CoverVarying)
{
    float4 texel[8];
    for (int i = 0; i < 8; i++)
        texel[i] = texld(i, in->place);
    flt above = texld(8, in->place).x, above_low = above + number_in(c, texel[4].x);
    return vec4(
        byte_where(c, texel[4], texel[5], above), byte_where(c, texel[2], texel[3], above_low),
        byte_where(c, texel[0], texel[1], above_low), byte_where(c, texel[6], texel[7], above));
}

pixel_shader(voxel_winding_sum_ps, VoxelWindingCounts, CoverVarying)
{
    flt groups = number_in(c, texld(0, in->place).x) + number_in(c, texld(1, in->place).x);
    return sp4(texld(2, in->place).x + groups);
}

/* clang-format off */
program(voxel_winding_slab_program, voxel_winding_cover_vs, voxel_winding_slab_ps,
        MODEL_3_0, COVER_DECLARATIONS, .samplers = (1 << 9) - 1)
program(voxel_winding_sum_program, voxel_winding_cover_vs, voxel_winding_sum_ps,
        MODEL_2_0, COVER_DECLARATIONS, .samplers = (1 << 3) - 1)
/* clang-format on */
