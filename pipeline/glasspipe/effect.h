/* What `glasspipe shader FILE` gives to the shaders of a file: one model in the middle of the
 * world, a light and a camera. Such a file includes this, and nothing else:
 *
 *     #include <glasspipe/effect.h>
 *
 *     typedef struct Varying { float3 normal; } Varying;
 *
 *     vertex_shader(clay_vs, EffectUniforms, EffectVertex, Varying)
 *     {
 *         *position = m4x4(in->position, c->view_projection);
 *         out->normal = in->normal;
 *     }
 *
 *     pixel_shader(clay_ps, EffectUniforms, Varying)
 *     {
 *         flt light = max(dp3(nrm(in->normal), u3(c->light)), 0.1f);
 *         return rgba(mul(vec3(0.9f, 0.5f, 0.3f), light), 1);
 *     }
 *
 *     program(clay, clay_vs, clay_ps,
 *             .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
 *             .inputs = { EFFECT_INPUTS },
 *             .varyings = { { "normal", 3, GP_PERSPECTIVE } })
 */
#ifndef GP_EFFECT_H
#define GP_EFFECT_H

#include "pipeline/shader/effect_uniforms.h"
#include <glasspipe/shader.h>

#if !defined __cplusplus || __cplusplus >= 202002L

/* Any other struct does as well, with its .inputs: vertices have these four semantics, with as many
 * components as are asked for. */
typedef struct EffectVertex {
    float3 position; /* world: the longest side of the model's box goes from -1 to 1 */
    float3 normal;   /* world, unit length, outwards */
    float2 texcoord; /* (0, 0) is the top left of a picture */
    float4 color;    /* white where the model has none */
} EffectVertex;

/* clang-format off */
#define EFFECT_INPUTS                                                                              \
    { GP_POSITION, 3 }, { GP_NORMAL, 3 }, { GP_TEXCOORD0, 2 }, { GP_COLOR, 4 }
/* clang-format on */

#endif

#endif
