/* Point lights on the surfaces of the gbuffer program, read at each pixel's own place: slot 0 holds
 * albedo and coverage, 1 world normals, 2 world positions. Positions are in clip space already:
 * draw a quad over the whole target.
 *
 * A light fades with 1 - d^2 / range^2, which needs no division and ends where its range does. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/deferred.h"

clip_vertex_shader(deferred_vs, DeferredUniforms);

pixel_shader(deferred_ps, DeferredUniforms, NoVarying)
{
    float4 albedo = gp_load_local(0);
    float3 N = xyz(gp_load_local(1));
    float3 P = xyz(gp_load_local(2));

    float3 light = u3(c->ambient);
    for (int i = 0; i < DEFERRED_LIGHTS; i++) {
        float3 to_light = sub(u3(c->lights[i].position), P);
        flt square = dp3(to_light, to_light);
        flt lambert = max(dp3(N, to_light), 0) * rsq(square);
        flt fade = sat(mad(-square, c->lights[i].inverse_square_range, 1));
        light = mad(u3(c->lights[i].color), lambert * fade, light);
    }
    float3 lit_surface = mul(xyz(albedo), light);
    return rgba(sel(albedo.w > 0.0f, lit_surface, u3(c->background)), 1);
}

program(deferred_program, deferred_vs, deferred_ps, MODEL_2_0, .inputs = { { GP_POSITION, 3 } },
        .local_reads = 1 << 0 | 1 << 1 | 1 << 2)
