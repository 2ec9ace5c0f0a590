/* What shaders of meshes have in common: vertices with normals, and surfaces that are lit at each
 * pixel. For shader files only. */
#ifndef SHADERS_MESH_SHARED_H
#define SHADERS_MESH_SHARED_H

#include "pipeline/shader.h"

typedef struct MeshVertex {
    float3 position, normal;
} MeshVertex;

typedef struct TexturedVertex {
    float3 position, normal;
    float2 texcoord;
} TexturedVertex;

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

/* clang-format off */
#define MESH_INPUTS      { GP_POSITION, 3 }, { GP_NORMAL, 3 }
#define SURFACE_VARYINGS { "normal", 3, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE }
/* clang-format on */

#endif
