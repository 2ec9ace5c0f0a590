#include "shaders_c/volume/splat_shared.h"

GP_INLINE void voxel_point(GpInvocation *gp, const VoxelUniforms *c, const VoxelVertex *in,
                           VoxelFootprint which, float4 *position, VoxelVarying *out,
                           flt *point_size)
{
    EyeVoxel eye = voxel_before_eye(c, voxel_place(in->place));
    float4 color = voxel_color(gp, c, in->attributes);
    *position = voxel_clip(c, &eye, color.w);
    voxel_vertex(c, &eye, color, which, out, point_size);
}

pixel_shader(voxel_ps, VoxelUniforms, VoxelVarying)
{
    return mul(in->color, voxel_weight(c, in->conic, in->place, vpos()));
}

/* clang-format off */
#define VOXEL_DECLARATIONS                                                                         \
    MODEL_3_0, .inputs = { VOXEL_INPUTS }, .varyings = { VOXEL_VARYINGS }, .vertex_samplers = 1 << 0, \
    .uses_pixel = true, .writes_point_size = true
/* clang-format on */

vertex_shader(voxel_ewa_vs, VoxelUniforms, VoxelVertex, VoxelVarying)
{
    voxel_point(gp, c, in, FOOTPRINT_EWA, position, out, point_size);
}

program(voxel_ewa_program, voxel_ewa_vs, voxel_ps, VOXEL_DECLARATIONS)

vertex_shader(voxel_reconstruction_vs, VoxelUniforms, VoxelVertex, VoxelVarying)
{
    voxel_point(gp, c, in, FOOTPRINT_RECONSTRUCTION, position, out, point_size);
}

program(voxel_reconstruction_program, voxel_reconstruction_vs, voxel_ps, VOXEL_DECLARATIONS)

vertex_shader(voxel_low_pass_vs, VoxelUniforms, VoxelVertex, VoxelVarying)
{
    voxel_point(gp, c, in, FOOTPRINT_LOW_PASS, position, out, point_size);
}

program(voxel_low_pass_program, voxel_low_pass_vs, voxel_ps, VOXEL_DECLARATIONS)
