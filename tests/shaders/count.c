/* Programs whose cost is known by hand: see count.h. */
#include <glasspipe/shader.h>
#include "tests/shaders/count.h"

typedef struct Vertex {
    float4 position, color;
} Vertex;

typedef struct Varying {
    float4 a, b;
    float2 uv;
} Varying;

typedef struct TwoTargets {
    float4 first, second;
} TwoTargets;

#define INPUTS                                                                                     \
    {                                                                                              \
        { GP_POSITION, 4 },                                                                        \
        {                                                                                          \
            GP_COLOR, 4                                                                            \
        }                                                                                          \
    }
#define VARYINGS                                                                                   \
    {                                                                                              \
        { "a", 4, GP_PERSPECTIVE }, { "b", 4, GP_PERSPECTIVE },                                    \
        {                                                                                          \
            "uv", 2, GP_PERSPECTIVE                                                                \
        }                                                                                          \
    }

GP_INLINE float4 four(float3 a)
{
    return vec4(a.x, a.y, a.z, a.x);
}

vertex_shader(count_vs, CountUniforms, Vertex, Varying)
{
    *position = in->position;
    out->a = in->color;
    out->b = in->position;
    out->uv = xy(in->color);
}

/* --- one instruction each --------------------------------------------------------------------- */

#define COUNT_DEFINE(id, value, vs_profile, ps_profile, ...)                                       \
    pixel_shader(id##_ps, CountUniforms, Varying)                                                  \
    {                                                                                              \
        __attribute__((unused)) flt s = in->a.x, t = in->b.x;                                      \
        __attribute__((unused)) float3 p = xyz(in->a), q = xyz(in->b);                             \
        return value;                                                                              \
    }                                                                                              \
    program(count_##id, count_vs, id##_ps, .vertex_profile = vs_profile,                           \
            .pixel_profile = ps_profile, .inputs = INPUTS, .varyings = VARYINGS, __VA_ARGS__)

#define DEFINE_3(id, arithmetic, texture, value)                                                   \
    COUNT_DEFINE(id, value, GP_VS_3_0, GP_PS_3_0, .samplers = 1, .local_reads = 2,                 \
                 .uses_derivatives = true)
#define DEFINE_2(id, arithmetic, texture, value)                                                   \
    COUNT_DEFINE(id, value, GP_VS_2_0, GP_PS_2_0, .samplers = 1, .uses_derivatives = true)

COUNT_INSTRUCTIONS(DEFINE_3)
COUNT_INSTRUCTIONS_2(DEFINE_2)

/* --- whole shaders, model 2 ------------------------------------------------------------------- */

#define SHADER(id) pixel_shader(id##_ps, CountUniforms, Varying)
#define PROGRAM(id, ...)                                                                           \
    program(count_##id, count_vs, id##_ps, .vertex_profile = GP_VS_2_0,                            \
            .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS, __VA_ARGS__)

SHADER(kills_2)
{
    texkill(xyz(in->a));
    discard(in->b.x > 1.0f);
    return in->a;
}
PROGRAM(kills_2, .may_discard = true)
program(count_kills, count_vs, kills_2_ps, .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0,
        .inputs = INPUTS, .varyings = VARYINGS, .may_discard = true)

SHADER(lean)
{
    return mul(in->a, c->one);
}
PROGRAM(lean, .samplers = 0)

SHADER(with_dead_code)
{
    float4 unused = texld(0, xy(in->b));
    for (int i = 0; i < 20; i++)
        unused = mad(unused, in->b, u4(c->many[i]));
    float4 both = add(mul(in->a, c->one), mul(unused, 0.25f));
    both = mul(in->a, c->one);
    return both;
}
PROGRAM(with_dead_code, .samplers = 1)

SHADER(one_component)
{
    float4 sum = add(in->a, in->b);
    return sp4(sum.y);
}
PROGRAM(one_component, .samplers = 0)

SHADER(order0)
{
    return add(texld(0, in->uv), texldp(1, in->a));
}
PROGRAM(order0, .samplers = 3)

SHADER(swizzled)
{
    return texld(0, vec2(in->uv.y, in->uv.x));
}
PROGRAM(swizzled, .samplers = 1)

SHADER(order1)
{
    return texld(0, add(in->uv, 0.5f));
}
PROGRAM(order1, .samplers = 1)

SHADER(order2)
{
    return texld(1, xy(texld(0, add(in->uv, 0.5f))));
}
PROGRAM(order2, .samplers = 3)

/* Three reads one after the other, the first in the order of its coordinate. */
GP_INLINE float4 chain(GpInvocation *gp, float4 coordinate)
{
    float4 first = texld(0, xy(coordinate));
    float4 second = texld(0, xy(mul(first, 0.5f)));
    return texld(0, xy(second));
}

SHADER(order3)
{
    return chain(gp, mul(in->a, in->b));
}
PROGRAM(order3, .samplers = 1)

SHADER(order4)
{
    return chain(gp, texld(0, mul(in->uv, 2)));
}
PROGRAM(order4, .samplers = 1)

GP_INLINE float4 multiply_add(float4 value, int times)
{
    float4 result = value;
    for (int i = 0; i < times; i++)
        result = mad(result, value, value);
    return result;
}

SHADER(over_slots)
{
    return multiply_add(in->a, 100);
}
PROGRAM(over_slots, .samplers = 0)

SHADER(full_arithmetic)
{
    return multiply_add(in->a, 63);
}
PROGRAM(full_arithmetic, .samplers = 0)

SHADER(over_arithmetic)
{
    return multiply_add(in->a, 64);
}
PROGRAM(over_arithmetic, .samplers = 0)

SHADER(over_reads)
{
    float4 sum = in->a;
    for (int i = 0; i < 33; i++)
        sum = add(sum, texld(0, in->uv));
    return sum;
}
PROGRAM(over_reads, .samplers = 1)

SHADER(over_constants)
{
    float4 sum = in->a;
    for (int i = 0; i < 33; i++)
        sum = add(sum, u4(c->many[i]));
    return sum;
}
PROGRAM(over_constants, .samplers = 0)

SHADER(numbers)
{
    float3 v = mad(u3(c->many[0]), 0.5f, xyz(in->a));
    v = mad(v, -0.5f, 2);
    return sp4(dp3(v, vec3(3, 4, 2)));
}
PROGRAM(numbers, .samplers = 0)

SHADER(three)
{
    float4 sum = add(in->a, in->b), difference = sub(in->a, in->b), product = mul(in->a, in->b);
    return mad(sum, difference, product);
}
PROGRAM(three, .samplers = 0)

SHADER(shared)
{
    float3 sum = add(xyz(in->a), xyz(in->b));
    return four(mul(sum, dp3(xyz(in->a), xyz(in->b))));
}
PROGRAM(shared, .samplers = 0)

SHADER(two)
{
    float3 sum = add(xyz(in->a), xyz(in->b)), difference = sub(xyz(in->a), xyz(in->b));
    return four(mul(sum, difference));
}
PROGRAM(two, .samplers = 0)

SHADER(over_temporaries)
{
    float4 sum = mul(in->a, u4(c->many[12]));
    for (int i = 11; i >= 0; i--)
        sum = add(mul(in->a, u4(c->many[i])), sum);
    return sum;
}
PROGRAM(over_temporaries, .samplers = 0)

SHADER(gradients)
{
    return add(dsx(in->a), dsy(in->a));
}
PROGRAM(gradients, .uses_derivatives = true)

SHADER(explicit_level)
{
    return texldl(0, in->a);
}
PROGRAM(explicit_level, .samplers = 1)

/* The loop's body stands there once, whatever its turns: 8 slots of the loop, and 2 adds. */
SHADER(looping)
{
    float4 sum = in->a;
    loop_while(100, sum.x < 0.0f)
    {
        sum = add(add(sum, in->b), in->b);
    }
    return sum;
}
PROGRAM(looping, .samplers = 0)
program(count_looping_3, count_vs, looping_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = INPUTS, .varyings = VARYINGS)

/* A loop of C, which is written out: each addition waits for the one before. */
SHADER(chain)
{
    float4 sum = in->a;
    for (int i = 0; i < COUNT_CHAIN; i++)
        sum = add(sum, in->b);
    return sum;
}
program(count_chain, count_vs, chain_ps, .inputs = INPUTS, .varyings = VARYINGS)

SHADER(place)
{
    return vec4(vpos().x, vpos().y, 0, 1);
}
PROGRAM(place, .uses_pixel = true)

SHADER(facing)
{
    return mul(in->a, vface());
}
PROGRAM(facing, .uses_face = true)

/* --- vertex shaders, and outputs -------------------------------------------------------------- */

vertex_shader(long_vs, CountUniforms, Vertex, Varying)
{
    *position = multiply_add(in->position, 254);
    out->a = in->color;
    out->b = in->color;
    out->uv = xy(mul(in->color, c->one));
}
program(count_long_vertex, long_vs, lean_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS)

vertex_shader(sat_vs, CountUniforms, Vertex, Varying)
{
    *position = in->position;
    out->a = sat(in->color);
    out->b = in->color;
    out->uv = xy(in->color);
}
program(count_vertex_sat, sat_vs, lean_ps, .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0,
        .inputs = INPUTS, .varyings = VARYINGS)

vertex_shader(texture_vs, CountUniforms, Vertex, Varying)
{
    *position = in->position;
    out->a = texldl(2, in->color);
    out->b = texldl(2, mul(out->a, 2));
    out->uv = xy(in->color);
}
program(count_vertex_texture, texture_vs, lean_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = INPUTS, .varyings = VARYINGS,
        .vertex_samplers = 1 << 2)

vertex_shader(texld_vs, CountUniforms, Vertex, Varying)
{
    *position = in->position;
    out->a = texld(2, xy(in->color));
}
program(count_vertex_texld, texld_vs, lean_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = INPUTS, .varyings = VARYINGS,
        .vertex_samplers = 1 << 2)

vertex_shader(extras_vs, CountUniforms, Vertex, Varying)
{
    *position = in->position;
    *point_size = mul(in->color.w, 2);
    out->a = in->color;
}
SHADER(extras)
{
    odepth(in->a.x * in->a.y);
    return in->a;
}
program(count_extras, extras_vs, extras_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = INPUTS, .varyings = VARYINGS, .writes_depth = true, .writes_point_size = true)

vertex_shader(partial_vs, CountUniforms, Vertex, Varying)
{
    *position = in->position;
    out->a = in->color;
    out->b.x = in->color.x;
}
program(count_unwritten_varying, partial_vs, one_component_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS)

pixel_shader_targets(partial_ps, CountUniforms, Varying, TwoTargets)
{
    out->first = in->a;
    out->second.x = in->a.x;
}
program(count_unwritten_target, count_vs, partial_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS)
