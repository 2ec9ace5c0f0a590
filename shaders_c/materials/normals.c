/* The world-space normal as a colour: each axis from -1, shown as 0, to 1. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/normals.h"

vertex_shader(normals_vs, NormalsUniforms, MeshVertex, NormalVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->normal = in->normal;
}

pixel_shader(normals_ps, NormalsUniforms, NormalVarying)
{
    return rgba(mad(nrm(in->normal), 0.5f, 0.5f), 1);
}

program(normals_program, normals_vs, normals_ps, MODEL_2_0, .inputs = { MESH_INPUTS },
        .varyings = { { "normal", 3, GP_PERSPECTIVE } })
