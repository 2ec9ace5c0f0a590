#include "shaders_c/points/splat_shared.h"

/* --- visibility ------------------------------------------------------------------------------- */

typedef struct DiscVarying {
    float3 conic;
    float2 place;
} DiscVarying;

vertex_shader(splat_visibility_vs, SplatUniforms, SurfelVertex, DiscVarying)
{
    EyeSurfel eye = surfel_before_eye(c, in->position, in->normal, in->radius);
    Splat disc = surfel_disc(&eye);
    *position = surfel_clip(c, &eye, behind_surface(c, &eye, in->radius));
    *point_size = splat_side(&disc, 1);
    out->conic = splat_conic(&disc);
    out->place = surfel_pixel(c, &eye);
}

pixel_shader(splat_visibility_ps, SplatUniforms, DiscVarying)
{
    discard(splat_exponent(in->conic, in->place, vpos()) > HALF_LOG2_E);
    return sp4(bcast(0));
}

program(splat_visibility_program, splat_visibility_vs, splat_visibility_ps, MODEL_3_0,
        .inputs = { SURFEL_INPUTS },
        .varyings = { { "conic", 3, GP_FLAT }, { "place", 2, GP_FLAT } }, .may_discard = true,
        .uses_pixel = true, .writes_point_size = true)

/* --- attributes ------------------------------------------------------------------------------- */

vertex_shader(splat_color_vs, SplatUniforms, SurfelVertex, SplatColorVarying)
{
    EyeSurfel eye = surfel_before_eye(c, in->position, in->normal, in->radius);
    *position = surfel_clip(c, &eye, bcast(0));
    splat_color_vertex(c, in, &eye, out, point_size);
}

pixel_shader(splat_color_ps, SplatUniforms, SplatColorVarying)
{
    return mul(in->color, splat_weight(c, in->conic, in->place));
}

program(splat_color_program, splat_color_vs, splat_color_ps, SPLAT_COLOR_DECLARATIONS)

vertex_shader(splat_surface_vs, SplatUniforms, SurfelVertex, SplatSurfaceVarying)
{
    EyeSurfel eye = surfel_before_eye(c, in->position, in->normal, in->radius);
    *position = surfel_clip(c, &eye, bcast(0));
    splat_surface_vertex(c, in, &eye, out, point_size);
}

pixel_shader_targets(splat_surface_ps, SplatUniforms, SplatSurfaceVarying, SplatTargets)
{
    flt weight = splat_weight(c, in->conic, in->place);
    out->color = mul(in->color, weight);
    out->surface = mul(in->surface, weight);
}

program(splat_surface_program, splat_surface_vs, splat_surface_ps, SPLAT_SURFACE_DECLARATIONS)
