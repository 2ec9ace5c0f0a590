#include "shaders_c/shadow/shadow_splats.h"

#include "shaders_c/points/surface_shared.h"
#include "shaders_c/shadow/shadow_shared.h"

clip_vertex_shader(shadow_splats_vs, ShadowSplatsUniforms);

GP_INLINE Varying find_surface(const ShadowSplatsUniforms *c, const SplattedSurface *surface)
{
    float3 world = mad(surface->ray, surface->distance, u3(c->shadow.eye));
    float3 lifted = mad(towards_light(&c->shadow, world), c->lift, world);
    return (Varying){ .surface = { .normal = surface->normal, .world = world },
                      .place = find_place(&c->shadow, lifted, surface->normal) };
}

/* The surface's colour stands for a texture's. */
GP_INLINE float4 light_splats(GpInvocation *gp, const ShadowSplatsUniforms *c,
                              const SplattedSurface *surface, const Varying *in, flt seen)
{
    const Asked asked = { seen, smooth(gp, &c->shadow, in) };
    return light_surface(&c->shadow, in, &asked, surface->color);
}

#define SHADED(form)                                                                               \
    pixel_shader(shadow_splats_##form##_ps, ShadowSplatsUniforms, NoVarying)                       \
    {                                                                                              \
        SplattedSurface surface = surface_at(gp, &c->normalize, 3);                                \
        Varying lit = find_surface(c, &surface);                                                   \
        float4 color = light_splats(gp, c, &surface, &lit, form(gp, &c->shadow, &lit));            \
        discard(surface.alpha < (c->solid > 0 ? 0.5f : 1e-6f));                                    \
        odepth(surface_depth(&c->normalize, surface.distance));                                    \
        return c->solid > 0 ? color : rgba(mul(xyz(color), surface.alpha), surface.alpha);         \
    }                                                                                              \
    program(shadow_splats_##form##_program, shadow_splats_vs, shadow_splats_##form##_ps,           \
            MODEL_3_0, .inputs = { { GP_POSITION, 3 } }, .samplers = 1 << 0 | 1 << 1 | 1 << 3,     \
            .local_reads = READ_HERE | 1 << SURFACE_HERE_SLOT, .may_discard = true,                \
            .writes_depth = true, .uses_pixel = true)

SHADED(hardware)
SHADED(plain_nearest)
SHADED(plain_bilinear)
