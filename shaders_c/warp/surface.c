#define GP_SHADER_PAIRS
#include "shaders_c/warp/surface.h"
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/warp/light_shared.h"

typedef struct PlacedVertex {
    float3 position;
    float2 texcoord;
} PlacedVertex;

typedef struct LitVarying {
    float2 uv;
    float3 world;
} LitVarying;

typedef struct ShadowedVarying {
    LitVarying lit;
    float4 place; /* in the map, projective */
} ShadowedVarying;

vertex_shader(surface_vs, SurfaceUniforms, PlacedVertex, UvVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->uv = in->texcoord;
}

pixel_shader(surface_ps, SurfaceUniforms, UvVarying)
{
    (void)c;
    return rgba(xyz(texld(0, in->uv)), 1);
}

/* --- lit --------------------------------------------------------------------------------------- */

vertex_shader(surface_lit_vs, SurfaceUniforms, PlacedVertex, LitVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->uv = in->texcoord;
    out->world = in->position;
}

pixel_shader(surface_lit_ps, SurfaceUniforms, LitVarying)
{
    float3 color = xyz(texld(0, in->uv)), normal = xyz(texld(1, in->uv));
    normal = mad(normal, 2, sp3(bcast(-1)));
    return rgba(warp_lit(&c->light, color, normal, in->world), 1);
}

vertex_shader(surface_shadowed_vs, SurfaceUniforms, PlacedVertex, ShadowedVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->lit.uv = in->texcoord;
    out->lit.world = in->position;
    out->place = m4x4(in->position, c->map);
}

pixel_shader(surface_shadowed_ps, SurfaceUniforms, ShadowedVarying)
{
    float2 uv = in->lit.uv;
    float3 color = xyz(texld(0, uv)), normal = xyz(texld(1, uv));
    normal = mad(normal, 2, sp3(bcast(-1)));
    float3 lit = warp_lit(&c->light, color, normal, in->lit.world);
    return rgba(lrp(texldp(2, in->place).x, lit, mul(color, u3(c->light.ambient))), 1);
}

/* clang-format off */
#define LIT_VARYINGS { "uv", 2, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE }
/* clang-format on */

program(surface_program, surface_vs, surface_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE } }, .samplers = 1 << 0)
program(surface_lit_program, surface_lit_vs, surface_lit_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } }, .varyings = { LIT_VARYINGS },
        .samplers = 1 << 0 | 1 << 1)
program(surface_shadowed_program, surface_shadowed_vs, surface_shadowed_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { LIT_VARYINGS, { "place", 4, GP_PERSPECTIVE } },
        .samplers = 1 << 0 | 1 << 1 | 1 << 2)
