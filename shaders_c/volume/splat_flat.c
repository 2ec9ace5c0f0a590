#include "shaders_c/volume/splat_flat.h"

#include "shaders_c/volume/splat_shared.h"

/* in   normal: in eye space; share: f, or 0 */
GP_INLINE VoxelSpread flattened(VoxelSpread s, float3 normal, flt share)
{
    float3 along = vec3(dp3(normal, vec3(s.xx, s.xy, s.xz)), dp3(normal, vec3(s.xy, s.yy, s.yz)),
                        dp3(normal, vec3(s.xz, s.yz, s.zz)));
    flt k = share * rcp(max(dp3(normal, along), 1e-9f));
    float3 less = mul(along, k);
    return (
        VoxelSpread){ s.xx - less.x * along.x, s.xy - less.x * along.y, s.yy - less.y * along.y,
                      s.xz - less.x * along.z, s.yz - less.y * along.z, s.zz - less.z * along.z };
}

GP_INLINE void flat_point(GpInvocation *gp, const VoxelFlatUniforms *c, const VoxelVertex *in,
                          VoxelFootprint which, float4 *position, VoxelVarying *out,
                          flt *point_size)
{
    EyeVoxel eye = voxel_before_eye(&c->voxel, voxel_place(in->place));
    float4 color = voxel_color(gp, &c->voxel, in->attributes);
    float3 normal = voxel_normal(
        &c->voxel, sub(vec3(in->attributes.y, in->attributes.z, in->attributes.w), 128));
    flt share = sel(color.w < c->opaque, bcast(0), bcast(c->flatness));
    VoxelSpread flat = flattened(voxel_spread(&c->voxel), normal, share);
    VoxelSplat splat = voxel_splat_spread(&c->voxel, &eye, flat, which);
    *position = voxel_clip(&c->voxel, &eye, color.w);
    voxel_put(&c->voxel, &eye, color, &splat, out, point_size);
}

pixel_shader(flat_ps, VoxelFlatUniforms, VoxelVarying)
{
    return mul(in->color, voxel_weight(&c->voxel, in->conic, in->place, vpos()));
}

/* clang-format off */
#define FLAT_DECLARATIONS                                                                          \
    MODEL_3_0, .inputs = { VOXEL_INPUTS }, .varyings = { VOXEL_VARYINGS },                         \
    .vertex_samplers = 1 << 0, .uses_pixel = true, .writes_point_size = true
/* clang-format on */

vertex_shader(flat_ewa_vs, VoxelFlatUniforms, VoxelVertex, VoxelVarying)
{
    flat_point(gp, c, in, FOOTPRINT_EWA, position, out, point_size);
}

program(voxel_flat_ewa_program, flat_ewa_vs, flat_ps, FLAT_DECLARATIONS)

vertex_shader(flat_reconstruction_vs, VoxelFlatUniforms, VoxelVertex, VoxelVarying)
{
    flat_point(gp, c, in, FOOTPRINT_RECONSTRUCTION, position, out, point_size);
}

program(voxel_flat_reconstruction_program, flat_reconstruction_vs, flat_ps, FLAT_DECLARATIONS)
