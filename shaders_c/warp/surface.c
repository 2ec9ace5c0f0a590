#define GP_SHADER_AT_ONCE 4
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
    float3 place; /* in the map */
} ShadowedVarying;

typedef struct DistantVarying {
    float2 uv;
    float3 place;
} DistantVarying;

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

/* --- lit -------------------------------------------------------------------------------------- */

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

/* --- under a shadow map ----------------------------------------------------------------------- */

GP_INLINE float3 map_place(const float map[3][4], float3 world)
{
    float4 at = vec4(world.x, world.y, world.z, 1);
    return vec3(dp4(at, u4(map[0])), dp4(at, u4(map[1])), dp4(at, u4(map[2])));
}

vertex_shader(surface_shadowed_vs, SurfaceUniforms, PlacedVertex, ShadowedVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->lit.uv = in->texcoord;
    out->lit.world = in->position;
    out->place = map_place(c->map, in->position);
}

pixel_shader(surface_shadowed_ps, SurfaceUniforms, ShadowedVarying)
{
    float2 uv = in->lit.uv;
    float3 color = xyz(texld(0, uv)), normal = xyz(texld(1, uv));
    normal = mad(normal, 2, sp3(bcast(-1)));
    float3 lit = warp_lit(&c->light, color, normal, in->lit.world);
    return rgba(lrp(texld(2, in->place).x, lit, mul(color, u3(c->light.ambient))), 1);
}

vertex_shader(surface_distant_vs, SurfaceDistantUniforms, PlacedVertex, UvVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->uv = in->texcoord;
}

vertex_shader(surface_distant_shadowed_vs, SurfaceDistantUniforms, PlacedVertex, DistantVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->uv = in->texcoord;
    out->place = map_place(c->map, in->position);
}

/* A colour under light of which so much comes through. */
GP_INLINE float4 distant_lit(GpInvocation *gp, const SurfaceDistantUniforms *c, float2 uv,
                             flt through)
{
    float3 color = xyz(texld(0, uv)), N = nrm(mad(xyz(texld(1, uv)), 2, sp3(bcast(-1))));
    flt highlight = pow_(max(dp3(N, u3(c->half_way)), 0), bcast(c->shininess)) * c->specular;
    float3 direct = mul(u3(c->color), mad(color, max(dp3(N, u3(c->source)), 0), sp3(highlight)));
    return rgba(mad(direct, through, mul(color, u3(c->ambient))), 1);
}

pixel_shader(surface_distant_ps, SurfaceDistantUniforms, UvVarying)
{
    return distant_lit(gp, c, in->uv, bcast(1));
}

pixel_shader(surface_distant_shadowed_ps, SurfaceDistantUniforms, DistantVarying)
{
    return distant_lit(gp, c, in->uv, texld(2, in->place).x);
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
        .varyings = { LIT_VARYINGS, { "place", 3, GP_PERSPECTIVE } },
        .samplers = 1 << 0 | 1 << 1 | 1 << 2)
program(surface_distant_program, surface_distant_vs, surface_distant_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE } }, .samplers = 1 << 0 | 1 << 1)
program(surface_distant_shadowed_program, surface_distant_shadowed_vs, surface_distant_shadowed_ps,
        MODEL_2_0, .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE }, { "place", 3, GP_PERSPECTIVE } },
        .samplers = 1 << 0 | 1 << 1 | 1 << 2)
