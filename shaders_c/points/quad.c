#include "shaders_c/points/quad.h"

#include "shaders_c/points/splat_shared.h"

typedef struct CornerVertex {
    SurfelVertex surfel;
    float2 corner;
} CornerVertex;

/* clang-format off */
#define CORNER_INPUTS SURFEL_INPUTS, { GP_TEXCOORD0, 2 }
/* clang-format on */

/* Tangents of a surfel before the eye.
 * source Duff et al., "Building an orthonormal basis, revisited", JCGT 6(1), 2017 */
typedef struct Tangents {
    float3 s, t;
} Tangents;

GP_INLINE Tangents plane_tangents(float3 n)
{
    Tangents made;
    flt sign = sel(n.z >= 0.0f, bcast(1), bcast(-1));
    flt a = -rcp(sign + n.z), b = n.x * n.y * a;
    made.s = vec3(mad(sign * n.x * n.x, a, 1), sign * b, -sign * n.x);
    made.t = vec3(b, mad(n.y * n.y, a, sign), -n.y);
    return made;
}

/* A Gaussian on the surfel's plane: its axes, of one standard deviation's length, and what is under
 * the root of its determinant. */
typedef struct Axes {
    float3 longer, shorter;
    flt area;
} Axes;

/* in   square: of the standard deviation of the surfel's own, world; low_pass: square pixels */
GP_INLINE Axes plane_axes(const SplatUniforms *c, const EyeSurfel *eye, flt square, float low_pass)
{
    const Tangents plane = plane_tangents(eye->normal);
    flt scale = rcp(max(eye->position.z, c->nearest)) * c->focal;
    flt jsx = plane.s.x - plane.s.z * eye->slope.x, jsy = plane.s.y - plane.s.z * eye->slope.y;
    flt jtx = plane.t.x - plane.t.z * eye->slope.x, jty = plane.t.y - plane.t.z * eye->slope.y;
    flt thin = max(eye->facing * eye->facing, 0.0025f) * (scale * scale); /* seen edge on */
    flt filter = rcp(thin) * low_pass;
    flt ss = mad(mad(jtx, jtx, jty * jty), filter, square);
    flt tt = mad(mad(jsx, jsx, jsy * jsy), filter, square);
    flt st = -mad(jsx, jtx, jsy * jty) * filter;

    flt half_sum = (ss + tt) * 0.5f, half = (ss - tt) * 0.5f;
    flt spread = sqrt_(mad(half, half, st * st));
    flt det = max(mad(ss, tt, -(st * st)), square * square);
    flt longest = half_sum + spread;
    /* of the two forms of the eigenvector the one that does not cancel */
    float2 along = sel(half >= 0.0f, vec2(half + spread, st), vec2(st, spread - half));
    along = sel(spread > 0.0f, nrm(along), vec2(1, 0));

    float3 axis = add(mul(plane.s, along.x), mul(plane.t, along.y));
    float3 other = sub(mul(plane.t, along.x), mul(plane.s, along.y));
    Axes axes;
    axes.longer = mul(axis, sqrt_(longest));
    axes.shorter = mul(other, sqrt_(det * rcp(longest)));
    axes.area = sqrt_(det);
    return axes;
}

/* Clip position of a corner, so many standard deviations out, so far behind. */
GP_INLINE float4 corner_clip(const SplatUniforms *c, const EyeSurfel *eye, const Axes *axes,
                             float2 at, flt behind)
{
    EyeSurfel corner = *eye;
    corner.position = add(eye->position, add(mul(axes->longer, at.x), mul(axes->shorter, at.y)));
    const float3 p = corner.position;
    /* of what is behind the eye the depth does not matter: it is clipped */
    flt depth = mad(p.z, c->depth[0], c->depth[1] * (p.z * rcp(max(p.z + behind, c->nearest))));
    float4 clip = vec4(p.x * (c->focal * c->ndc[0]), -p.y * (c->focal * c->ndc[1]), depth, p.z);
    return sel(eye->drawn, clip, vec4(2, 2, 0, 1));
}

/* The exponent at a place, in standard deviations. */
GP_INLINE flt place_exponent(float2 place)
{
    return dp2(place, place) * HALF_LOG2_E;
}

/* --- visibility ------------------------------------------------------------------------------- */

typedef struct QuadDiscVarying {
    float2 place;
} QuadDiscVarying;

vertex_shader(quad_visibility_vs, SplatUniforms, CornerVertex, QuadDiscVarying)
{
    const SurfelVertex *surfel = &in->surfel;
    EyeSurfel eye = surfel_before_eye(c, surfel->position, surfel->normal, surfel->radius);
    Axes axes = plane_axes(c, &eye, surfel->radius * surfel->radius, 0);
    *position = corner_clip(c, &eye, &axes, in->corner, behind_surface(c, &eye, surfel->radius));
    out->place = in->corner;
}

pixel_shader(quad_visibility_ps, SplatUniforms, QuadDiscVarying)
{
    discard(place_exponent(in->place) > HALF_LOG2_E);
    return sp4(bcast(0));
}

program(quad_visibility_program, quad_visibility_vs, quad_visibility_ps, MODEL_3_0,
        .inputs = { CORNER_INPUTS }, .varyings = { { "place", 2 } }, .may_discard = true)

/* --- attributes ------------------------------------------------------------------------------- */

typedef struct QuadVarying {
    float2 place;
    float4 color, surface; /* times height */
} QuadVarying;

vertex_shader(quad_vs, SplatUniforms, CornerVertex, QuadVarying)
{
    const SurfelVertex *surfel = &in->surfel;
    EyeSurfel eye = surfel_before_eye(c, surfel->position, surfel->normal, surfel->radius);
    flt deviation = surfel->radius * surfel_deviation(c, &eye, surfel->color.w);
    Axes axes = plane_axes(c, &eye, deviation * deviation, c->low_pass);
    flt side = surfel->radius * surfel->color.w;
    flt height = side * side * rcp(axes.area);
    flt turned = sel(eye.facing < 0.0f, -height, height);
    out->place = mul(in->corner, c->cut);
    *position = corner_clip(c, &eye, &axes, out->place, bcast(0));
    out->color = rgba(mul(surfel_color(c, surfel), height), height);
    out->surface = rgba(mul(surfel->normal, turned), eye.position.z * height);
}

pixel_shader(quad_color_ps, SplatUniforms, QuadVarying)
{
    flt exponent = place_exponent(in->place);
    discard(exponent > c->cut * c->cut * HALF_LOG2_E);
    return mul(in->color, exp_(-exponent));
}

pixel_shader_targets(quad_surface_ps, SplatUniforms, QuadVarying, SplatTargets)
{
    flt exponent = place_exponent(in->place);
    discard(exponent > c->cut * c->cut * HALF_LOG2_E);
    flt weight = exp_(-exponent);
    out->color = mul(in->color, weight);
    out->surface = mul(in->surface, weight);
}

/* clang-format off */
#define QUAD_DECLARATIONS                                                                          \
    MODEL_3_0, .inputs = { CORNER_INPUTS },                                                        \
    .varyings = { { "place", 2 }, { "color", 4, GP_FLAT }, { "surface", 4, GP_FLAT } },            \
    .may_discard = true
/* clang-format on */

program(quad_color_program, quad_vs, quad_color_ps, QUAD_DECLARATIONS)
program(quad_surface_program, quad_vs, quad_surface_ps, QUAD_DECLARATIONS)
