/* Vertices that many shaders take, and what they make of them. For shader files only. */
#ifndef SHADERS_VERTICES_SHARED_H
#define SHADERS_VERTICES_SHARED_H

#include "pipeline/shader.h"

typedef struct NoUniforms {
} NoUniforms; /* a draw's may be NULL */

typedef struct NoVarying {
} NoVarying;

typedef struct PointVertex {
    float3 position;
} PointVertex;

/* --- meshes ----------------------------------------------------------------------------------- */

typedef struct MeshVertex {
    float3 position, normal;
} MeshVertex;

typedef struct TexturedVertex {
    float3 position, normal;
    float2 texcoord;
} TexturedVertex;

/* What is lit at each pixel. */
typedef struct SurfaceVarying {
    float3 normal, world;
} SurfaceVarying;

/* Clip position of a vertex that is in world space already, and its surface. */
GP_INLINE float4 mesh_surface(const float mvp[4][4], float3 world, float3 normal,
                              SurfaceVarying *out)
{
    out->normal = normal;
    out->world = world;
    return m4x4(world, mvp);
}

/* --- quads whose corners are in clip space already -------------------------------------------- */

typedef struct TexturedQuadVertex {
    float3 position;
    float2 texcoord;
} TexturedQuadVertex;

typedef struct UvVarying {
    float2 uv;
} UvVarying;

GP_INLINE float4 textured_quad(const TexturedQuadVertex *in, UvVarying *out)
{
    out->uv = in->texcoord;
    return rgba(in->position, 1);
}

/* --- declarations ----------------------------------------------------------------------------- */

/* clang-format off */
#define MESH_INPUTS      { GP_POSITION, 3 }, { GP_NORMAL, 3 }
#define SURFACE_VARYINGS { "normal", 3, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE }
#define TEXTURED_QUAD_DECLARATIONS                                                                 \
    .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },                                         \
    .varyings = { { "uv", 2, GP_PERSPECTIVE } }
/* clang-format on */

#endif
