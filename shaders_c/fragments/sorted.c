#include "shaders_c/fragments/sorted.h"

#include "shaders_c/fragments/fragment_shared.h"

vertex_shader(sorted_vs, FragmentUniforms, FragmentVertex, ColorVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->color = rgba(mul(xyz(in->color), in->color.w), in->color.w);
}

pixel_shader(sorted_ps, FragmentUniforms, ColorVarying)
{
    return in->color;
}

program(sorted_program, sorted_vs, sorted_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 4 } }, .varyings = { { "color", 4, GP_FLAT } })

glass_vertex_shader(sorted_glass_vs);

pixel_shader(sorted_glass_ps, FragmentUniforms, GlassVarying)
{
    return glass_source(c, in);
}

program(sorted_glass_program, sorted_glass_vs, sorted_glass_ps, GLASS_DECLARATIONS, MODEL_2_0)
