#include "shaders_c/shadow/shadow_discs.h"

#include "shaders_c/common/vertices_shared.h"

typedef struct DiscVertex {
    float3 position;
    float2 place;
} DiscVertex;

typedef struct DiscVarying {
    float2 place;
    float2 depth; /* z, w */
} DiscVarying;

vertex_shader(shadow_disc_vs, ShadowDiscUniforms, DiscVertex, DiscVarying)
{
    float4 clip = m4x4(in->position, c->mvp);
    *position = clip;
    out->place = in->place;
    out->depth = vec2(clip.z, clip.w);
}

pixel_shader(shadow_disc_ps, ShadowDiscUniforms, DiscVarying)
{
    discard(dp2(in->place, in->place) > 1.0f);
    return sp4(in->depth.x / in->depth.y);
}

/* clang-format off */
#define DISC_DECLARATIONS                                                                          \
    MODEL_2_0, .inputs = { { GP_POSITION, 3 }, { GP_TEXCOORD0, 2 } },                              \
    .varyings = { { "place", 2, GP_PERSPECTIVE }, { "depth", 2, GP_PERSPECTIVE } },                \
    .may_discard = true
/* clang-format on */

program(shadow_disc_program, shadow_disc_vs, shadow_disc_ps, DISC_DECLARATIONS)
program(shadow_disc_map_program, shadow_disc_vs, shadow_disc_ps, DISC_DECLARATIONS)
