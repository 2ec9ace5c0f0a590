/* The colours of the vertices, alpha included. */
#include "pipeline/shader.h"
#include "shaders_c/materials/vertex_color.h"

typedef struct Vertex {
    float3 position;
    float4 color;
} Vertex;

typedef struct Varying {
    float4 color;
} Varying;

vertex_shader(vertex_color_vs, VertexColorUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->mvp);
    out->color = in->color;
}

pixel_shader(vertex_color_ps, VertexColorUniforms, Varying)
{
    return in->color;
}

program(vertex_color_program, vertex_color_vs, vertex_color_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 4 } },
        .varyings = { { "color", 4, GP_PERSPECTIVE } })
