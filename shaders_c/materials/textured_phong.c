/* A texture with Blinn-Phong lighting per pixel (see phong_shared.h). Texture 0 is the surface's
 * colour, linear light. */
#define GP_SHADER_AT_ONCE 4
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/phong_shared.h"
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
    PhongLight light = phong_light(c, nrm(in->surface.normal), in->surface.world);
    float3 color = mul(xyz(texel), light.color);
    return rgba(with_highlight(c, light, color), texel.w);
}

program(textured_phong_program, textured_phong_vs, textured_phong_ps, MODEL_2_0,
        .inputs = { MESH_INPUTS, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE }, SURFACE_VARYINGS }, .samplers = 1 << 0)
