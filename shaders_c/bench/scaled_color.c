/* The colours of the vertices, alpha included, times a number: what fill rates are measured with.
 * Positions are in clip space already. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/scaled_color.h"

vertex_shader(scaled_color_vs, ScaledColorUniforms, ColoredVertex, ColorVarying)
{
    *position = rgba(in->position, 1);
    out->color = in->color;
}

pixel_shader(scaled_color_ps, ScaledColorUniforms, ColorVarying)
{
    return mul(in->color, c->scale);
}

program(scaled_color_program, scaled_color_vs, scaled_color_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 4 } },
        .varyings = { { "color", 4, GP_PERSPECTIVE } })
