/* Blinn-Phong lighting per pixel. */
#define GP_SHADER_AT_ONCE 4 /* three square roots, one after the other, and a power */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/phong_shared.h"

vertex_shader(phong_vs, PhongUniforms, MeshVertex, SurfaceVarying)
{
    *position = mesh_surface(c->mvp, in->position, in->normal, out);
}

pixel_shader(phong_ps, PhongUniforms, SurfaceVarying)
{
    PhongLight light = phong_light(c, nrm(in->normal), in->world);
    return rgba(with_highlight(c, light, light.color), 1);
}

program(phong_program, phong_vs, phong_ps, MODEL_2_0, .inputs = { MESH_INPUTS },
        .varyings = { SURFACE_VARYINGS })
