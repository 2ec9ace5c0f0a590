/* Vertices that many shaders take, and what they make of them. For shader files only. */
#ifndef SHADERS_VERTICES_SHARED_H
#define SHADERS_VERTICES_SHARED_H

#include <glasspipe/shader.h>

typedef struct NoUniforms {
} NoUniforms; /* a draw's may be NULL */

typedef struct NoVarying {
} NoVarying;

typedef struct PointVertex {
    float3 position;
} PointVertex;

typedef struct ColoredVertex {
    float3 position;
    float4 color;
} ColoredVertex;

typedef struct ColorVarying {
    float4 color;
} ColorVarying;

typedef struct DepthVarying {
    flt depth;
} DepthVarying;

/* Slabs of a volume, one in each target. */
typedef struct SlabTargets {
    float4 slab[4];
} SlabTargets;

/* --- meshes ----------------------------------------------------------------------------------- */

typedef struct MeshVertex {
    float3 position, normal;
} MeshVertex;

typedef struct TexturedVertex {
    float3 position, normal;
    float2 texcoord;
} TexturedVertex;

typedef struct NormalVarying {
    float3 normal;
} NormalVarying;

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

/* --- what is in clip space already ------------------------------------------------------------ */

/* Whole shaders by macros end in the declaration of a struct that nobody uses, so that a semicolon
 * stands behind them: editors and formatters know where they are. */

#define clip_vertex_shader(name, Uniforms)                                                         \
    vertex_shader(name, Uniforms, PointVertex, NoVarying)                                          \
    {                                                                                              \
        *position = rgba(in->position, 1);                                                         \
    }                                                                                              \
    struct name##_follows

typedef struct TexturedQuadVertex {
    float3 position;
    float2 texcoord;
} TexturedQuadVertex;

typedef struct UvVarying {
    float2 uv;
} UvVarying;

#define textured_quad_vertex_shader(name, Uniforms)                                                \
    vertex_shader(name, Uniforms, TexturedQuadVertex, UvVarying)                                   \
    {                                                                                              \
        *position = rgba(in->position, 1);                                                         \
        out->uv = in->texcoord;                                                                    \
    }                                                                                              \
    struct name##_follows

/* --- declarations ----------------------------------------------------------------------------- */

/* clang-format off */
#define MODEL_2_0 .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0
#define MODEL_3_0 .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0
#define MESH_INPUTS      { GP_POSITION, 3 }, { GP_NORMAL, 3 }
#define SURFACE_VARYINGS { "normal", 3, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE }
#define TEXTURED_QUAD_DECLARATIONS                                                                 \
    .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },                                         \
    .varyings = { { "uv", 2, GP_PERSPECTIVE } }
/* clang-format on */

#endif
