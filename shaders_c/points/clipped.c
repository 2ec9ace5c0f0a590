#include "shaders_c/points/clipped.h"

#include "shaders_c/points/splat_shared.h"

typedef struct ClippedVertex {
    SurfelVertex surfel;
    float4 one, other;
} ClippedVertex;

/* clang-format off */
#define CLIPPED_INPUTS SURFEL_INPUTS, { GP_TEXCOORD0, 4 }, { GP_TEXCOORD1, 4 }
/* clang-format on */

/* --- lines ------------------------------------------------------------------------------------ */

/* Of the plane through the eye and a line of the surfel: in pixels, what is inwards is above 0. */
GP_INLINE float2 clip_line(const SplatUniforms *c, const EyeSurfel *eye, float3 inward)
{
    float3 m =
        vec3(eye_row(c->eye[0], inward), eye_row(c->eye[1], inward), eye_row(c->eye[2], inward));
    float3 n = eye->normal;
    float3 along = vec3(n.y * m.z - n.z * m.y, n.z * m.x - n.x * m.z, n.x * m.y - n.y * m.x);
    flt x = eye->slope.y * along.z - along.y, y = along.x - eye->slope.x * along.z;
    flt per = rsq(max(x * x + y * y, 1e-20f));
    per = sel(eye->facing < 0.0f, -per, per);
    return vec2(x * per, y * per);
}

typedef struct Lines {
    float4 both; /* x and y of either line's normal */
    flt side;    /* 1: inwards of both, -1: of either */
} Lines;

GP_INLINE Lines clip_lines(const SplatUniforms *c, const EyeSurfel *eye, const ClippedVertex *in)
{
    float2 one = clip_line(c, eye, xyz(in->one)), other = clip_line(c, eye, xyz(in->other));
    return (Lines){ vec4(one.x, one.y, other.x, other.y), in->one.w };
}

/* How much of a pixel lies inwards. */
GP_INLINE flt inside(float4 lines, flt side, float2 place, float2 pixel)
{
    flt x = pixel.x - place.x, y = pixel.y - place.y;
    flt one = mad(lines.x, x, lines.y * y) * side, other = mad(lines.z, x, lines.w * y) * side;
    return min(max(mad(min(one, other), side, 0.5f), 0), 1);
}

/* --- visibility ------------------------------------------------------------------------------- */

typedef struct ClippedDiscVarying {
    float3 conic;
    float2 place;
    float4 lines;
    flt side;
} ClippedDiscVarying;

vertex_shader(clipped_visibility_vs, SplatUniforms, ClippedVertex, ClippedDiscVarying)
{
    EyeSurfel eye = surfel_before_eye(c, in->surfel.position, in->surfel.normal, in->surfel.radius);
    Splat disc = surfel_disc(&eye);
    Lines lines = clip_lines(c, &eye, in);
    *position = surfel_clip(c, &eye, behind_surface(c, &eye, in->surfel.radius));
    *point_size = splat_side(&disc, 1);
    out->conic = splat_conic(&disc);
    out->place = surfel_pixel(c, &eye);
    out->lines = lines.both;
    out->side = lines.side;
}

pixel_shader(clipped_visibility_ps, SplatUniforms, ClippedDiscVarying)
{
    discard(splat_exponent(in->conic, in->place, vpos()) > HALF_LOG2_E);
    discard(inside(in->lines, in->side, in->place, vpos()) <= 0.0f);
    return sp4(bcast(0));
}

program(clipped_visibility_program, clipped_visibility_vs, clipped_visibility_ps, MODEL_3_0,
        .inputs = { CLIPPED_INPUTS },
        .varyings = { { "conic", 3, GP_FLAT },
                      { "place", 2, GP_FLAT },
                      { "lines", 4, GP_FLAT },
                      { "side", 1, GP_FLAT } },
        .may_discard = true, .uses_pixel = true, .writes_point_size = true)

/* --- attributes ------------------------------------------------------------------------------- */

/* As if there were surfels of the same plane beyond the lines. */
GP_INLINE SurfelVertex filled(const ClippedVertex *in)
{
    SurfelVertex surfel = in->surfel;
    surfel.color.w = min(surfel.color.w * in->other.w, 1);
    return surfel;
}

typedef struct ClippedColorVarying {
    SplatColorVarying splat;
    float4 lines;
    flt side;
} ClippedColorVarying;

vertex_shader(clipped_color_vs, SplatUniforms, ClippedVertex, ClippedColorVarying)
{
    SurfelVertex surfel = filled(in);
    EyeSurfel eye = surfel_before_eye(c, surfel.position, surfel.normal, surfel.radius);
    Lines lines = clip_lines(c, &eye, in);
    *position = surfel_clip(c, &eye, bcast(0));
    splat_color_vertex(c, &surfel, &eye, &out->splat, point_size);
    out->lines = lines.both;
    out->side = lines.side;
}

pixel_shader(clipped_color_ps, SplatUniforms, ClippedColorVarying)
{
    flt weight = splat_weight(c, in->splat.conic, in->splat.place);
    flt share = inside(in->lines, in->side, in->splat.place, vpos());
    return mul(in->splat.color, weight * share);
}

program(clipped_color_program, clipped_color_vs, clipped_color_ps, MODEL_3_0,
        .inputs = { CLIPPED_INPUTS },
        .varyings = { { "conic", 3, GP_FLAT },
                      { "place", 2, GP_FLAT },
                      { "color", 4, GP_FLAT },
                      { "lines", 4, GP_FLAT },
                      { "side", 1, GP_FLAT } },
        .may_discard = true, .uses_pixel = true, .writes_point_size = true)

typedef struct ClippedSurfaceVarying {
    SplatSurfaceVarying splat;
    float4 lines;
    flt side;
} ClippedSurfaceVarying;

vertex_shader(clipped_surface_vs, SplatUniforms, ClippedVertex, ClippedSurfaceVarying)
{
    SurfelVertex surfel = filled(in);
    EyeSurfel eye = surfel_before_eye(c, surfel.position, surfel.normal, surfel.radius);
    Lines lines = clip_lines(c, &eye, in);
    *position = surfel_clip(c, &eye, bcast(0));
    splat_surface_vertex(c, &surfel, &eye, &out->splat, point_size);
    out->lines = lines.both;
    out->side = lines.side;
}

pixel_shader_targets(clipped_surface_ps, SplatUniforms, ClippedSurfaceVarying, SplatTargets)
{
    flt weight = splat_weight(c, in->splat.conic, in->splat.place);
    flt share = weight * inside(in->lines, in->side, in->splat.place, vpos());
    out->color = mul(in->splat.color, share);
    out->surface = mul(in->splat.surface, share);
}

program(clipped_surface_program, clipped_surface_vs, clipped_surface_ps, MODEL_3_0,
        .inputs = { CLIPPED_INPUTS },
        .varyings = { { "conic", 3, GP_FLAT },
                      { "place", 2, GP_FLAT },
                      { "color", 4, GP_FLAT },
                      { "surface", 4, GP_FLAT },
                      { "lines", 4, GP_FLAT },
                      { "side", 1, GP_FLAT } },
        .may_discard = true, .uses_pixel = true, .writes_point_size = true)
