#include "shaders_c/volume/raycast_shared.h"

typedef struct RayVertex {
    float2 corner;
    float3 start, way;
} RayVertex;

typedef struct RayVarying {
    float3 start, way;
} RayVarying;

vertex_shader(raycast_vs, RaycastUniforms, RayVertex, RayVarying)
{
    *position = vec4(in->corner.x, in->corner.y, 0.5f, 1);
    out->start = in->start;
    out->way = in->way;
}

/* Where opaque things end the ray, as a share of its way. */
GP_INLINE flt end_by_depth(GpInvocation *gp, const RaycastUniforms *c)
{
    float2 pixel = vpos();
    flt depth =
        texldl(3, vec4((pixel.x + 0.5f) * c->texel[0], (pixel.y + 0.5f) * c->texel[1], 0, 0)).x;
    return mad(depth, c->depth[1], c->depth[0]) / mad(depth, c->depth[3], c->depth[2]);
}

pixel_shader(raycast_ps, RaycastUniforms, RayVarying)
{
    Ray ray = cut_ray(c, in->start, in->way, end_by_depth(gp, c));
    return walk(gp, c, &ray, false);
}

pixel_shader(raycast_lit_ps, RaycastUniforms, RayVarying)
{
    Ray ray = cut_ray(c, in->start, in->way, end_by_depth(gp, c));
    return walk(gp, c, &ray, true);
}

/* clang-format off */
#define RAYCAST_DECLARATIONS                                                                       \
    .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0,                                       \
    .inputs = { { GP_POSITION, 2 }, { GP_TEXCOORD0, 3 }, { GP_TEXCOORD1, 3 } },                    \
    .varyings = { { "start", 3, GP_LINEAR_SCREEN }, { "way", 3, GP_LINEAR_SCREEN } },              \
    .samplers = 1 << 0 | 1 << 1 | 1 << 2 | 1 << 3, .uses_pixel = true

program(raycast_program, raycast_vs, raycast_ps, RAYCAST_DECLARATIONS)
program(raycast_lit_program, raycast_vs, raycast_lit_ps, RAYCAST_DECLARATIONS)
/* clang-format on */
