/* Textures that decide: a dependent read, and alpha that discards. */
#include "pipeline/shader.h"
#include "shaders_c/bench/lookup.h"

typedef struct Vertex {
    float3 position;
    float2 texcoord;
} Vertex;

typedef struct Varying {
    float2 uv;
} Varying;

vertex_shader(lookup_vs, LookupUniforms, Vertex, Varying)
{
    *position = rgba(in->position, 1);
    out->uv = in->texcoord;
}

pixel_shader(lookup_ps, LookupUniforms, Varying)
{
    float4 place = texld(0, in->uv);
    return texldl(1, vec4(place.x, place.y, 0, 0));
}

pixel_shader(cut_out_ps, LookupUniforms, Varying)
{
    float4 color = texld(0, in->uv);
    discard(color.w < 0.5f);
    return color;
}

program(lookup_program, lookup_vs, lookup_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE } }, .samplers = 1 << 0 | 1 << 1)

program(cut_out_program, lookup_vs, cut_out_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE } }, .samplers = 1 << 0, .may_discard = true)
