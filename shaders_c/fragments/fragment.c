/* Fragments counted, and put over a picture. */
#include "shaders_c/fragments/fragment_shared.h"

vertex_shader(fragment_count_vs, FragmentUniforms, PointVertex, NoVarying)
{
    *position = m4x4(in->position, c->mvp);
}

pixel_shader(fragment_count_ps, FragmentUniforms, NoVarying)
{
    return sp4(bcast(1));
}

program(fragment_count_program, fragment_count_vs, fragment_count_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } })

clip_vertex_shader(fragment_over_vs, NoUniforms);

pixel_shader(fragment_over_ps, NoUniforms, NoVarying)
{
    float4 layers = gp_load_local(0);
    return rgba(xyz(layers), 1.0f - layers.w);
}

program(fragment_over_program, fragment_over_vs, fragment_over_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 1 << 0)
