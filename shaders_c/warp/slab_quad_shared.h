/* Rectangles that stand in the box of a depth image, parallel to its picture. For shader files
 * only. */
#ifndef SHADERS_WARP_SLAB_QUAD_SHARED_H
#define SHADERS_WARP_SLAB_QUAD_SHARED_H

#include "shaders_c/warp/slab_shared.h"

typedef struct SlabQuadVertex {
    float3 position;
    float2 texcoord;
} SlabQuadVertex;

typedef struct SlabQuadVarying {
    float2 at; /* in the box */
    float3 world;
} SlabQuadVarying;

/* clang-format off */
#define SLAB_QUAD_VERTEX_SHADER(name, Uniforms)                                                    \
    vertex_shader(name##_vs, Uniforms, SlabQuadVertex, SlabQuadVarying)                            \
    {                                                                                              \
        *position = m4x4(in->position, c->mvp);                                                    \
        out->at = in->texcoord;                                                                    \
        out->world = in->position;                                                                 \
    }                                                                                              \
    struct name##_follows

#define SLAB_QUAD_PROGRAM(name, vs, ps, slots, depth)                                              \
    program(name, vs, ps, .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0,                 \
            .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },                                 \
            .varyings = { { "at", 2, GP_PERSPECTIVE }, { "world", 3, GP_PERSPECTIVE } },           \
            .samplers = slots, .may_discard = true, .writes_depth = depth)
/* clang-format on */

#endif
