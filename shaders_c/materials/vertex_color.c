/* The colours of the vertices, alpha included. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/vertex_color.h"

vertex_shader(vertex_color_vs, VertexColorUniforms, ColoredVertex, ColorVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->color = in->color;
}

pixel_shader(vertex_color_ps, VertexColorUniforms, ColorVarying)
{
    return in->color;
}

program(vertex_color_program, vertex_color_vs, vertex_color_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 4 } },
        .varyings = { { "color", 4, GP_PERSPECTIVE } })
