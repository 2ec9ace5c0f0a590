/* The colours of the vertices, alpha included, times a number: what fill rates are measured with.
 * Positions are in clip space already. */
#include "pipeline/shader.h"
#include "shaders_c/bench/scaled_color.h"

typedef struct Vertex {
    float3 position;
    float4 color;
} Vertex;

typedef struct Varying {
    float4 color;
} Varying;

vertex_shader(scaled_color_vs, ScaledColorUniforms, Vertex, Varying)
{
    *position = rgba(in->position, 1);
    out->color = in->color;
}

pixel_shader(scaled_color_ps, ScaledColorUniforms, Varying)
{
    return mul(in->color, c->scale);
}

program(scaled_color_program, scaled_color_vs, scaled_color_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 4 } },
        .varyings = { { "color", 4, GP_PERSPECTIVE } })
