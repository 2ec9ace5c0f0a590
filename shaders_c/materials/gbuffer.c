/* What deferred lighting needs to know of each visible surface: Saito and Takahashi,
 * "Comprehensible rendering of 3-D shapes", SIGGRAPH 1990. */
#include "pipeline/shader.h"
#include "shaders_c/materials/gbuffer.h"

typedef struct Vertex {
    float3 position, normal;
} Vertex;

typedef struct Varying {
    float3 normal, world;
} Varying;

typedef struct Targets {
    float4 albedo, normal, world;
} Targets;

vertex_shader(gbuffer_vs, GbufferUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->mvp);
    out->normal = in->normal;
    out->world = in->position;
}

pixel_shader_targets(gbuffer_ps, GbufferUniforms, Varying, Targets)
{
    out->albedo = rgba(u3(c->diffuse), 1);
    out->normal = rgba(nrm(in->normal), 0);
    out->world = rgba(in->world, 1);
}

program(gbuffer_program, gbuffer_vs, gbuffer_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 3 }, { GP_NORMAL, 3 } },
        .varyings = { { "normal", 3, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE } })
