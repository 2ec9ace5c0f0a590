/* Light in three hard bands and an inked rim, after Lake, Marshall, Harris and Blackstein,
 * "Stylized rendering techniques for scalable real-time 3D animation", NPAR 2000. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/toon.h"

vertex_shader(toon_vs, ToonUniforms, MeshVertex, SurfaceVarying)
{
    *position = mesh_surface(c->mvp, in->position, in->normal, out);
}

pixel_shader(toon_ps, ToonUniforms, SurfaceVarying)
{
    float3 N = nrm(in->normal);
    float3 V = nrm(sub(u3(c->eye), in->world));

    flt lambert = dp3(N, u3(c->light));
    flt steps = add(sge(lambert, c->bands[0]), sge(lambert, c->bands[1]));
    float3 color = mad(u3(c->diffuse), steps * 0.5f, u3(c->ambient));

    flt rim = slt(dp3(N, V), c->outline);
    return rgba(cmp(-rim, color, u3(c->ink)), 1);
}

program(toon_program, toon_vs, toon_ps, MODEL_2_0, .inputs = { MESH_INPUTS },
        .varyings = { SURFACE_VARYINGS })
