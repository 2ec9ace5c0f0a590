/* Blinn-Phong lighting at a point: Blinn, "Models of light reflection for computer synthesized
 * pictures", SIGGRAPH 1977. For shader files only. */
#ifndef SHADERS_PHONG_SHARED_H
#define SHADERS_PHONG_SHARED_H

#include "shaders_c/materials/phong.h"

#include <glasspipe/shader.h>

/* What the surface sends to the eye whichever way it looks, textures apart; and how much of the
 * light mirrors
 * in it. */
typedef struct PhongLight {
    float3 color;
    flt highlight;
} PhongLight;

/* in     N: unit length; world: where the surface is */
GP_INLINE PhongLight phong_light(const PhongUniforms *c, float3 N, float3 world)
{
    float3 L = u3(c->light);
    float3 V = nrm(sub(u3(c->eye), world));
    float3 H = nrm(add(V, L));

    flt diffuse = max(dp3(N, L), 0);
    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess));
    return (PhongLight){ mad(u3(c->diffuse), diffuse, u3(c->ambient)), highlight };
}

/* in     color: the surface's, lit */
GP_INLINE float3 with_highlight(const PhongUniforms *c, PhongLight light, float3 color)
{
    return mad(sp3(light.highlight), c->specular, color);
}

#endif
