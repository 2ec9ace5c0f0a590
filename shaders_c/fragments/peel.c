#include "shaders_c/fragments/peel.h"

#include "shaders_c/fragments/fragment_shared.h"

fragment_vertex_shader(fragment_vs);
glass_vertex_shader(glass_vs);

/* --- one layer -------------------------------------------------------------------------------- */

/* clang-format off */
fragment_programs(fragment_first, float4, MODEL_2_0, .writes_depth = true)
/* clang-format on */
{
    odepth(depth);
    return source;
}

fragment_programs(fragment_next, float4, MODEL_2_0, .writes_depth = true, .may_discard = true,
                  .local_reads = 1 << 0)
{
    discard(depth <= gp_load_local(0).x);
    odepth(depth);
    return source;
}

/* --- two layers ------------------------------------------------------------------------------- */

typedef struct DualRange {
    float4 near, far;
} DualRange;

typedef struct DualTargets {
    float4 near, far, front, back;
} DualTargets;

fragment_programs(dual_first, DualRange, MODEL_2_0)
{
    return (DualRange){ sp4(neg(depth)), sp4(depth) };
}

/* The fragment that is both ends at once is the front's alone. */
fragment_programs(dual_next, DualTargets, MODEL_3_0, .may_discard = true, .local_reads = 3)
{
    flt near = neg(gp_load_local(0).x), far = gp_load_local(1).x;
    msk is_front = depth == near, is_back = (msk)(depth == far) & ~is_front;
    msk is_between = (msk)(depth > near) & (msk)(depth < far);
    flt none = bcast(DUAL_NONE);
    discard((msk)(depth < near) | (msk)(depth > far));
    return (DualTargets){ sp4(sel(is_between, neg(depth), none)), sp4(sel(is_between, depth, none)),
                          sel(is_front, source, sp4(none)), sel(is_back, source, sp4(none)) };
}

typedef struct DualLayers {
    float4 front, back;
} DualLayers;

clip_vertex_shader(dual_layers_vs, NoUniforms);

GP_INLINE float4 layer_or_nothing(float4 layer)
{
    return sel(layer.w > DUAL_NONE, layer, vec4(0, 0, 0, 1));
}

pixel_shader_targets(dual_layers_ps, NoUniforms, NoVarying, DualLayers)
{
    out->front = layer_or_nothing(gp_load_local(0));
    out->back = layer_or_nothing(gp_load_local(1));
}

program(dual_layers_program, dual_layers_vs, dual_layers_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 3)
