/* What only pixel shaders have: derivatives, discards, depth, the place and the facing of a
 * pixel. */
#ifndef GP_SHADER_PIXELS_H
#define GP_SHADER_PIXELS_H

#include "pipeline/shader/instructions.h"

GP_INLINE void gp_use(GpInvocation *gp, GpShaderUse what)
{
    gp->used |= what;
}
#define GP_USES(what) gp_use(gp, GP_USED_##what)

/* --- derivatives: differences inside the 2x2 quad --------------------------------------------- */

GP_MAP1(gp_dsx, flt_quad_dx)
GP_MAP1(gp_dsy, flt_quad_dy)
/* To the right and downward, of a's width. */
#define dsx(a) (GP_USES(DERIVATIVES), GP_ONE(dsx, gp_dsx, a))
#define dsy(a) (GP_USES(DERIVATIVES), GP_ONE(dsy, gp_dsy, a))

/* --- discards, depth, registers --------------------------------------------------------------- */

/* Kills the lanes of a mask; texkill: those in which any of x, y, z is below 0 (CHOOSE). */
#define discard(mask) (GP_USES(DISCARD), (void)(gp->killed |= (msk)(mask)))
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
#define texkill(a)    discard(GP_ONE(texkill, gp_kill, a))
#define odepth(value) (GP_USES(DEPTH), (void)(gp->depth = (value)))

GP_INLINE float2 gp_vpos(const GpInvocation *gp)
{
    return ((const float2 *)(const void *)gp->call->pixel)[gp->packet];
}
GP_INLINE flt gp_vface(const GpInvocation *gp)
{
    return ((const flt *)(const void *)gp->call->face)[gp->packet];
}
/* vpos: the pixel's x and y as integers (vPos); vface: +1 clockwise (front), -1 (vFace). */
#define vpos()  (GP_USES(PIXEL), gp_vpos(gp))
#define vface() (GP_USES(FACE), gp_vface(gp))

#endif
