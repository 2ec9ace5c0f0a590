/* What only pixel shaders have: derivatives, discards, depth, the place and the facing of a pixel. */
#ifndef GP_SHADER_PIXELS_H
#define GP_SHADER_PIXELS_H

#include "pipeline/shader/instructions.h"

/* --- derivatives: differences inside the 2x2 quad --------------------------------------------- */

GP_MAP1(gp_dsx, flt_quad_dx)
GP_MAP1(gp_dsy, flt_quad_dy)
#define dsx(a) GP_BY_WIDTH(gp_dsx, a)(a)
#define dsy(a) GP_BY_WIDTH(gp_dsy, a)(a)

/* --- discards, depth, registers --------------------------------------------------------------- */

/* Kills the lanes of a mask; texkill: those in which any of x, y, z is below 0 (CHOOSE). */
#define discard(mask) ((void)(gp->killed |= (msk)(mask)))
GP_INLINE msk gp_kill1(flt a)
{
    return a < 0.0f;
}
GP_INLINE msk gp_kill2(float2 a)
{
    return (msk)(a.x < 0.0f) | (msk)(a.y < 0.0f);
}
GP_INLINE msk gp_kill3(float3 a)
{
    return (msk)(a.x < 0.0f) | (msk)(a.y < 0.0f) | (msk)(a.z < 0.0f);
}
GP_INLINE msk gp_kill4(float4 a)
{
    return gp_kill3(xyz(a));
}
#define texkill(a)    discard(GP_BY_WIDTH(gp_kill, a)(a))
#define odepth(value) ((void)(gp->depth = (value)))

/* vpos: the pixel's x and y as integers (vPos); vface: +1 clockwise (front), -1 (vFace). */
GP_INLINE float2 gp_vpos(const GpInvocation *gp)
{
    return ((const float2 *)(const void *)gp->call->pixel)[gp->packet];
}
GP_INLINE flt gp_vface(const GpInvocation *gp)
{
    return ((const flt *)(const void *)gp->call->face)[gp->packet];
}
#define vpos()  gp_vpos(gp)
#define vface() gp_vface(gp)

#endif
