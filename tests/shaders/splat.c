/* Splats of two targets.
 * source Zwicker et al., "Surface splatting" (2001), the resampling filter's conic */
#include <glasspipe/shader.h>
#include "tests/shaders/splat.h"

#define LOG2_E 1.44269504088896340736f

typedef struct Vertex {
    float3 position, color, normal, ellipse;
    flt size;
} Vertex;

typedef struct Varying {
    float2 sprite;
    float3 ellipse; /* in the square's own units, from its middle */
    float3 color, normal;
} Varying;

typedef struct Sums {
    float4 color, normal; /* both with the weight */
} Sums;

#define INPUTS                                                                                     \
    {                                                                                              \
        { GP_POSITION, 3 }, { GP_COLOR, 3 }, { GP_NORMAL, 3 }, { GP_TEXCOORD0, 3 },                \
        {                                                                                          \
            GP_POINT_SIZE, 1                                                                       \
        }                                                                                          \
    }
#define VARYINGS                                                                                   \
    {                                                                                              \
        { "sprite", 2, GP_SPRITE_COORD }, { "ellipse", 3, GP_FLAT }, { "color", 3, GP_FLAT },      \
        {                                                                                          \
            "normal", 3, GP_FLAT                                                                   \
        }                                                                                          \
    }

vertex_shader(splat_vs, SplatUniforms, Vertex, Varying)
{
    *position = vec4(in->position.x * (2.0f / c->size[0]) - 1.0f,
                     1.0f - in->position.y * (2.0f / c->size[1]), in->position.z, 1);
    *point_size = in->size;
    out->sprite = vec2(0, 0); /* of points it runs from 0 to 1 over the square */
    out->ellipse = mul(in->ellipse, in->size * in->size);
    out->color = in->color;
    out->normal = in->normal;
}

/* 1 on the ellipse. */
GP_INLINE flt square_radius(const Varying *in)
{
    flt x = in->sprite.x - 0.5f, y = in->sprite.y - 0.5f;
    return x * (in->ellipse.x * x + in->ellipse.y * y) + in->ellipse.z * y * y;
}

GP_INLINE void weigh(const Varying *in, flt square, Sums *out)
{
    flt weight = exp_(square * (-2 * LOG2_E));
    out->color = rgba(mul(in->color, weight), weight);
    out->normal = rgba(mul(in->normal, weight), weight);
}

pixel_shader_targets(splat_ps, SplatUniforms, Varying, Sums)
{
    flt square = square_radius(in);
    discard(square > 1.0f);
    weigh(in, square, out);
}

pixel_shader_targets(splat_square_ps, SplatUniforms, Varying, Sums)
{
    weigh(in, square_radius(in), out);
}

pixel_shader(splat_depth_ps, SplatUniforms, Varying)
{
    discard(square_radius(in) > 1.0f);
    return vec4(0, 0, 0, 0);
}

program(splat, splat_vs, splat_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = INPUTS, .varyings = VARYINGS, .may_discard = true, .writes_point_size = true)
program(splat_square, splat_vs, splat_square_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS,
        .writes_point_size = true)
program(splat_depth, splat_vs, splat_depth_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS, .may_discard = true,
        .writes_point_size = true)
