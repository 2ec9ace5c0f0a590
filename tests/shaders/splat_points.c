/* Points with a place in the sprite, in perspective, which discard what lies outside a disc. */
#include <glasspipe/shader.h>
#include "tests/shaders/splat_points.h"

typedef struct Vertex {
    float4 position;
    float4 color;
    flt size;
} Vertex;

typedef struct Varying {
    float2 sprite;
    float4 color;
} Varying;

typedef struct Plain {
    float4 color;
} Plain;

typedef struct TwoTargets {
    float4 color, weight;
} TwoTargets;

#define INPUTS                                                                                     \
    {                                                                                              \
        { GP_POSITION, 4 }, { GP_COLOR, 4 },                                                       \
        {                                                                                          \
            GP_POINT_SIZE, 1                                                                       \
        }                                                                                          \
    }

/* From pixels to clip space. */
GP_INLINE float4 clip_position(const SplatPointsUniforms *c, float4 place)
{
    const flt x = sub(mul(place.x, 2.0f / c->size[0]), 1), w = place.w;
    const flt y = sub(bcast(1), mul(place.y, 2.0f / c->size[1]));
    return vec4(mul(x, w), mul(y, w), mul(place.z, w), w);
}

vertex_shader(splat_points_vs, SplatPointsUniforms, Vertex, Varying)
{
    *position = clip_position(c, in->position);
    *point_size = in->size;
    out->sprite = vec2(0, 0);
    out->color = in->color;
}

vertex_shader(splat_points_plain_vs, SplatPointsUniforms, Vertex, Plain)
{
    *position = clip_position(c, in->position);
    out->color = mul(in->color, in->size);
}

/* Square of the distance from the centre, 1 at the edges. */
GP_INLINE flt square_radius(float2 sprite)
{
    float2 from_centre = mul(sub(sprite, 0.5f), 2);
    return dp2(from_centre, from_centre);
}

pixel_shader(splat_points_ps, SplatPointsUniforms, Varying)
{
    flt square = square_radius(in->sprite);
    discard(square > 1.0f);
    return mul(in->color, sub(bcast(1.25f), square));
}

pixel_shader_targets(splat_points_targets2_ps, SplatPointsUniforms, Varying, TwoTargets)
{
    flt square = square_radius(in->sprite);
    out->color = mul(in->color, square);
    out->weight = rgba(vec3(in->sprite.x, in->sprite.y, square), 1);
}

pixel_shader(splat_points_plain_ps, SplatPointsUniforms, Plain)
{
    return in->color;
}

program(splat_points, splat_points_vs, splat_points_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = INPUTS,
        .varyings = { { "sprite", 2, GP_SPRITE_COORD }, { "color", 4, GP_FLAT } },
        .may_discard = true, .writes_point_size = true)
program(splat_points_targets2, splat_points_vs, splat_points_targets2_ps,
        .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0, .inputs = INPUTS,
        .varyings = { { "sprite", 2, GP_SPRITE_COORD }, { "color", 4, GP_FLAT } },
        .writes_point_size = true)
program(splat_points_plain, splat_points_plain_vs, splat_points_plain_ps,
        .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0, .inputs = INPUTS,
        .varyings = { { "color", 4, GP_FLAT } })
