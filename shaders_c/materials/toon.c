/* Light in three hard bands and an inked rim, after Lake, Marshall, Harris and Blackstein,
 * "Stylized rendering techniques for scalable real-time 3D animation", NPAR 2000. */
#include "pipeline/shader.h"
#include "shaders_c/materials/toon.h"

typedef struct Vertex {
    float3 position, normal;
} Vertex;

typedef struct Varying {
    float3 normal, world;
} Varying;

vertex_shader(toon_vs, ToonUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->mvp);
    out->normal = in->normal;
    out->world = in->position;
}

pixel_shader(toon_ps, ToonUniforms, Varying)
{
    float3 N = nrm(in->normal);
    float3 V = nrm(sub(u3(c->eye), in->world));

    flt lambert = dp3(N, u3(c->light));
    flt steps = add(sge(lambert, c->bands[0]), sge(lambert, c->bands[1]));
    float3 color = mad(u3(c->diffuse), steps * 0.5f, u3(c->ambient));

    flt rim = slt(dp3(N, V), c->outline);
    return rgba(cmp(-rim, color, u3(c->ink)), 1);
}

program(toon_program, toon_vs, toon_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_NORMAL, 3 } },
        .varyings = { { "normal", 3, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE } })
