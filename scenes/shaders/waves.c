/* Waves that run up the model and push it outwards: values[0] is their height, values[1] how many
 * there are, and --time moves them. A grid of lines shows the texture coordinates. */
#include <glasspipe/effect.h>

typedef struct Varying {
    float3 normal;
    float2 texcoord;
} Varying;

vertex_shader(waves_vs, EffectUniforms, EffectVertex, Varying)
{
    flt wave = sin_(in->position.y * c->values[1] - 6.2831853f * c->time) * c->values[0];
    *position = m4x4(mad(in->normal, wave, in->position), c->view_projection);
    out->normal = in->normal;
    out->texcoord = in->texcoord;
}

pixel_shader(waves_ps, EffectUniforms, Varying)
{
    float2 cell = abs_(sub(frc(mul(in->texcoord, 12)), 0.5f));
    float3 color = lrp(sge(max(cell.x, cell.y), 0.45f), vec3(1, 1, 1), vec3(0.2f, 0.4f, 0.8f));
    flt light = max(dp3(nrm(in->normal), u3(c->light)), 0.1f);
    return rgba(mul(color, light), 1);
}

program(waves, waves_vs, waves_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = { EFFECT_INPUTS },
        .varyings = { { "normal", 3, GP_PERSPECTIVE }, { "texcoord", 2, GP_PERSPECTIVE } })
