/* Texture reads of the shader language. */
#ifndef GP_SHADER_TEXTURES_H
#define GP_SHADER_TEXTURES_H

#include "pipeline/shader/types.h"

GP_INLINE float4 gp_read_texture(GpInvocation *gp, int slot, GpLodMode mode, float4 coord,
                                 float4 gradient)
{
    float4 texel;
    GpTextureRead read = { slot,
                           GP_LANES,
                           mode,
                           (const float *)&coord,
                           mode == GP_LOD_GRADIENT ? (const float *)&gradient : 0,
                           (float *)&texel };
    gp->call->read_texture(gp->call, &read);
    return texel;
}

GP_INLINE float4 gp_coord2(float2 a)
{
    return (float4){ a.x, a.y, flt_set(0), flt_set(0) };
}
GP_INLINE float4 gp_coord3(float3 a)
{
    return (float4){ a.x, a.y, a.z, flt_set(0) };
}
#define gp_coord(a)                                                                                \
    (GP_SAY(GP_WIDTH(a) % 5 > 1,                                                                   \
            "texld(slot, a): a coordinate must be a float2, a float3 or a float4"),                \
     _Generic((a), float2                                                                          \
              : gp_coord2, float3                                                                  \
              : gp_coord3, default                                                                 \
              : gp_same4)(a))

GP_INLINE float4 gp_project(float4 a)
{
    return (float4){ a.x / a.w, a.y / a.w, a.z / a.w, flt_set(0) };
}

/* texld(slot, uv)        level from the quad; a float3's z is the reference of a depth compare
 * texldp(slot, uvrw)     u, v, r divided by w first
 * texldb(slot, uvrw)     level + w
 * texldl(slot, uvrw)     level w; the only read a vertex shader may do
 * texldd(slot, uv, dx, dy)   level from the float2 derivatives of u and v */
#define texld(slot, a)  gp_read_texture(gp, slot, GP_LOD_IMPLICIT, gp_coord(a), sp4(bcast(0)))
#define texldp(slot, a) gp_read_texture(gp, slot, GP_LOD_IMPLICIT, gp_project(a), sp4(bcast(0)))
#define texldb(slot, a) gp_read_texture(gp, slot, GP_LOD_BIAS, a, sp4(bcast(0)))
#define texldl(slot, a) gp_read_texture(gp, slot, GP_LOD_EXPLICIT, a, sp4(bcast(0)))
#define texldd(slot, a, dx, dy)                                                                    \
    gp_read_texture(gp, slot, GP_LOD_GRADIENT, gp_coord(a),                                        \
                    (float4){ (dx).x, (dx).y, (dy).x, (dy).y })

GP_INLINE float4 gp_read_local(GpInvocation *gp, int slot)
{
    float4 texel;
    gp->call->read_local(gp->call, slot, gp->packet, GP_LANES, (float *)&texel);
    return texel;
}
/* gp_load_local(slot): the texel at the pixel's own position in a surface that an earlier pass of
 * the same size rendered. */
#define gp_load_local(slot) gp_read_local(gp, slot)

#endif
