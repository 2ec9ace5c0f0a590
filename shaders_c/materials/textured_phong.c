/* A texture with Blinn-Phong lighting per pixel (see phong.c). Texture 0 is the surface's colour,
 * linear light. */
#define GP_SHADER_AT_ONCE 4
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/textured_phong.h"

typedef struct Varying {
    float2 uv;
    SurfaceVarying surface;
} Varying;

vertex_shader(textured_phong_vs, PhongUniforms, TexturedVertex, Varying)
{
    *position = mesh_surface(c->mvp, in->position, in->normal, &out->surface);
    out->uv = in->texcoord;
}

pixel_shader_begin(textured_phong_ps, PhongUniforms, Varying, float4)
{
    return texld(0, in->uv);
}

pixel_shader_end(textured_phong_ps, PhongUniforms, Varying, float4)
{
    float4 texel = *begun;
    float3 L = u3(c->light);
    float3 N = nrm(in->surface.normal);
    float3 V = nrm(sub(u3(c->eye), in->surface.world));
    float3 H = nrm(add(V, L));

    flt diffuse = max(dp3(N, L), 0);
    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess));

    float3 color = mul(xyz(texel), mad(u3(c->diffuse), diffuse, u3(c->ambient)));
    return rgba(mad(sp3(highlight), c->specular, color), texel.w);
}

program(textured_phong_program, textured_phong_vs, textured_phong_ps, MODEL_2_0,
        .inputs = { MESH_INPUTS, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE }, SURFACE_VARYINGS }, .samplers = 1 << 0)
