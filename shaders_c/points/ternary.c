#include "shaders_c/points/ternary.h"

#include "shaders_c/points/splat_shared.h"

GP_INLINE float4 ternary_clip(const TernaryUniforms *c, const EyeSurfel *eye)
{
    flt footprint = mad(eye->position.z, c->footprint[1], c->footprint[0]);
    return surfel_clip_at(&c->splat, eye, mad(log_(footprint), c->depth[1], c->depth[0]));
}

vertex_shader(ternary_color_vs, TernaryUniforms, SurfelVertex, SplatColorVarying)
{
    EyeSurfel eye = surfel_before_eye(&c->splat, in->position, in->normal, in->radius);
    *position = ternary_clip(c, &eye);
    splat_color_vertex(&c->splat, in, &eye, out, point_size);
}

pixel_shader(ternary_color_ps, TernaryUniforms, SplatColorVarying)
{
    return mul(in->color, splat_weight(&c->splat, in->conic, in->place));
}

program(ternary_color_program, ternary_color_vs, ternary_color_ps, SPLAT_COLOR_DECLARATIONS,
        .inputs = { SURFEL_INPUTS })

vertex_shader(ternary_surface_vs, TernaryUniforms, SurfelVertex, SplatSurfaceVarying)
{
    EyeSurfel eye = surfel_before_eye(&c->splat, in->position, in->normal, in->radius);
    *position = ternary_clip(c, &eye);
    splat_surface_vertex(&c->splat, in, &eye, out, point_size);
}

pixel_shader_targets(ternary_surface_ps, TernaryUniforms, SplatSurfaceVarying, SplatTargets)
{
    flt weight = splat_weight(&c->splat, in->conic, in->place);
    out->color = mul(in->color, weight);
    out->surface = mul(in->surface, weight);
}

program(ternary_surface_program, ternary_surface_vs, ternary_surface_ps, SPLAT_SURFACE_DECLARATIONS,
        .inputs = { SURFEL_INPUTS })
