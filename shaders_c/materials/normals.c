/* The world-space normal as a colour: each axis from -1, shown as 0, to 1. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/normals.h"

typedef struct Varying {
    float3 normal;
} Varying;

vertex_shader(normals_vs, NormalsUniforms, MeshVertex, Varying)
{
    *position = m4x4(in->position, c->mvp);
    out->normal = in->normal;
}

pixel_shader(normals_ps, NormalsUniforms, Varying)
{
    return rgba(mad(nrm(in->normal), 0.5f, 0.5f), 1);
}

program(normals_program, normals_vs, normals_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { MESH_INPUTS },
        .varyings = { { "normal", 3, GP_PERSPECTIVE } })
