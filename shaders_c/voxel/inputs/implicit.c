/* A polynomial's sign at 32 samples of a column: its coefficients in z once, then each sample by
 * Horner's rule. Samples that voxels share have the same bits in each of them, since their places
 * are whole numbers or halves until the last step.
 * source Dong, Chen, Bao, Zhang and Peng, "Real-time voxelization for complex polygonal models",
 *        Pacific Graphics 2004: implicit surfaces by proxy quads */
#include "shaders_c/voxel/inputs/implicit_shared.h"
#include "shaders_c/voxel/inputs/implicit.h"

cover_vertex_shader(voxel_implicit_vs, VoxelImplicitUniforms);

/* The factor of z^k, at x and y. */
GP_INLINE flt factor_of_power(const VoxelImplicitUniforms *c, int k, flt x, flt y)
{
    flt in_y = bcast(c->coefficient[k][VOXEL_FUNCTION_DEGREE - k][0]);
    for (int j = VOXEL_FUNCTION_DEGREE - k - 1; j >= 0; j--) {
        flt in_x = bcast(c->coefficient[k][j][VOXEL_FUNCTION_DEGREE - k - j]);
        for (int i = VOXEL_FUNCTION_DEGREE - k - j - 1; i >= 0; i--)
            in_x = mad(in_x, x, c->coefficient[k][j][i]);
        in_y = mad(in_y, y, in_x);
    }
    return in_y;
}

GP_INLINE float4 bits_inside(const VoxelImplicitUniforms *c, float2 place)
{
    float2 voxel = floor_(mul(place, c->size));
    flt x = mad(voxel.x + c->first[0], c->scale, c->offset[0]);
    flt y = mad(voxel.y + c->first[1], c->scale, c->offset[1]);
    flt factor[VOXEL_FUNCTION_SIDE];
    for (int k = 0; k < VOXEL_FUNCTION_SIDE; k++)
        factor[k] = factor_of_power(c, k, x, y);

    float4 value[FOURS];
    for (int i = 0; i < FOURS; i++) {
        float4 sample = add(vec4(0, 1, 2, 3), bcast(c->first[2]) + (float)(4 * i));
        float4 z = mad(sample, c->scale, c->offset[2]);
        value[i] = sp4(factor[VOXEL_FUNCTION_DEGREE]);
        for (int k = VOXEL_FUNCTION_DEGREE - 1; k >= 0; k--)
            value[i] = mad(value[i], z, factor[k]);
    }
    return signs_below(value, c->inside);
}

pixel_shader(voxel_implicit_ps, VoxelImplicitUniforms, CoverVarying)
{
    return bits_inside(c, in->place);
}

pixel_shader_targets(voxel_implicit_corner_ps, VoxelImplicitUniforms, CoverVarying, TwoTargets)
{
    out->any = out->all = bits_inside(c, in->place);
}

program(voxel_implicit_program, voxel_implicit_vs, voxel_implicit_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_3_0, COVER_DECLARATIONS)
program(voxel_implicit_corner_program, voxel_implicit_vs, voxel_implicit_corner_ps,
        .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_3_0, COVER_DECLARATIONS)
