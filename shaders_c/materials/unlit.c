/* One colour for every pixel. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/unlit.h"

vertex_shader(unlit_vs, UnlitUniforms, PointVertex, NoVarying)
{
    *position = m4x4(in->position, c->mvp);
}

pixel_shader(unlit_ps, UnlitUniforms, NoVarying)
{
    return u4(c->color);
}

program(unlit_program, unlit_vs, unlit_ps, MODEL_2_0, .inputs = { { GP_POSITION, 3 } })
