/* Clay: how directly a surface faces the light. */
#include <glasspipe/effect.h>

typedef struct Varying {
    float3 normal;
} Varying;

vertex_shader(clay_vs, EffectUniforms, EffectVertex, Varying)
{
    *position = m4x4(in->position, c->view_projection);
    out->normal = in->normal;
}

pixel_shader(clay_ps, EffectUniforms, Varying)
{
    flt light = max(dp3(nrm(in->normal), u3(c->light)), 0.1f);
    return rgba(mul(vec3(0.9f, 0.5f, 0.3f), light), 1);
}

program(clay, clay_vs, clay_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = { EFFECT_INPUTS }, .varyings = { { "normal", 3, GP_PERSPECTIVE } })
