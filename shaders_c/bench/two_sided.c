/* Blinn-Phong lighting (Blinn, "Models of light reflection for computer synthesized pictures",
 * SIGGRAPH 1977) of surfaces whose sides look alike: the normal is turned towards the eye. Shadow
 * maps are Williams', "Casting curved shadows on curved surfaces", SIGGRAPH 1978; comparing before
 * filtering is Reeves, Salesin and Cook's, "Rendering antialiased shadows with depth maps",
 * SIGGRAPH 1987. */
#define GP_SHADER_AT_ONCE 4 /* three square roots, one after the other, and a power */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/two_sided.h"

typedef struct ShadowVarying {
    SurfaceVarying surface;
    float4 light_clip;
} ShadowVarying;

/* --- lighting --------------------------------------------------------------------------------- */

/* lit: the share of the light that arrives. */
GP_INLINE float4 shade(const TwoSidedUniforms *c, const SurfaceVarying *surface, flt lit)
{
    float3 L = u3(c->light);
    float3 N = nrm(surface->normal), V = nrm(sub(u3(c->eye), surface->world));
    N = sel(dp3(N, V) < 0.0f, neg(N), N);
    float3 H = nrm(add(L, V));

    flt diffuse = max(dp3(N, L), 0);
    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess));
    float3 color = mul(u3(c->albedo), lit * diffuse + c->ambient);
    return rgba(add(color, lit * c->specular * highlight), 1);
}

GP_INLINE float4 transform(const TwoSidedUniforms *c, const MeshVertex *in, SurfaceVarying *out)
{
    out->normal = m3x3(in->normal, c->model);
    out->world = m4x3(in->position, c->model);
    return m4x4(in->position, c->mvp);
}

vertex_shader(two_sided_vs, TwoSidedUniforms, MeshVertex, SurfaceVarying)
{
    *position = transform(c, in, out);
}

pixel_shader(two_sided_ps, TwoSidedUniforms, SurfaceVarying)
{
    return shade(c, in, bcast(1));
}

program(two_sided_program, two_sided_vs, two_sided_ps, MODEL_2_0, .inputs = { MESH_INPUTS },
        .varyings = { SURFACE_VARYINGS })

/* --- shadows ---------------------------------------------------------------------------------- */

vertex_shader(shadow_vs, TwoSidedUniforms, MeshVertex, ShadowVarying)
{
    *position = transform(c, in, &out->surface);
    out->light_clip = m4x4(out->surface.world, c->light_clip);
}

/* Where a pixel is in the shadow map: u, v, and its depth as the map would have it, less the
 * bias. */
GP_INLINE float3 map_place(const TwoSidedUniforms *c, float4 light_clip)
{
    flt x = light_clip.x / light_clip.w, y = light_clip.y / light_clip.w;
    flt depth = light_clip.z / light_clip.w;
    return vec3(x * 0.5f + 0.5f, y * -0.5f + 0.5f, depth - c->bias);
}

/* The map has one level, so texldl reads what texld would, without asking the neighbours. */
pixel_shader_begin(compare_ps, TwoSidedUniforms, ShadowVarying, flt)
{
    float3 place = map_place(c, in->light_clip);
    return texldl(0, rgba(place, 0)).x;
}

pixel_shader_end(compare_ps, TwoSidedUniforms, ShadowVarying, flt)
{
    return shade(c, &in->surface, *begun);
}

pixel_shader_begin(nearest_ps, TwoSidedUniforms, ShadowVarying, flt)
{
    float3 place = map_place(c, in->light_clip);
    flt stored = texldl(0, vec4(place.x, place.y, 0, 0)).x;
    return sge(stored, place.z);
}

pixel_shader_end(nearest_ps, TwoSidedUniforms, ShadowVarying, flt)
{
    return shade(c, &in->surface, *begun);
}

/* 1 where the depth stored in the texel with its centre at (u, v) is not before `depth`, else 0. */
GP_INLINE flt tap(GpInvocation *gp, flt u, flt v, flt depth)
{
    return sge(texldl(0, vec4(u, v, 0, 0)).x, depth);
}

pixel_shader_begin(pcf_ps, TwoSidedUniforms, ShadowVarying, flt)
{
    float3 place = map_place(c, in->light_clip);
    flt size = bcast(c->map_size), step = rcp(size), depth = place.z;
    flt s = place.x * size - 0.5f, t = place.y * size - 0.5f;
    flt left = (floor_(s) + 0.5f) * step, top = (floor_(t) + 0.5f) * step;
    flt right = left + step, bottom = top + step;

    flt upper = lrp(frc(s), tap(gp, right, top, depth), tap(gp, left, top, depth));
    flt lower = lrp(frc(s), tap(gp, right, bottom, depth), tap(gp, left, bottom, depth));
    return lrp(frc(t), lower, upper);
}

pixel_shader_end(pcf_ps, TwoSidedUniforms, ShadowVarying, flt)
{
    return shade(c, &in->surface, *begun);
}

/* clang-format off */
#define SHADOW_DECLARATIONS                                                                        \
    MODEL_3_0, .inputs = { MESH_INPUTS },                                                          \
    .varyings = { SURFACE_VARYINGS, { "light_clip", 4, GP_PERSPECTIVE } }, .samplers = 1 << 0
/* clang-format on */

program(two_sided_compare_program, shadow_vs, compare_ps, SHADOW_DECLARATIONS)
program(two_sided_nearest_program, shadow_vs, nearest_ps, SHADOW_DECLARATIONS)
program(two_sided_pcf_program, shadow_vs, pcf_ps, SHADOW_DECLARATIONS)
