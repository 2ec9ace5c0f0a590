/* Texture 0 over the whole target. Positions are in clip space already: draw a quad. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/common/blit.h"

textured_quad_vertex_shader(blit_vs, NoUniforms);

pixel_shader(blit_ps, NoUniforms, UvVarying)
{
    return texld(0, in->uv);
}

program(blit_program, blit_vs, blit_ps, MODEL_2_0, TEXTURED_QUAD_DECLARATIONS, .samplers = 1 << 0)
