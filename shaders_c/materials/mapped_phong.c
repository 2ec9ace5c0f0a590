/* Colours and normals of two textures with Blinn-Phong lighting per pixel (see phong.c). Texture 0 is the
 * surface's colour, linear light; texture 1 its normals in the world, a component n as (n + 1) / 2. */
#define GP_SHADER_AT_ONCE 4
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/mapped_phong.h"

typedef struct MappedVertex {
    float3 position;
    float2 texcoord;
} MappedVertex;

typedef struct Varying {
    float2 uv;
    float3 world;
} Varying;

vertex_shader(mapped_phong_vs, PhongUniforms, MappedVertex, Varying)
{
    *position = m4x4(in->position, c->mvp);
    out->world = in->position;
    out->uv = in->texcoord;
}

typedef struct Texels {
    float4 color, normal;
} Texels;

pixel_shader_begin(mapped_phong_ps, PhongUniforms, Varying, Texels)
{
    float4 color = texld(0, in->uv);
    return (Texels){ color, texld(1, in->uv) };
}

pixel_shader_end(mapped_phong_ps, PhongUniforms, Varying, Texels)
{
    float4 texel = begun->color;
    float3 L = u3(c->light);
    float3 N = nrm(mad(xyz(begun->normal), 2, sp3(bcast(-1))));
    float3 V = nrm(sub(u3(c->eye), in->world));
    float3 H = nrm(add(V, L));

    flt diffuse = max(dp3(N, L), 0);
    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess));

    float3 color = mul(xyz(texel), mad(u3(c->diffuse), diffuse, u3(c->ambient)));
    return rgba(mad(sp3(highlight), c->specular, color), texel.w);
}

program(mapped_phong_program, mapped_phong_vs, mapped_phong_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE } },
        .samplers = 1 << 0 | 1 << 1)
