/* Four targets at once: Saito and Takahashi, "Comprehensible rendering of 3-D shapes",
 * SIGGRAPH 1990. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/surface_maps.h"

typedef struct Varying {
    SurfaceVarying surface;
    flt depth;
} Varying;

typedef struct Targets {
    float4 world, normal, albedo, light;
} Targets;

/* Depth is linear on the screen. */
vertex_shader(surface_maps_vs, SurfaceMapsUniforms, MeshVertex, Varying)
{
    float4 clip = mesh_surface(c->mvp, in->position, in->normal, &out->surface);
    *position = clip;
    out->depth = clip.z * rcp(clip.w);
}

pixel_shader_targets(surface_maps_ps, SurfaceMapsUniforms, Varying, Targets)
{
    float3 N = nrm(in->surface.normal);
    out->world = rgba(in->surface.world, 1);
    out->normal = rgba(N, 1);
    out->albedo = rgba(u3(c->albedo), 1);
    out->light = vec4(in->depth, dp3(N, u3(c->light)), 0, 1);
}

program(surface_maps_program, surface_maps_vs, surface_maps_ps, MODEL_2_0,
        .inputs = { MESH_INPUTS },
        .varyings = { SURFACE_VARYINGS, { "depth", 1, GP_LINEAR_SCREEN } })
