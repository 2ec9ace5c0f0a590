#include "shaders_c/warp/planar.h"

#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/warp/detail_shared.h"
#include "shaders_c/warp/light_shared.h"

typedef struct WarpedVarying {
    float2 uv;
    flt nearness;
} WarpedVarying;

typedef struct LitVarying {
    WarpedVarying warped;
    float3 world;
} LitVarying;

typedef struct WarpedTargets {
    float4 color, nearness;
} WarpedTargets;

GP_INLINE flt planar_detailed(GpInvocation *gp, const PlanarUniforms *c,
                              const TexturedQuadVertex *in)
{
    return warp_detailed(gp, &c->detail, in->texcoord, in->position.z);
}

/* Inside the plane. */
GP_INLINE float4 planar_warp(GpInvocation *gp, const PlanarUniforms *c,
                             const TexturedQuadVertex *in, flt depth, WarpedVarying *out)
{
    flt k =
        texldl(PLANAR_TABLE_SLOT, vec4(mad(depth, bcast(c->table[0]), c->table[1]), 0.5f, 0, 0)).x;
    flt s = mad(depth, bcast(c->spread[0]), c->spread[1]) * (1.0f - k * c->eye_w);
    float4 place = vec4(in->position.x * s, in->position.y * s, s, k);
    out->uv = in->texcoord;
    out->nearness = 1.0f - k * c->per_k;
    return vec4(dp4(place, u4(c->window[0])) + c->shift[0],
                dp4(place, u4(c->window[1])) + c->shift[1], 0.5f, 1);
}

GP_INLINE float4 planar_lit(GpInvocation *gp, const PlanarUniforms *c, const TexturedQuadVertex *in,
                            flt depth, LitVarying *out)
{
    flt s = mad(depth, bcast(c->spread[0]), c->spread[1]);
    float4 place = vec4(in->position.x * s, in->position.y * s, depth, 1);
    out->world = vec3(dp4(place, u4(c->to_world[0])), dp4(place, u4(c->to_world[1])),
                      dp4(place, u4(c->to_world[2])));
    return planar_warp(gp, c, in, depth, &out->warped);
}

vertex_shader(planar_vs, PlanarUniforms, TexturedQuadVertex, WarpedVarying)
{
    *position = planar_warp(gp, c, in, in->position.z, out);
}

vertex_shader(planar_detail_vs, PlanarUniforms, TexturedQuadVertex, WarpedVarying)
{
    *position = planar_warp(gp, c, in, planar_detailed(gp, c, in), out);
}

vertex_shader(planar_lit_vs, PlanarUniforms, TexturedQuadVertex, LitVarying)
{
    *position = planar_lit(gp, c, in, in->position.z, out);
}

vertex_shader(planar_detail_lit_vs, PlanarUniforms, TexturedQuadVertex, LitVarying)
{
    *position = planar_lit(gp, c, in, planar_detailed(gp, c, in), out);
}

pixel_shader_targets(planar_ps, PlanarUniforms, WarpedVarying, WarpedTargets)
{
    (void)c;
    out->color = rgba(xyz(texld(0, in->uv)), 1);
    out->nearness = sp4(in->nearness);
}

/* The view vector is the eye's place less the point's, as in the paper, in the world's axes. */
pixel_shader_targets(planar_lit_ps, PlanarUniforms, LitVarying, WarpedTargets)
{
    float3 color = xyz(texld(0, in->warped.uv));
    float3 normal = mad(xyz(texld(1, in->warped.uv)), 2.0f, bcast(-1));
    out->color = rgba(warp_lit(&c->light, color, normal, in->world), 1);
    out->nearness = sp4(in->warped.nearness);
}

/* clang-format off */
#define PLANAR_INPUTS .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } }
#define WARPED_VARYINGS { "uv", 2, GP_LINEAR_SCREEN }, { "nearness", 1, GP_LINEAR_SCREEN }
#define PLANAR_DECLARATIONS                                                                        \
    MODEL_3_0, PLANAR_INPUTS, .varyings = { WARPED_VARYINGS }, .samplers = 1 << 0
#define LIT_DECLARATIONS                                                                           \
    MODEL_3_0, PLANAR_INPUTS, .varyings = { WARPED_VARYINGS, { "world", 3, GP_LINEAR_SCREEN } },   \
    .samplers = 1 << 0 | 1 << 1
#define TABLE        .vertex_samplers = 1 << PLANAR_TABLE_SLOT
#define DETAIL_TABLE .vertex_samplers = 1 << PLANAR_TABLE_SLOT | 1 << WARP_DETAIL_SLOT

program(planar_program, planar_vs, planar_ps, PLANAR_DECLARATIONS, TABLE)
program(planar_lit_program, planar_lit_vs, planar_lit_ps, LIT_DECLARATIONS, TABLE)
program(planar_detail_program, planar_detail_vs, planar_ps, PLANAR_DECLARATIONS, DETAIL_TABLE)
program(planar_detail_lit_program, planar_detail_lit_vs, planar_lit_ps, LIT_DECLARATIONS,
        DETAIL_TABLE)
/* clang-format on */
