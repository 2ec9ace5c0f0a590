/* The depth map of a light in a colour target (thesis, section 4.2.1, step 2): z and w go through
 * as texture coordinates and are divided at each pixel. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/shadow/shadow_map.h"

typedef struct Varying {
    float2 depth; /* z, w */
} Varying;

vertex_shader(shadow_map_vs, ShadowMapUniforms, PointVertex, Varying)
{
    float4 clip = m4x4(in->position, c->mvp);
    *position = clip;
    out->depth = vec2(clip.z, clip.w);
}

pixel_shader(shadow_map_ps, ShadowMapUniforms, Varying)
{
    return sp4(in->depth.x / in->depth.y);
}

program(shadow_map_program, shadow_map_vs, shadow_map_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } }, .varyings = { { "depth", 2, GP_PERSPECTIVE } })
