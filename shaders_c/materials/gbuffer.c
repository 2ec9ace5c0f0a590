/* What deferred lighting needs to know of each visible surface: Saito and Takahashi,
 * "Comprehensible rendering of 3-D shapes", SIGGRAPH 1990. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/gbuffer.h"

typedef struct Targets {
    float4 albedo, normal, world;
} Targets;

vertex_shader(gbuffer_vs, GbufferUniforms, MeshVertex, SurfaceVarying)
{
    *position = mesh_surface(c->mvp, in->position, in->normal, out);
}

pixel_shader_targets(gbuffer_ps, GbufferUniforms, SurfaceVarying, Targets)
{
    out->albedo = rgba(u3(c->diffuse), 1);
    out->normal = rgba(nrm(in->normal), 0);
    out->world = rgba(in->world, 1);
}

program(gbuffer_program, gbuffer_vs, gbuffer_ps, MODEL_2_0, .inputs = { MESH_INPUTS },
        .varyings = { SURFACE_VARYINGS })
