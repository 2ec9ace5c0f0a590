#include "shaders_c/volume/splat_slab.h"

#include "shaders_c/volume/splat_shared.h"

#define LOG2_E 1.44269504088896340736f

/* From 0 to 1. */
GP_INLINE flt logistic(flt x)
{
    flt power = x * mad(x * x, 0.07056f * LOG2_E, 1.5976f * LOG2_E);
    return rcp(exp_(-power) + 1);
}

GP_INLINE flt share_before(const VoxelSlabUniforms *c, flt deviations)
{
    flt x = min(max(deviations, -c->voxel.cut), c->voxel.cut);
    return (logistic(x) - c->low) * c->per_whole;
}

GP_INLINE void slab_point(GpInvocation *gp, const VoxelSlabUniforms *c, const VoxelVertex *in,
                          VoxelFootprint which, float4 *position, VoxelVarying *out,
                          flt *point_size)
{
    EyeVoxel eye = voxel_before_eye(&c->voxel, voxel_place(in->place));
    float4 color = voxel_color(gp, &c->voxel, in->attributes);
    flt at = eye.position.z * c->per_deviation;
    color.w = color.w * (share_before(c, c->end - at) - share_before(c, c->begin - at));
    *position = voxel_clip(&c->voxel, &eye, color.w);
    voxel_vertex(&c->voxel, &eye, color, which, out, point_size);
}

pixel_shader(slab_ps, VoxelSlabUniforms, VoxelVarying)
{
    return mul(in->color, voxel_weight(&c->voxel, in->conic, in->place, vpos()));
}

/* clang-format off */
#define SLAB_DECLARATIONS                                                                          \
    MODEL_3_0, .inputs = { VOXEL_INPUTS }, .varyings = { VOXEL_VARYINGS },                         \
    .vertex_samplers = 1 << 0, .uses_pixel = true, .writes_point_size = true
/* clang-format on */

vertex_shader(slab_ewa_vs, VoxelSlabUniforms, VoxelVertex, VoxelVarying)
{
    slab_point(gp, c, in, FOOTPRINT_EWA, position, out, point_size);
}

program(voxel_slab_ewa_program, slab_ewa_vs, slab_ps, SLAB_DECLARATIONS)

vertex_shader(slab_reconstruction_vs, VoxelSlabUniforms, VoxelVertex, VoxelVarying)
{
    slab_point(gp, c, in, FOOTPRINT_RECONSTRUCTION, position, out, point_size);
}

program(voxel_slab_reconstruction_program, slab_reconstruction_vs, slab_ps, SLAB_DECLARATIONS)

vertex_shader(slab_low_pass_vs, VoxelSlabUniforms, VoxelVertex, VoxelVarying)
{
    slab_point(gp, c, in, FOOTPRINT_LOW_PASS, position, out, point_size);
}

program(voxel_slab_low_pass_program, slab_low_pass_vs, slab_ps, SLAB_DECLARATIONS)
