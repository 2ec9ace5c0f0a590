/* Texture 0 over the whole target. Positions are in clip space already: draw a quad. */
#include "pipeline/shader.h"
#include "shaders_c/common/blit.h"

typedef struct Vertex {
    float3 position;
    float2 texcoord;
} Vertex;

typedef struct Varying {
    float2 uv;
} Varying;

vertex_shader(blit_vs, BlitUniforms, Vertex, Varying)
{
    *position = rgba(in->position, 1);
    out->uv = in->texcoord;
}

pixel_shader(blit_ps, BlitUniforms, Varying)
{
    return texld(0, in->uv);
}

program(blit_program, blit_vs, blit_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE } }, .samplers = 1 << 0)
