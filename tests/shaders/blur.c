/* The mean of three texels of texture 0: one step of a box blur, along rows or columns. */
#include <glasspipe/shader.h>
#include "tests/shaders/blur.h"

typedef struct Vertex {
    float3 position;
} Vertex;

typedef struct Varying {
    float2 uv;
} Varying;

vertex_shader(blur_vs, BlurUniforms, Vertex, Varying)
{
    *position = rgba(in->position, 1);
    out->uv = vec2(in->position.x * 0.5f + 0.5f, 0.5f - in->position.y * 0.5f);
}

pixel_shader(blur_ps, BlurUniforms, Varying)
{
    float2 step = u2(c->step);
    float4 sum = add(texld(0, sub(in->uv, step)), texld(0, add(in->uv, step)));
    return mul(add(sum, texld(0, in->uv)), 1.0f / 3);
}

program(blur_program, blur_vs, blur_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = { { GP_POSITION, 3 } }, .varyings = { { "uv", 2, GP_PERSPECTIVE } },
        .samplers = 1 << 0)
