#include "shaders_c/warp/cylinder.h"
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/warp/detail_shared.h"
#include "shaders_c/warp/light_shared.h"

typedef struct CylinderVertex {
    float3 turn;  /* cosine, sine, height */
    float3 texel; /* u, v, depth */
} CylinderVertex;

typedef struct WarpedVarying {
    float2 uv;
    flt nearness;
} WarpedVarying;

typedef struct LitWarpedVarying {
    WarpedVarying warped;
    float3 world;
} LitWarpedVarying;

typedef struct StraightVarying {
    float2 uv;
    float3 world;
} StraightVarying;

typedef struct WarpedTargets {
    float4 color, nearness;
} WarpedTargets;

/* Before the turn: x towards azimuth 0. */
GP_INLINE float3 cylinder_place(const CylinderUniforms *c, const CylinderVertex *in, flt depth)
{
    flt out = c->radius - depth;
    return vec3(out * in->turn.x, in->turn.z, out * in->turn.y);
}

/* The paper's B, and where the line from the eye to it meets the plane x = radius. */
GP_INLINE float4 warp(const CylinderUniforms *c, float3 place, const CylinderVertex *in,
                      WarpedVarying *out)
{
    flt x = place.x * c->turn[0] + place.z * c->turn[1];
    flt z = place.z * c->turn[0] - place.x * c->turn[1];
    flt share = rcp(c->eye[0] - x) * (c->eye[0] - c->radius);
    flt up = mad(place.y - c->eye[1], share, bcast(c->eye[1]));
    out->uv = vec2(in->texel.x, in->texel.y);
    out->nearness = share;
    return vec4(mad(z * share, bcast(c->window[0]), c->window[1]),
                mad(up, bcast(c->window[2]), c->window[3]), 0.5f, 1);
}

GP_INLINE float3 color_at(GpInvocation *gp, float2 uv)
{
    return xyz(texld(0, uv));
}

GP_INLINE float3 lit_at(GpInvocation *gp, const CylinderUniforms *c, float2 uv, float3 world)
{
    float3 color = color_at(gp, uv), normal = mad(xyz(texld(1, uv)), 2, sp3(bcast(-1)));
    return warp_lit(&c->light, color, normal, world);
}

/* --- within the plane ------------------------------------------------------------------------- */

GP_INLINE float4 warp_lit_vertex(const CylinderUniforms *c, const CylinderVertex *in, flt depth,
                                 LitWarpedVarying *out)
{
    float3 place = cylinder_place(c, in, depth);
    out->world = m4x3(place, c->to_world);
    return warp(c, place, in, &out->warped);
}

/* Its depth under small relief. */
GP_INLINE flt relief_depth(GpInvocation *gp, const CylinderUniforms *c, const CylinderVertex *in)
{
    return warp_detailed(gp, &c->detail, vec2(in->texel.x, in->texel.y), in->texel.z);
}

vertex_shader(cylinder_vs, CylinderUniforms, CylinderVertex, WarpedVarying)
{
    *position = warp(c, cylinder_place(c, in, in->texel.z), in, out);
}

vertex_shader(cylinder_detail_vs, CylinderUniforms, CylinderVertex, WarpedVarying)
{
    *position = warp(c, cylinder_place(c, in, relief_depth(gp, c, in)), in, out);
}

vertex_shader(cylinder_lit_vs, CylinderUniforms, CylinderVertex, LitWarpedVarying)
{
    *position = warp_lit_vertex(c, in, in->texel.z, out);
}

vertex_shader(cylinder_detail_lit_vs, CylinderUniforms, CylinderVertex, LitWarpedVarying)
{
    *position = warp_lit_vertex(c, in, relief_depth(gp, c, in), out);
}

pixel_shader_targets(cylinder_ps, CylinderUniforms, WarpedVarying, WarpedTargets)
{
    (void)c;
    out->color = rgba(color_at(gp, in->uv), 1);
    out->nearness = sp4(in->nearness);
}

pixel_shader_targets(cylinder_lit_ps, CylinderUniforms, LitWarpedVarying, WarpedTargets)
{
    out->color = rgba(lit_at(gp, c, in->warped.uv, in->world), 1);
    out->nearness = sp4(in->warped.nearness);
}

/* --- straight --------------------------------------------------------------------------------- */

GP_INLINE float4 straight_vertex(const CylinderUniforms *c, const CylinderVertex *in, flt depth,
                                 StraightVarying *out)
{
    float3 place = cylinder_place(c, in, depth);
    out->uv = vec2(in->texel.x, in->texel.y);
    out->world = m4x3(place, c->to_world);
    return m4x4(place, c->to_clip);
}

vertex_shader(cylinder_straight_vs, CylinderUniforms, CylinderVertex, StraightVarying)
{
    *position = straight_vertex(c, in, in->texel.z, out);
}

vertex_shader(cylinder_straight_detail_vs, CylinderUniforms, CylinderVertex, StraightVarying)
{
    *position = straight_vertex(c, in, relief_depth(gp, c, in), out);
}

pixel_shader(cylinder_straight_ps, CylinderUniforms, StraightVarying)
{
    (void)c;
    return rgba(color_at(gp, in->uv), 1);
}

pixel_shader(cylinder_straight_lit_ps, CylinderUniforms, StraightVarying)
{
    return rgba(lit_at(gp, c, in->uv, in->world), 1);
}

/* --- the plane as a picture ------------------------------------------------------------------- */

typedef struct PlaneVertex {
    float3 position;
    float2 texcoord;
} PlaneVertex;

typedef struct PlaneVarying {
    float2 uv;
    float2 depth; /* z and w in clip space */
} PlaneVarying;

vertex_shader(cylinder_plane_vs, CylinderPlaneUniforms, PlaneVertex, PlaneVarying)
{
    float4 clip = m4x4(in->position, c->mvp);
    *position = clip;
    out->uv = in->texcoord;
    out->depth = vec2(clip.z, clip.w);
}

/* A point X beyond the plane's point P is C + (P - C) / nearness, from the eye C; so is its clip
 * space. Filters mix colours with emptiness, which they are freed of by alpha. */
pixel_shader(cylinder_plane_ps, CylinderPlaneUniforms, PlaneVarying)
{
    float4 color = texld(0, in->uv);
    flt nearness = texld(1, in->uv).x;
    flt z = mad(nearness - 1.0f, bcast(c->eye_depth), in->depth.x);
    discard((msk)(color.w < 0.5f) | (msk)(nearness < 1e-6f));
    odepth(z / in->depth.y);
    return rgba(mul(xyz(color), rcp(color.w)), 1);
}

/* clang-format off */
#define CYLINDER_INPUTS .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 3 } }
#define WARPED_VARYINGS { "uv", 2, GP_LINEAR_SCREEN }, { "nearness", 1, GP_LINEAR_SCREEN }
#define LIT_WARPED_VARYINGS WARPED_VARYINGS, { "world", 3, GP_LINEAR_SCREEN }
#define RELIEF_SAMPLER .vertex_samplers = 1 << WARP_DETAIL_SLOT
#define STRAIGHT_VARYINGS { "uv", 2, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE }
/* clang-format on */

program(cylinder_program, cylinder_vs, cylinder_ps, MODEL_2_0, CYLINDER_INPUTS,
        .varyings = { WARPED_VARYINGS }, .samplers = 1 << 0)
program(cylinder_lit_program, cylinder_lit_vs, cylinder_lit_ps, MODEL_2_0, CYLINDER_INPUTS,
        .varyings = { LIT_WARPED_VARYINGS }, .samplers = 1 << 0 | 1 << 1)
program(cylinder_straight_program, cylinder_straight_vs, cylinder_straight_ps, MODEL_2_0,
        CYLINDER_INPUTS, .varyings = { STRAIGHT_VARYINGS }, .samplers = 1 << 0)
program(cylinder_straight_lit_program, cylinder_straight_vs, cylinder_straight_lit_ps, MODEL_2_0,
        CYLINDER_INPUTS, .varyings = { STRAIGHT_VARYINGS }, .samplers = 1 << 0 | 1 << 1)
program(cylinder_detail_program, cylinder_detail_vs, cylinder_ps, MODEL_3_0, CYLINDER_INPUTS,
        .varyings = { WARPED_VARYINGS }, .samplers = 1 << 0, RELIEF_SAMPLER)
program(cylinder_detail_lit_program, cylinder_detail_lit_vs, cylinder_lit_ps, MODEL_3_0,
        CYLINDER_INPUTS, .varyings = { LIT_WARPED_VARYINGS }, .samplers = 1 << 0 | 1 << 1,
        RELIEF_SAMPLER)
program(cylinder_straight_detail_program, cylinder_straight_detail_vs, cylinder_straight_ps,
        MODEL_3_0, CYLINDER_INPUTS, .varyings = { STRAIGHT_VARYINGS }, .samplers = 1 << 0,
        RELIEF_SAMPLER)
program(cylinder_straight_detail_lit_program, cylinder_straight_detail_vs, cylinder_straight_lit_ps,
        MODEL_3_0, CYLINDER_INPUTS, .varyings = { STRAIGHT_VARYINGS }, .samplers = 1 << 0 | 1 << 1,
        RELIEF_SAMPLER)
program(cylinder_plane_program, cylinder_plane_vs, cylinder_plane_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE }, { "depth", 2, GP_PERSPECTIVE } },
        .samplers = 1 << 0 | 1 << 1, .may_discard = true, .writes_depth = true)
