/* A texture with Blinn-Phong lighting per pixel (see phong.c). Texture 0 is the surface's colour,
 * linear light. */
#include "pipeline/shader.h"
#include "shaders_c/materials/textured_phong.h"

typedef struct Vertex {
    float3 position, normal;
    float2 texcoord;
} Vertex;

typedef struct Varying {
    float2 uv;
    float3 normal, world;
} Varying;

vertex_shader(textured_phong_vs, TexturedPhongUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->mvp);
    out->uv = in->texcoord;
    out->normal = in->normal;
    out->world = in->position;
}

pixel_shader(textured_phong_ps, TexturedPhongUniforms, Varying)
{
    float4 texel = texld(0, in->uv);
    float3 L = u3(c->light);
    float3 N = nrm(in->normal);
    float3 V = nrm(sub(u3(c->eye), in->world));
    float3 H = nrm(add(V, L));

    flt diffuse = max(dp3(N, L), 0);
    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess));

    float3 color = mul(xyz(texel), mad(u3(c->diffuse), diffuse, u3(c->ambient)));
    return rgba(mad(sp3(highlight), c->specular, color), texel.w);
}

program(textured_phong_program, textured_phong_vs, textured_phong_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_NORMAL, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE },
                      { "normal", 3, GP_PERSPECTIVE },
                      { "world", 3, GP_PERSPECTIVE } },
        .samplers = 1 << 0)
