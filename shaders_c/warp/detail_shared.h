/* Micro-structure (paper 001, section 3.4): a second depth texture changes depths before they are
 * warped. For shader files only. */
#ifndef SHADERS_WARP_DETAIL_SHARED_H
#define SHADERS_WARP_DETAIL_SHARED_H

#include "shaders_c/warp/detail.h"

#include <glasspipe/shader.h>

/* in  uv: of the depth image, 0..1 */
GP_INLINE flt warp_detailed(GpInvocation *gp, const WarpDetailUniforms *c, float2 uv, flt depth)
{
    float4 at = vec4(uv.x * c->repeats[0], uv.y * c->repeats[1], 0, c->level);
    return depth - texldl(WARP_DETAIL_SLOT, at).x * c->height;
}

#endif
