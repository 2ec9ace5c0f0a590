/* The ray of a pixel in the slab behind a slice. For shader files only. */
#ifndef SHADERS_SLICES_SHARED_H
#define SHADERS_SLICES_SHARED_H

#include <glasspipe/shader.h>
#include "shaders_c/common/slices.h"

/* Of the slab's near side. */
typedef struct SlabVertex {
    float3 position; /* (u, v, w) */
    flt layer;       /* of voxels */
} SlabVertex;

typedef struct SlabRay {
    float2 start, end; /* u, v where the ray enters and leaves the slab */
    flt layer;         /* of voxels */
} SlabRay;

/* At a vertex of the slab's near side. */
GP_INLINE SlabRay slab_ray(const SliceUniforms *c, const SlabVertex *in)
{
    float3 position = in->position, way = sub(mul(position, c->eye[3]), u3(c->eye));
    flt share = c->thickness * rcp(way.z);
    return (SlabRay){ .start = vec2(position.x, position.y),
                      .end = vec2(position.x + way.x * share, position.y + way.y * share),
                      .layer = in->layer };
}

/* x, y, z of a place. */
GP_INLINE float3 voxel_at(const SliceUniforms *c, float2 across, flt layer)
{
    float3 at = vec3(across.x, across.y, layer);
    return vec3(dp3(at, u3(c->axes[0])), dp3(at, u3(c->axes[1])), dp3(at, u3(c->axes[2])));
}

/* Length of the ray in the slab, in voxels. */
GP_INLINE flt way_through(const SliceUniforms *c, const SlabRay *ray)
{
    float2 across = sub(ray->end, ray->start);
    return sqrt_(dp2add(across, across, bcast(c->thickness * c->thickness)));
}

/* clang-format off */
#define SLAB_INPUTS   { GP_POSITION, 3 }, { GP_TEXCOORD0, 1 }
#define SLAB_VARYINGS { "start", 2, GP_PERSPECTIVE }, { "end", 2, GP_PERSPECTIVE }, \
                      { "layer", 1, GP_FLAT }
/* clang-format on */

#endif
