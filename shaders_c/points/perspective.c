#include "shaders_c/points/perspective.h"

#include "shaders_c/points/splat_shared.h"

/* Splats whose far side is seen under the horizon have no end: they are cut where they are so many
 * times as large as their affine projection. */
#define LARGEST 4.0f

/* g, of a pixel. */
GP_INLINE float2 plane_tilt(const SplatUniforms *c, const EyeSurfel *eye)
{
    flt facing = sel(eye->facing < 0.0f, min(eye->facing, -0.01f), max(eye->facing, 0.01f));
    flt per = -rcp(facing * c->focal);
    return vec2(eye->normal.x * per, eye->normal.y * per);
}

/* How much larger the exact splat is: with m^2 = g^T V g and |d| by V, |d| <= cut (1 + m |d|). */
GP_INLINE flt growth(const Splat *splat, float2 tilt, float cut)
{
    flt square =
        tilt.x * mad(splat->xx, tilt.x, splat->xy * tilt.y * 2) + splat->yy * tilt.y * tilt.y;
    return rcp(max(1.0f - sqrt_(max(square, 0)) * cut, 1 / LARGEST));
}

/* 1 / k at a pixel. */
GP_INLINE flt nearness(float2 tilt, float2 place, float2 pixel)
{
    return mad(tilt.x, pixel.x - place.x, mad(tilt.y, pixel.y - place.y, 1));
}

/* The exponent of a splat at a pixel; what is not in front of the eye is far outside. */
GP_INLINE flt exact_exponent(float3 conic, float2 place, float2 pixel, flt nearness)
{
    flt k = rcp(max(nearness, 1 / (LARGEST * LARGEST)));
    return splat_exponent(conic, place, pixel) * (k * k);
}

/* --- visibility ------------------------------------------------------------------------------- */

typedef struct ExactDiscVarying {
    float3 conic;
    float2 place, tilt, depth; /* of the centre, and how far behind */
} ExactDiscVarying;

vertex_shader(perspective_visibility_vs, SplatUniforms, DiscVertex, ExactDiscVarying)
{
    EyeSurfel eye = surfel_before_eye(c, in->position, in->normal, in->radius);
    Splat disc = surfel_disc(&eye);
    flt behind = behind_surface(c, &eye, in->radius);
    *position = surfel_clip(c, &eye, behind);
    out->conic = splat_conic(&disc);
    out->place = surfel_pixel(c, &eye);
    out->tilt = plane_tilt(c, &eye);
    out->depth = vec2(eye.position.z, behind);
    *point_size = splat_side(&disc, 1) * growth(&disc, out->tilt, 1);
}

pixel_shader(perspective_visibility_ps, SplatUniforms, ExactDiscVarying)
{
    flt near = nearness(in->tilt, in->place, vpos());
    discard(exact_exponent(in->conic, in->place, vpos(), near) > HALF_LOG2_E);
    odepth(c->depth[0] +
           c->depth[1] * (near * rcp(max(mad(in->depth.y, near, in->depth.x), c->nearest))));
    return sp4(bcast(0));
}

program(perspective_visibility_program, perspective_visibility_vs, perspective_visibility_ps,
        MODEL_3_0, .inputs = { DISC_INPUTS },
        .varyings = { { "conic", 3, GP_FLAT },
                      { "place", 2, GP_FLAT },
                      { "tilt", 2, GP_FLAT },
                      { "depth", 2, GP_FLAT } },
        .may_discard = true, .writes_depth = true, .uses_pixel = true, .writes_point_size = true)

/* --- attributes ------------------------------------------------------------------------------- */

typedef struct ExactColorVarying {
    SplatColorVarying splat;
    float2 tilt;
} ExactColorVarying;

typedef struct ExactSurfaceVarying {
    SplatSurfaceVarying splat;
    float2 tilt;
} ExactSurfaceVarying;

vertex_shader(perspective_color_vs, SplatUniforms, SurfelVertex, ExactColorVarying)
{
    EyeSurfel eye = surfel_before_eye(c, in->position, in->normal, in->radius);
    Splat splat = surfel_filtered(c, &eye, in->color.w);
    *position = surfel_clip(c, &eye, bcast(0));
    splat_color_vertex(c, in, &eye, &out->splat, point_size);
    out->tilt = plane_tilt(c, &eye);
    *point_size = *point_size * growth(&splat, out->tilt, c->cut);
}

pixel_shader(perspective_color_ps, SplatUniforms, ExactColorVarying)
{
    flt near = nearness(in->tilt, in->splat.place, vpos());
    flt exponent = exact_exponent(in->splat.conic, in->splat.place, vpos(), near);
    discard(exponent > c->cut * c->cut * HALF_LOG2_E);
    return mul(in->splat.color, exp_(-exponent));
}

program(perspective_color_program, perspective_color_vs, perspective_color_ps, MODEL_3_0,
        .inputs = { SURFEL_INPUTS },
        .varyings = { { "conic", 3, GP_FLAT },
                      { "place", 2, GP_FLAT },
                      { "color", 4, GP_FLAT },
                      { "tilt", 2, GP_FLAT } },
        .may_discard = true, .uses_pixel = true, .writes_point_size = true)

vertex_shader(perspective_surface_vs, SplatUniforms, SurfelVertex, ExactSurfaceVarying)
{
    EyeSurfel eye = surfel_before_eye(c, in->position, in->normal, in->radius);
    Splat splat = surfel_filtered(c, &eye, in->color.w);
    *position = surfel_clip(c, &eye, bcast(0));
    splat_surface_vertex(c, in, &eye, &out->splat, point_size);
    out->tilt = plane_tilt(c, &eye);
    *point_size = *point_size * growth(&splat, out->tilt, c->cut);
}

/* Distances are those of the plane. */
pixel_shader_targets(perspective_surface_ps, SplatUniforms, ExactSurfaceVarying, SplatTargets)
{
    flt near = nearness(in->tilt, in->splat.place, vpos());
    flt exponent = exact_exponent(in->splat.conic, in->splat.place, vpos(), near);
    discard(exponent > c->cut * c->cut * HALF_LOG2_E);
    flt weight = exp_(-exponent);
    out->color = mul(in->splat.color, weight);
    out->surface = mul(in->splat.surface, weight);
    out->surface.w = out->surface.w * rcp(max(near, 1 / LARGEST));
}

program(perspective_surface_program, perspective_surface_vs, perspective_surface_ps, MODEL_3_0,
        .inputs = { SURFEL_INPUTS },
        .varyings = { { "conic", 3, GP_FLAT },
                      { "place", 2, GP_FLAT },
                      { "color", 4, GP_FLAT },
                      { "surface", 4, GP_FLAT },
                      { "tilt", 2, GP_FLAT } },
        .may_discard = true, .uses_pixel = true, .writes_point_size = true)
