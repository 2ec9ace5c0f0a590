/* Texture 0 over the whole target. Positions are in clip space already: draw a quad. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/common/blit.h"

vertex_shader(blit_vs, NoUniforms, TexturedQuadVertex, UvVarying)
{
    *position = textured_quad(in, out);
}

pixel_shader(blit_ps, NoUniforms, UvVarying)
{
    return texld(0, in->uv);
}

program(blit_program, blit_vs, blit_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        TEXTURED_QUAD_DECLARATIONS, .samplers = 1 << 0)
