/* Blinn-Phong lighting per pixel: Blinn, "Models of light reflection for computer synthesized
 * pictures", SIGGRAPH 1977. */
#define GP_SHADER_PAIRS /* three square roots, one after the other, and a power */
#include "pipeline/shader.h"
#include "shaders_c/materials/phong.h"

typedef struct Vertex {
    float3 position, normal;
} Vertex;

typedef struct Varying {
    float3 normal, world;
} Varying;

vertex_shader(phong_vs, PhongUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->mvp);
    out->normal = in->normal;
    out->world = in->position;
}

pixel_shader(phong_ps, PhongUniforms, Varying)
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

program(phong_program, phong_vs, phong_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_NORMAL, 3 } },
        .varyings = { { "normal", 3, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE } })
