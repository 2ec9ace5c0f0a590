#include "shaders_c/warp/ground.h"
#include "shaders_c/common/vertices_shared.h"

typedef struct GroundVertex {
    float3 position;
    float2 texcoord;
} GroundVertex;

typedef struct GroundVarying {
    float2 uv;
    float4 place; /* in the map, projective */
} GroundVarying;

vertex_shader(ground_vs, GroundUniforms, GroundVertex, UvVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->uv = in->texcoord;
}

pixel_shader(ground_ps, GroundUniforms, UvVarying)
{
    float3 light = add(u3(c->ambient), u3(c->direct));
    return rgba(mul(xyz(texld(0, in->uv)), light), 1);
}

vertex_shader(ground_shadowed_vs, GroundUniforms, GroundVertex, GroundVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->uv = in->texcoord;
    out->place = m4x4(in->position, c->map);
}

pixel_shader(ground_shadowed_ps, GroundUniforms, GroundVarying)
{
    float3 light = mad(u3(c->direct), texldp(1, in->place).x, u3(c->ambient));
    return rgba(mul(xyz(texld(0, in->uv)), light), 1);
}

program(ground_program, ground_vs, ground_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE } }, .samplers = 1 << 0)
program(ground_shadowed_program, ground_shadowed_vs, ground_shadowed_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE }, { "place", 4, GP_PERSPECTIVE } },
        .samplers = 1 << 0 | 1 << 1)
