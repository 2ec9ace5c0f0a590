#include "shaders_c/warp/direct.h"

#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/warp/detail_shared.h"
#include "shaders_c/warp/light_shared.h"

/* Places on the picture are no linear function of places in the world where rays meet in an eye;
 * times the depth they are. */
typedef struct DirectVarying {
    float3 texel; /* s u, s v, s */
} DirectVarying;

typedef struct LitVarying {
    DirectVarying direct;
    float3 world;
} LitVarying;

/* in  depth: in->position.z, or what detail makes of it */
GP_INLINE float4 direct_place(const DirectUniforms *c, const TexturedQuadVertex *in, flt depth,
                              DirectVarying *out)
{
    flt spread = mad(depth, bcast(c->spread[0]), c->spread[1]);
    out->texel = vec3(in->texcoord.x * spread, in->texcoord.y * spread, spread);
    return vec4(in->position.x * spread, in->position.y * spread, depth, 1);
}

GP_INLINE flt detailed(GpInvocation *gp, const DirectUniforms *c, const TexturedQuadVertex *in)
{
    return warp_detailed(gp, &c->detail, in->texcoord, in->position.z);
}

GP_INLINE float4 lit_place(const DirectUniforms *c, float4 place, LitVarying *out)
{
    out->world = vec3(dp4(place, u4(c->to_world[0])), dp4(place, u4(c->to_world[1])),
                      dp4(place, u4(c->to_world[2])));
    return m4x4(place, c->to_clip);
}

vertex_shader(direct_vs, DirectUniforms, TexturedQuadVertex, DirectVarying)
{
    *position = m4x4(direct_place(c, in, in->position.z, out), c->to_clip);
}

vertex_shader(direct_detail_vs, DirectUniforms, TexturedQuadVertex, DirectVarying)
{
    *position = m4x4(direct_place(c, in, detailed(gp, c, in), out), c->to_clip);
}

vertex_shader(direct_lit_vs, DirectUniforms, TexturedQuadVertex, LitVarying)
{
    *position = lit_place(c, direct_place(c, in, in->position.z, &out->direct), out);
}

vertex_shader(direct_detail_lit_vs, DirectUniforms, TexturedQuadVertex, LitVarying)
{
    *position = lit_place(c, direct_place(c, in, detailed(gp, c, in), &out->direct), out);
}

GP_INLINE float2 direct_texel(const DirectVarying *in)
{
    flt per = rcp(in->texel.z);
    return vec2(in->texel.x * per, in->texel.y * per);
}

pixel_shader(direct_ps, DirectUniforms, DirectVarying)
{
    return texld(0, direct_texel(in));
}

pixel_shader(direct_lit_ps, DirectUniforms, LitVarying)
{
    float2 uv = direct_texel(&in->direct);
    float4 color = texld(0, uv);
    float3 normal = mad(xyz(texld(1, uv)), 2.0f, bcast(-1));
    return rgba(warp_lit(&c->light, xyz(color), normal, in->world), color.w);
}

/* clang-format off */
#define DIRECT_INPUTS .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } }
#define DIRECT_DECLARATIONS                                                                        \
    DIRECT_INPUTS, .varyings = { { "texel", 3, GP_PERSPECTIVE } }, .samplers = 1 << 0
#define LIT_DECLARATIONS                                                                           \
    DIRECT_INPUTS, .samplers = 1 << 0 | 1 << 1,                                                    \
    .varyings = { { "texel", 3, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE } }
#define DETAIL .vertex_samplers = 1 << WARP_DETAIL_SLOT

program(direct_program, direct_vs, direct_ps, MODEL_2_0, DIRECT_DECLARATIONS)
program(direct_lit_program, direct_lit_vs, direct_lit_ps, MODEL_2_0, LIT_DECLARATIONS)
program(direct_detail_program, direct_detail_vs, direct_ps, MODEL_3_0, DIRECT_DECLARATIONS, DETAIL)
program(direct_detail_lit_program, direct_detail_lit_vs, direct_lit_ps, MODEL_3_0, LIT_DECLARATIONS,
        DETAIL)
/* clang-format on */
