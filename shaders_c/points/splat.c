#include "shaders_c/points/splat_shared.h"

/* --- visibility ------------------------------------------------------------------------------- */

vertex_shader(splat_visibility_vs, SplatUniforms, DiscVertex, DiscVarying)
{
    splat_disc_vertex(c, in, position, out, point_size);
}

pixel_shader(splat_visibility_ps, SplatUniforms, DiscVarying)
{
    discard_outside_disc(in);
    return sp4(bcast(0));
}

program(splat_visibility_program, splat_visibility_vs, splat_visibility_ps,
        SPLAT_VISIBILITY_DECLARATIONS, .inputs = { DISC_INPUTS })

/* --- attributes ------------------------------------------------------------------------------- */

vertex_shader(splat_color_vs, SplatUniforms, SurfelVertex, SplatColorVarying)
{
    splat_color_point(c, in, position, out, point_size);
}

pixel_shader(splat_color_ps, SplatUniforms, SplatColorVarying)
{
    return mul(in->color, splat_weight(c, in->conic, in->place));
}

program(splat_color_program, splat_color_vs, splat_color_ps, SPLAT_COLOR_DECLARATIONS,
        .inputs = { SURFEL_INPUTS })

vertex_shader(splat_surface_vs, SplatUniforms, SurfelVertex, SplatSurfaceVarying)
{
    splat_surface_point(c, in, position, out, point_size);
}

pixel_shader_targets(splat_surface_ps, SplatUniforms, SplatSurfaceVarying, SplatTargets)
{
    flt weight = splat_weight(c, in->conic, in->place);
    out->color = mul(in->color, weight);
    out->surface = mul(in->surface, weight);
}

program(splat_surface_program, splat_surface_vs, splat_surface_ps, SPLAT_SURFACE_DECLARATIONS,
        .inputs = { SURFEL_INPUTS })
