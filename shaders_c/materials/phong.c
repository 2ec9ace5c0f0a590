/* Blinn-Phong lighting per pixel: Blinn, "Models of light reflection for computer synthesized
 * pictures", SIGGRAPH 1977. */
#define GP_SHADER_AT_ONCE 4 /* three square roots, one after the other, and a power */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/phong.h"

vertex_shader(phong_vs, PhongUniforms, MeshVertex, SurfaceVarying)
{
    *position = mesh_surface(c->mvp, in->position, in->normal, out);
}

pixel_shader(phong_ps, PhongUniforms, SurfaceVarying)
{
    float3 L = u3(c->light);
    float3 N = nrm(in->normal);
    float3 V = nrm(sub(u3(c->eye), in->world));
    float3 H = nrm(add(V, L));

    flt diffuse = max(dp3(N, L), 0);
    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess));

    float3 color = mad(u3(c->diffuse), diffuse, u3(c->ambient));
    return rgba(mad(sp3(highlight), c->specular, color), 1);
}

program(phong_program, phong_vs, phong_ps, MODEL_2_0, .inputs = { MESH_INPUTS },
        .varyings = { SURFACE_VARYINGS })
