/* A surfel's Gaussian on the screen. For shader files only. */
#ifndef SHADERS_POINTS_SPLAT_SHARED_H
#define SHADERS_POINTS_SPLAT_SHARED_H

#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/points/splat.h"

#define HALF_LOG2_E 0.72134752044448170368f

/* What is needed of a surfel's disc. */
typedef struct DiscVertex {
    float3 position;
    flt radius;
    float3 normal;
} DiscVertex;

typedef struct SurfelVertex {
    float3 position;
    flt radius;
    float3 normal;
    float4 color; /* its alpha squared is how much of the area 2 pi radius^2 it stands for */
} SurfelVertex;

/* clang-format off */
#define DISC_INPUTS   { GP_POSITION, 4 }, { GP_NORMAL, 3 }
#define SURFEL_INPUTS DISC_INPUTS, { GP_COLOR, 4 }
/* clang-format on */

/* Where a surfel lies before the eye: x right, y down, z forward. */
typedef struct EyeSurfel {
    float3 position, normal;
    float2 slope; /* x/z, y/z */
    flt facing;   /* cosine of normal and line of sight, times the line's length at distance 1 */
    flt radius;   /* pixels */
    msk drawn;
} EyeSurfel;

GP_INLINE flt eye_row(const float row[4], float3 v)
{
    return dp3(v, u3(row));
}

GP_INLINE EyeSurfel surfel_before_eye(const SplatUniforms *c, float3 position, float3 normal,
                                      flt radius)
{
    EyeSurfel eye;
    eye.position = vec3(eye_row(c->eye[0], position) + c->eye[0][3],
                        eye_row(c->eye[1], position) + c->eye[1][3],
                        eye_row(c->eye[2], position) + c->eye[2][3]);
    eye.normal =
        vec3(eye_row(c->eye[0], normal), eye_row(c->eye[1], normal), eye_row(c->eye[2], normal));
    flt per_z = rcp(max(eye.position.z, c->nearest));
    eye.slope = vec2(eye.position.x * per_z, eye.position.y * per_z);
    eye.facing = -(eye.normal.x * eye.slope.x + eye.normal.y * eye.slope.y + eye.normal.z);
    eye.radius = radius * per_z * c->focal;
    eye.drawn = (msk)(eye.position.z >= c->nearest) & (msk)(eye.facing > c->facing);
    return eye;
}

/* Clip position of a surfel, at any depth. */
GP_INLINE float4 surfel_clip_at(const SplatUniforms *c, const EyeSurfel *eye, flt depth)
{
    const float3 p = eye->position;
    float4 clip =
        vec4(p.x * (c->focal * c->ndc[0]), -p.y * (c->focal * c->ndc[1]), depth * p.z, p.z);
    return sel(eye->drawn, clip, vec4(0, 0, -1, 1)); /* by depth: points beside the picture show */
}

/* The same of a place on the line of sight, so far behind the surfel. */
GP_INLINE float4 surfel_clip(const SplatUniforms *c, const EyeSurfel *eye, flt behind)
{
    return surfel_clip_at(c, eye, c->depth[0] + c->depth[1] * rcp(eye->position.z + behind));
}

/* A Gaussian on the screen. */
typedef struct Splat {
    flt xx, xy, yy; /* V, square pixels */
    flt det;        /* of V */
} Splat;

/* in  square: of the Gaussian's standard deviation, or of a disc's radius; square pixels
 *     low_pass: h */
GP_INLINE Splat surfel_splat(const EyeSurfel *eye, flt square, float low_pass)
{
    Splat splat;
    float2 s = eye->slope;
    flt a = eye->normal.x - eye->normal.z * s.x, b = eye->normal.y - eye->normal.z * s.y;
    flt xx = square * max(mad(s.x, s.x, 1) - a * a, 0);
    flt yy = square * max(mad(s.y, s.y, 1) - b * b, 0);
    flt own = square * eye->facing;
    splat.xy = square * (s.x * s.y - a * b);
    splat.det = mad(own, own, (xx + yy + low_pass) * low_pass);
    splat.xx = xx + low_pass;
    splat.yy = yy + low_pass;
    return splat;
}

/* From 0 to 1: how much of a disc lies where its points are uneven, and larger than a few pixels.
 * Areas then do not tell how much of a pixel is covered, but the discs, which close such a
 * surface. */
GP_INLINE flt surfel_sparse(const EyeSurfel *eye, flt share)
{
    return sat((0.5f - share) * 5) * sat((eye->radius - 2.0f) * 0.25f);
}

/* The standard deviation of a surfel's Gaussian, in its radii. Where points are dense for their
 * radius, their own area says how wide a Gaussian they need: not wider than one of `spread` in a
 * surfel that has as much area as its disc shows. */
GP_INLINE flt surfel_deviation(const SplatUniforms *c, const EyeSurfel *eye, flt share)
{
    return max(min(share * SPLAT_PER_SHARE, 1), surfel_sparse(eye, share) * 0.65f) * c->spread;
}

/* The one that is drawn. */
GP_INLINE Splat surfel_filtered(const SplatUniforms *c, const EyeSurfel *eye, flt share)
{
    flt deviation = eye->radius * surfel_deviation(c, eye, share);
    return surfel_splat(eye, deviation * deviation, c->low_pass);
}

/* Side of the square that holds a splat up to its cut. */
GP_INLINE flt splat_side(const Splat *splat, float cut)
{
    return sqrt_(max(splat->xx, splat->yy)) * (2 * cut);
}

/* V^-1 as xx, 2 xy, yy, such that 2^-(xx dx^2 + 2 xy dx dy + yy dy^2) is the Gaussian. */
GP_INLINE float3 splat_conic(const Splat *splat)
{
    flt per_det = rcp(splat->det) * HALF_LOG2_E;
    return vec3(splat->yy * per_det, splat->xy * per_det * -2, splat->xx * per_det);
}

/* Pixel whose centre is a surfel's, as vpos counts. */
GP_INLINE float2 surfel_pixel(const SplatUniforms *c, const EyeSurfel *eye)
{
    return vec2(mad(eye->slope.x, c->focal, c->centre[0] - 0.5f),
                mad(eye->slope.y, c->focal, c->centre[1] - 0.5f));
}

/* The exponent of a splat at a pixel. */
GP_INLINE flt splat_exponent(float3 conic, float2 place, float2 pixel)
{
    flt x = pixel.x - place.x, y = pixel.y - place.y;
    return x * mad(conic.x, x, conic.y * y) + conic.z * (y * y);
}

GP_INLINE float3 surfel_color(const SplatUniforms *c, const SurfelVertex *in)
{
    if (c->waves <= 0)
        return xyz(in->color);
    return vec3(mad(sin_(in->position.x * c->waves), 0.5f, 0.5f),
                mad(sin_(in->position.y * c->waves), 0.5f, 0.5f),
                mad(sin_(in->position.z * c->waves), 0.5f, 0.5f));
}

/* --- visibility ------------------------------------------------------------------------------- */

/* Depths lie behind the surface, so that all splats of one surface pass, and no other does: as far
 * as a plane through the surfel goes back over its radius, and over the pixel's filter. */
GP_INLINE flt behind_surface(const SplatUniforms *c, const EyeSurfel *eye, flt radius)
{
    flt steep = rcp(max(abs_(eye->facing), 0.1f)); /* what is steeper is seen edge on */
    flt filter = eye->position.z * (sqrt_(bcast(c->low_pass)) * rcp(bcast(c->focal)));
    return mad(filter, steep, radius) * c->epsilon;
}

#define THINNEST 0.1f /* half the width of a disc that is seen edge on, pixels */

/* A surfel's disc, as a splat that ends at one standard deviation. */
GP_INLINE Splat surfel_disc(const EyeSurfel *eye)
{
    return surfel_splat(eye, eye->radius * eye->radius, THINNEST * THINNEST);
}

typedef struct DiscVarying {
    float3 conic;
    float2 place;
} DiscVarying;

GP_INLINE void splat_disc_vertex(const SplatUniforms *c, const DiscVertex *in, float4 *position,
                                 DiscVarying *out, flt *point_size)
{
    EyeSurfel eye = surfel_before_eye(c, in->position, in->normal, in->radius);
    Splat disc = surfel_disc(&eye);
    *position = surfel_clip(c, &eye, behind_surface(c, &eye, in->radius));
    *point_size = splat_side(&disc, 1);
    out->conic = splat_conic(&disc);
    out->place = surfel_pixel(c, &eye);
}

#define discard_outside_disc(in)                                                                   \
    discard(splat_exponent((in)->conic, (in)->place, vpos()) > HALF_LOG2_E)

/* --- attributes ------------------------------------------------------------------------------- */

/* For who looks at a splat's filter. */
GP_INLINE void watch_splat(const EyeSurfel *eye, const Splat *splat, flt height)
{
    watch("facing", eye->facing);
    watch("radius", eye->radius);
    watch("V", vec3(splat->xx, splat->xy, splat->yy));
    watch("height", height);
}

/* What a splat's weight is in its centre. */
GP_INLINE flt splat_height(flt share, const EyeSurfel *eye, const Splat *splat)
{
    const float closing = 1.7f;     /* over 3/4 at the rim of a disc, of 0.8 radii's deviation */
    flt side = share * eye->radius; /* what r^2 is on the screen, times the share */
    return max(side * side * abs_(eye->facing) * rsq(splat->det),
               surfel_sparse(eye, share) * closing);
}

typedef struct SplatColorVarying {
    float3 conic;
    float2 place;
    float4 color; /* times height, and height */
} SplatColorVarying;

/* Of a splat at its surfel, but for the clip position. */
GP_INLINE void splat_color_vertex(const SplatUniforms *c, const SurfelVertex *in,
                                  const EyeSurfel *eye, SplatColorVarying *out, flt *point_size)
{
    Splat splat = surfel_filtered(c, eye, in->color.w);
    flt height = splat_height(in->color.w, eye, &splat);
    watch_splat(eye, &splat, height);
    *point_size = splat_side(&splat, c->cut);
    out->conic = splat_conic(&splat);
    out->place = surfel_pixel(c, eye);
    out->color = rgba(mul(surfel_color(c, in), height), height);
}

/* The same with the surfel's place. */
GP_INLINE void splat_color_point(const SplatUniforms *c, const SurfelVertex *in, float4 *position,
                                 SplatColorVarying *out, flt *point_size)
{
    EyeSurfel eye = surfel_before_eye(c, in->position, in->normal, in->radius);
    *position = surfel_clip(c, &eye, bcast(0));
    splat_color_vertex(c, in, &eye, out, point_size);
}

/* A splat's Gaussian at a pixel, of height 1; pixels beyond its cut are discarded. */
#define splat_weight(c, conic, place) splat_weight_at(gp, c, conic, place)
GP_INLINE flt splat_weight_at(GpInvocation *gp, const SplatUniforms *c, float3 conic, float2 place)
{
    flt exponent = splat_exponent(conic, place, vpos()), weight = exp_(-exponent);
    watch("exponent", exponent);
    watch("weight", weight);
    discard(exponent > c->cut * c->cut * HALF_LOG2_E);
    return weight;
}

typedef struct SplatSurfaceVarying {
    float3 conic;
    float2 place;
    float4 color;   /* times height, and height */
    float4 surface; /* normal and distance, times height */
} SplatSurfaceVarying;

typedef struct SplatTargets {
    float4 color, surface;
} SplatTargets;

GP_INLINE void splat_surface_vertex(const SplatUniforms *c, const SurfelVertex *in,
                                    const EyeSurfel *eye, SplatSurfaceVarying *out, flt *point_size)
{
    Splat splat = surfel_filtered(c, eye, in->color.w);
    flt height = splat_height(in->color.w, eye, &splat);
    watch_splat(eye, &splat, height);
    /* two-sided surfels are lit from the side that is seen */
    flt turned = sel(eye->facing < 0.0f, -height, height);
    *point_size = splat_side(&splat, c->cut);
    out->conic = splat_conic(&splat);
    out->place = surfel_pixel(c, eye);
    out->color = rgba(mul(surfel_color(c, in), height), height);
    out->surface = rgba(mul(in->normal, turned), eye->position.z * height);
}

GP_INLINE void splat_surface_point(const SplatUniforms *c, const SurfelVertex *in, float4 *position,
                                   SplatSurfaceVarying *out, flt *point_size)
{
    EyeSurfel eye = surfel_before_eye(c, in->position, in->normal, in->radius);
    *position = surfel_clip(c, &eye, bcast(0));
    splat_surface_vertex(c, in, &eye, out, point_size);
}

/* clang-format off */
#define SPLAT_VISIBILITY_DECLARATIONS                                                              \
    MODEL_3_0, .varyings = { { "conic", 3, GP_FLAT }, { "place", 2, GP_FLAT } },                   \
    .may_discard = true, .uses_pixel = true, .writes_point_size = true
#define SPLAT_COLOR_DECLARATIONS                                                                   \
    MODEL_3_0,                                                                                     \
    .varyings = { { "conic", 3, GP_FLAT }, { "place", 2, GP_FLAT }, { "color", 4, GP_FLAT } },     \
    .may_discard = true, .uses_pixel = true, .writes_point_size = true
#define SPLAT_SURFACE_DECLARATIONS                                                                 \
    MODEL_3_0,                                                                                     \
    .varyings = { { "conic", 3, GP_FLAT }, { "place", 2, GP_FLAT }, { "color", 4, GP_FLAT },       \
                  { "surface", 4, GP_FLAT } },                                                     \
    .may_discard = true, .uses_pixel = true, .writes_point_size = true
/* clang-format on */

#endif
