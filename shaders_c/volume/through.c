/* Phong, seen through a volume: see through.h. */
#include "shaders_c/volume/through.h"
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/phong_shared.h"
#include "shaders_c/volume/raycast_shared.h"

vertex_shader(through_vs, ThroughUniforms, MeshVertex, SurfaceVarying)
{
    *position = mesh_surface(c->phong.mvp, in->position, in->normal, out);
}

GP_INLINE float3 of_pixel(const float ends[3][3], float2 pixel)
{
    return mad(u3(ends[1]), pixel.x, mad(u3(ends[2]), pixel.y, u3(ends[0])));
}

GP_INLINE float4 seen_through(GpInvocation *gp, const ThroughUniforms *c, const SurfaceVarying *in,
                              bool lit)
{
    float2 pixel = vpos();
    flt share = dp3(in->world, u3(c->share)) + c->share[3];
    Ray ray = cut_ray(&c->rays, of_pixel(c->start, pixel), of_pixel(c->way, pixel), share);
    float4 before = walk(gp, &c->rays, &ray, lit);
    PhongLight light = phong_light(&c->phong, nrm(in->normal), in->world);
    float3 surface = with_highlight(&c->phong, light, light.color);
    return rgba(mad(surface, 1.0f - before.w, xyz(before)), 1);
}

pixel_shader(through_ps, ThroughUniforms, SurfaceVarying)
{
    return seen_through(gp, c, in, false);
}

pixel_shader(through_lit_ps, ThroughUniforms, SurfaceVarying)
{
    return seen_through(gp, c, in, true);
}

/* clang-format off */
#define THROUGH_DECLARATIONS                                                                       \
    MODEL_3_0, .inputs = { MESH_INPUTS }, .varyings = { SURFACE_VARYINGS },                        \
    .samplers = 1 << 0 | 1 << 1 | 1 << 2, .uses_pixel = true

program(phong_through_program, through_vs, through_ps, THROUGH_DECLARATIONS)
program(phong_through_lit_program, through_vs, through_lit_ps, THROUGH_DECLARATIONS)
/* clang-format on */
