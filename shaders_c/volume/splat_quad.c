#include "shaders_c/volume/splat_quad.h"

#include "shaders_c/volume/splat_shared.h"

typedef struct CornerVertex {
    float4 attributes, place;
    float2 corner;
} CornerVertex;

GP_INLINE void voxel_corner(GpInvocation *gp, const VoxelUniforms *c, const CornerVertex *in,
                            VoxelFootprint which, float4 *position, VoxelVarying *out)
{
    EyeVoxel eye = voxel_before_eye(c, voxel_place(in->place));
    float4 color = voxel_color(gp, c, in->attributes);
    float4 clip = voxel_clip(c, &eye, color.w);
    flt side;
    voxel_vertex(c, &eye, color, which, out, &side);
    flt half = side * clip.w * 0.5f;
    clip.x = mad(mad(in->corner.x, 2, -1), half * c->ndc[0], clip.x);
    clip.y = mad(mad(in->corner.y, -2, 1), half * c->ndc[1], clip.y);
    *position = clip;
}

pixel_shader(qd_ps, VoxelUniforms, VoxelVarying)
{
    return mul(in->color, voxel_weight(c, in->conic, in->place, vpos()));
}

/* clang-format off */
#define QD_DECLARATIONS                                                                            \
    MODEL_3_0, .inputs = { VOXEL_INPUTS, { GP_TEXCOORD2, 2 } }, .varyings = { VOXEL_VARYINGS },    \
    .vertex_samplers = 1 << 0, .uses_pixel = true
/* clang-format on */

vertex_shader(qd_ewa_vs, VoxelUniforms, CornerVertex, VoxelVarying)
{
    voxel_corner(gp, c, in, FOOTPRINT_EWA, position, out);
}

program(voxel_qd_ewa_program, qd_ewa_vs, qd_ps, QD_DECLARATIONS)

vertex_shader(qd_reconstruction_vs, VoxelUniforms, CornerVertex, VoxelVarying)
{
    voxel_corner(gp, c, in, FOOTPRINT_RECONSTRUCTION, position, out);
}

program(voxel_qd_reconstruction_program, qd_reconstruction_vs, qd_ps, QD_DECLARATIONS)

vertex_shader(qd_low_pass_vs, VoxelUniforms, CornerVertex, VoxelVarying)
{
    voxel_corner(gp, c, in, FOOTPRINT_LOW_PASS, position, out);
}

program(voxel_qd_low_pass_program, qd_low_pass_vs, qd_ps, QD_DECLARATIONS)
