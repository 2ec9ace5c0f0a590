/* Blinn-Phong lighting at the vertices, its colours interpolated: Gouraud, "Continuous shading of
 * curved surfaces", IEEE Transactions on Computers, 1971. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/gouraud.h"

typedef struct Varying {
    float3 color;
} Varying;

vertex_shader(gouraud_vs, PhongUniforms, MeshVertex, Varying)
{
    float3 L = u3(c->light);
    float3 N = nrm(in->normal);
    float3 V = nrm(sub(u3(c->eye), in->position));
    float3 H = nrm(add(V, L));

    float4 light = lit(dp3(N, L), dp3(N, H), bcast(c->shininess));

    *position = m4x4(in->position, c->mvp);
    float3 color = mad(u3(c->diffuse), light.y, u3(c->ambient));
    out->color = mad(sp3(light.z), c->specular, color);
}

pixel_shader(gouraud_ps, PhongUniforms, Varying)
{
    return rgba(in->color, 1);
}

program(gouraud_program, gouraud_vs, gouraud_ps, MODEL_2_0, .inputs = { MESH_INPUTS },
        .varyings = { { "color", 3, GP_PERSPECTIVE } })
