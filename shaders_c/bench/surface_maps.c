/* Four targets at once: Saito and Takahashi, "Comprehensible rendering of 3-D shapes",
 * SIGGRAPH 1990. */
#include "pipeline/shader.h"
#include "shaders_c/bench/surface_maps.h"

typedef struct Vertex {
    float3 position, normal;
} Vertex;

typedef struct Varying {
    float3 normal, world;
    flt depth;
} Varying;

typedef struct Targets {
    float4 world, normal, albedo, light;
} Targets;

/* Depth is linear on the screen. */
vertex_shader(surface_maps_vs, SurfaceMapsUniforms, Vertex, Varying)
{
    float4 clip = m4x4(in->position, c->mvp);
    *position = clip;
    out->normal = in->normal;
    out->world = in->position;
    out->depth = clip.z * rcp(clip.w);
}

pixel_shader_targets(surface_maps_ps, SurfaceMapsUniforms, Varying, Targets)
{
    float3 N = nrm(in->normal);
    out->world = rgba(in->world, 1);
    out->normal = rgba(N, 1);
    out->albedo = rgba(u3(c->albedo), 1);
    out->light = vec4(in->depth, dp3(N, u3(c->light)), 0, 1);
}

program(surface_maps_program, surface_maps_vs, surface_maps_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 3 }, { GP_NORMAL, 3 } },
        .varyings = { { "normal", 3, GP_PERSPECTIVE },
                      { "world", 3, GP_PERSPECTIVE },
                      { "depth", 1, GP_LINEAR_SCREEN } })
