/* Quads whose corners are in clip space already, plain and with texture coordinates. For shader files
 * only. */
#ifndef SHADERS_QUAD_SHARED_H
#define SHADERS_QUAD_SHARED_H

#include "pipeline/shader.h"

typedef struct NoUniforms {
} NoUniforms; /* a draw's may be NULL */

typedef struct QuadVertex {
    float3 position;
} QuadVertex;

typedef struct TexturedQuadVertex {
    float3 position;
    float2 texcoord;
} TexturedQuadVertex;

typedef struct NoVarying {
} NoVarying;

typedef struct UvVarying {
    float2 uv;
} UvVarying;

GP_INLINE float4 textured_quad(const TexturedQuadVertex *in, UvVarying *out)
{
    out->uv = in->texcoord;
    return rgba(in->position, 1);
}

/* clang-format off */
#define TEXTURED_QUAD_DECLARATIONS                                                                 \
    .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },                                         \
    .varyings = { { "uv", 2, GP_PERSPECTIVE } }
/* clang-format on */

#endif
