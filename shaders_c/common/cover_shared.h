/* Drawing all pixels of the viewport by one triangle: flat_texture_cover. For shader files only. */
#ifndef SHADERS_COVER_SHARED_H
#define SHADERS_COVER_SHARED_H

#include "shaders_c/common/vertices_shared.h"

typedef struct CoverVertex {
    float2 corner; /* clip space */
} CoverVertex;

typedef struct CoverVarying {
    float2 place; /* (0, 0) the top left of the viewport, (1, 1) the opposite corner */
} CoverVarying;

GP_INLINE float4 cover(const CoverVertex *in, CoverVarying *out)
{
    out->place = vec2(in->corner.x * 0.5f + 0.5f, 0.5f - in->corner.y * 0.5f);
    return vec4(in->corner.x, in->corner.y, 0.5f, 1);
}

#define cover_vertex_shader(name, Uniforms)                                                        \
    vertex_shader(name, Uniforms, CoverVertex, CoverVarying)                                       \
    {                                                                                              \
        *position = cover(in, out);                                                                \
    }                                                                                              \
    struct name##_follows

/* clang-format off */
#define COVER_DECLARATIONS                                                                         \
    .inputs = { { GP_POSITION, 2 } }, .varyings = { { "place", 2, GP_LINEAR_SCREEN } }
/* clang-format on */

#endif
