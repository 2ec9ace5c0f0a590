/* Phong, seen through a volume: see through.h. */
#include "shaders_c/volume/through.h"
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/volume/raycast_shared.h"

vertex_shader(through_vs, ThroughUniforms, MeshVertex, SurfaceVarying)
{
    *position = mesh_surface(c->phong.mvp, in->position, in->normal, out);
}

GP_INLINE float3 of_pixel(const float ends[3][3], float2 pixel)
{
    return mad(u3(ends[1]), pixel.x, mad(u3(ends[2]), pixel.y, u3(ends[0])));
}

/* As phong.c lights it. */
GP_INLINE float3 lit_surface(const PhongUniforms *c, const SurfaceVarying *in)
{
    float3 L = u3(c->light);
    float3 N = nrm(in->normal);
    float3 V = nrm(sub(u3(c->eye), in->world));
    float3 H = nrm(add(V, L));

    flt diffuse = max(dp3(N, L), 0);
    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess));

    float3 color = mad(u3(c->diffuse), diffuse, u3(c->ambient));
    return mad(sp3(highlight), c->specular, color);
}

GP_INLINE float4 seen_through(GpInvocation *gp, const ThroughUniforms *c, const SurfaceVarying *in,
                              bool lit)
{
    float2 pixel = vpos();
    flt share = dp3(in->world, u3(c->share)) + c->share[3];
    Ray ray = cut_ray(&c->rays, of_pixel(c->start, pixel), of_pixel(c->way, pixel), share);
    float4 before = walk(gp, &c->rays, &ray, lit);
    return rgba(mad(lit_surface(&c->phong, in), 1.0f - before.w, xyz(before)), 1);
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
