#include "shaders_c/fragments/weighted.h"

#include "shaders_c/fragments/fragment_shared.h"

typedef struct WeightedTargets {
    float4 sum, through;
} WeightedTargets;

fragment_vertex_shader(weighted_vs);

pixel_shader_targets(weighted_ps, FragmentUniforms, FragmentVarying, WeightedTargets)
{
    float4 source = fragment_source(c, in);
    flt nearness = 1.0f - in->depth;
    flt weight = in->color.w * max(nearness * nearness * nearness * 3e3f, 1e-2f);
    out->sum = mul(rgba(xyz(source), in->color.w), weight);
    out->through = sp4(source.w);
}

program(weighted_program, weighted_vs, weighted_ps, FRAGMENT_DECLARATIONS, MODEL_2_0)

clip_vertex_shader(weighted_layers_vs, NoUniforms);

pixel_shader(weighted_layers_ps, NoUniforms, NoVarying)
{
    float4 sum = gp_load_local(0);
    flt hidden = 1.0f - gp_load_local(1).w;
    return rgba(mul(xyz(sum), hidden * rcp(max(sum.w, 1e-5f))), hidden);
}

program(weighted_layers_program, weighted_layers_vs, weighted_layers_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 3)
