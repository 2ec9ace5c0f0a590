/* Blinn-Phong lighting of colours with normals, both of whose sides are lit. For shader files
 * only. */
#ifndef SHADERS_WARP_LIGHT_SHARED_H
#define SHADERS_WARP_LIGHT_SHARED_H

#include "shaders_c/warp/light.h"

#include <glasspipe/shader.h>

/* Towards a place or along a direction, unit length. */
GP_INLINE float3 warp_towards(const float place[4], float3 world)
{
    return nrm(sub(u3(place), mul(world, place[3])));
}

/* A colour under the light. in normal: of any length but 0 */
GP_INLINE float3 warp_lit(const WarpLightUniforms *c, float3 color, float3 normal, float3 world)
{
    float3 L = warp_towards(c->source, world), V = warp_towards(c->eye, world);
    float3 N = nrm(normal);
    N = sel(dp3(N, V) < 0.0f, mul(N, -1.0f), N);
    float3 H = nrm(add(V, L));
    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess)) * c->specular;
    float3 light = mad(u3(c->color), max(dp3(N, L), 0), u3(c->ambient));
    return mad(u3(c->color), highlight, mul(color, light));
}

#endif
