/* A texture with Lambert lighting per pixel. Texture 0 is the surface's colour, linear light. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/textured.h"

typedef struct Varying {
    float2 uv;
    float3 normal;
} Varying;

vertex_shader(textured_vs, TexturedUniforms, TexturedVertex, Varying)
{
    *position = m4x4(in->position, c->mvp);
    out->uv = in->texcoord;
    out->normal = in->normal;
}

pixel_shader(textured_ps, TexturedUniforms, Varying)
{
    float4 texel = texld(0, in->uv);
    flt lambert = max(dp3(nrm(in->normal), u3(c->light)), 0);
    float3 light = mad(u3(c->diffuse), lambert, u3(c->ambient));
    return rgba(mul(xyz(texel), light), texel.w);
}

program(textured_program, textured_vs, textured_ps, MODEL_2_0,
        .inputs = { MESH_INPUTS, { GP_TEXCOORD0, 2 } },
        .varyings = { { "uv", 2, GP_PERSPECTIVE }, { "normal", 3, GP_PERSPECTIVE } },
        .samplers = 1 << 0)
