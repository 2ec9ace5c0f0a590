/* Colours from many flat values and the pixel's place. */
#include <glasspipe/shader.h>
#include "tests/shaders/flat_points.h"

enum { MANY = 8 };

typedef struct Vertex {
    float3 position;
    float4 color;
    flt size;
} Vertex;

typedef struct Few {
    float4 color;
    float3 place;
} Few;

typedef struct Varying {
    float4 value[MANY];
    float3 place;
} Varying;

typedef struct FourTargets {
    float4 target[4];
} FourTargets;

#define INPUTS                                                                                     \
    {                                                                                              \
        { GP_POSITION, 3 }, { GP_COLOR, 4 },                                                       \
        {                                                                                          \
            GP_POINT_SIZE, 1                                                                       \
        }                                                                                          \
    }

/* From pixels to clip space. */
GP_INLINE float4 clip_position(const FlatPointsUniforms *c, float3 place)
{
    return vec4(place.x * (2.0f / c->size[0]) - 1.0f, 1.0f - place.y * (2.0f / c->size[1]), place.z,
                1);
}

vertex_shader(few_vs, FlatPointsUniforms, Vertex, Few)
{
    *position = clip_position(c, in->position);
    *point_size = in->size;
    out->color = in->color;
    out->place = in->position;
}

vertex_shader(many_vs, FlatPointsUniforms, Vertex, Varying)
{
    *position = clip_position(c, in->position);
    *point_size = in->size;
    out->place = in->position;
    for (int i = 0; i < MANY; i++)
        out->value[i] = mul(in->color, 1.0f + (float)i);
}

/* Values past 1 and below 0 too. */
GP_INLINE float4 color_at(float4 color, float3 place, float2 pixel)
{
    float2 from = vec2(pixel.x - place.x, pixel.y - place.y);
    return vec4(color.x + from.x * 0.1f, color.y + from.y * 0.1f, color.z,
                color.w - 0.05f * from.x);
}

pixel_shader(few_ps, FlatPointsUniforms, Few)
{
    return color_at(in->color, in->place, vpos());
}

pixel_shader(few_discard_ps, FlatPointsUniforms, Few)
{
    float2 pixel = vpos();
    discard((frc(pixel.x * 0.25f + pixel.y * 0.5f) < 0.3f) | (in->color.x < 0.2f));
    return color_at(in->color, in->place, pixel);
}

pixel_shader_targets(many_ps, FlatPointsUniforms, Varying, FourTargets)
{
    for (int i = 0; i < 4; i++) {
        float4 value = sub(in->value[i + 4], in->value[i]);
        out->target[i] = color_at(value, in->place, vpos());
    }
}

program(flat_points, few_vs, few_ps, .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0,
        .inputs = INPUTS, .varyings = { { "color", 4, GP_FLAT }, { "place", 3, GP_FLAT } },
        .writes_point_size = true, .uses_pixel = true)
program(flat_points_discard, few_vs, few_discard_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = INPUTS,
        .varyings = { { "color", 4, GP_FLAT }, { "place", 3, GP_FLAT } }, .may_discard = true,
        .writes_point_size = true, .uses_pixel = true)
program(flat_points_targets4, many_vs, many_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = INPUTS,
        .varyings = { { "value0", 4, GP_FLAT },
                      { "value1", 4, GP_FLAT },
                      { "value2", 4, GP_FLAT },
                      { "value3", 4, GP_FLAT },
                      { "value4", 4, GP_FLAT },
                      { "value5", 4, GP_FLAT },
                      { "value6", 4, GP_FLAT },
                      { "value7", 4, GP_FLAT },
                      { "place", 3, GP_FLAT } },
        .writes_point_size = true, .uses_pixel = true)
