/* Colours and normals of two textures with Blinn-Phong lighting per pixel (see phong_shared.h).
 * Texture 0 is the surface's colour, linear light; texture 1 its normals in the world, a component
 * n as (n + 1) / 2. */
#define GP_SHADER_AT_ONCE 4
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/mapped_phong.h"
#include "shaders_c/materials/phong_shared.h"

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
    PhongLight light = phong_light(c, nrm(mad(xyz(begun->normal), 2, sp3(bcast(-1)))), in->world);
    float3 color = mul(xyz(texel), light.color);
    return rgba(with_highlight(c, light, color), texel.w);
}

program(mapped_phong_program, mapped_phong_vs, mapped_phong_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE } },
        .samplers = 1 << 0 | 1 << 1)
