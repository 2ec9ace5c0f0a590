/* Packets that go through the shader side by side, and shaders in parts beside the same in one. */
#define GP_SHADER_AT_ONCE 4
#include "tests/shaders/exercise.h"
#include "tests/shaders/exercise_shared.h"

/* clang-format off */
#define PROFILES .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0, .inputs = INPUTS
/* clang-format on */

/* --- few varyings ----------------------------------------------------------------------------- */

colored_vertex_shader(at_once_vs);

pixel_shader(at_once_ps, ExerciseUniforms, OneColor)
{
    return mad(in->color, in->color.w, mul(in->color, u4(c->color)));
}

pixel_shader_begin(few_ps, ExerciseUniforms, OneColor, float4)
{
    return mul(in->color, u4(c->color));
}

pixel_shader_end(few_ps, ExerciseUniforms, OneColor, float4)
{
    return mad(in->color, in->color.w, *begun);
}

program(exercise_at_once, at_once_vs, at_once_ps, PROFILES,
        .varyings = { { "color", 4, GP_PERSPECTIVE } })
program(exercise_few_in_parts, at_once_vs, few_ps, PROFILES,
        .varyings = { { "color", 4, GP_PERSPECTIVE } })

/* --- more of them, a texture, and fragments that either part discards ------------------------- */

typedef struct Varying {
    float4 color;
    float2 uv;
} Varying;

vertex_shader(parts_vs, ExerciseUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->matrix);
    out->color = in->color;
    out->uv = in->uv;
}

GP_INLINE float4 read(GpInvocation *gp, const Varying *in)
{
    discard(in->color.x < 0.25f);
    return texld(0, in->uv);
}

GP_INLINE float4 mix(GpInvocation *gp, const ExerciseUniforms *c, const Varying *in, float4 texel)
{
    discard(in->color.y > 0.75f);
    return mad(texel, in->color, u4(c->color));
}

pixel_shader(whole_ps, ExerciseUniforms, Varying)
{
    return mix(gp, c, in, read(gp, in));
}

pixel_shader_begin(parts_ps, ExerciseUniforms, Varying, float4)
{
    return read(gp, in);
}

pixel_shader_end(parts_ps, ExerciseUniforms, Varying, float4)
{
    return mix(gp, c, in, *begun);
}

/* clang-format off */
#define TWO_VARYINGS \
    .varyings = { { "color", 4, GP_PERSPECTIVE }, { "uv", 2, GP_PERSPECTIVE } }, .may_discard = true
#define PARTS PROFILES, TWO_VARYINGS, .samplers = 1 << 0
program(exercise_whole, parts_vs, whole_ps, PARTS)
program(exercise_in_parts, parts_vs, parts_ps, PARTS)
/* clang-format on */

/* --- turns, some of which discard, and lanes that have turned enough at different times ------- */

enum { TURNS = 9 };

/* Adds to the sums that are not long enough. */
GP_INLINE msk lengthen(GpInvocation *gp, const ExerciseUniforms *c, const Varying *in, float4 *sum)
{
    msk is_short = dp4(*sum, *sum) < 2.0f;
    *sum = sel(is_short, mad(in->color, u4(c->color), *sum), *sum);
    discard(sum->x > 0.95f);
    return is_short;
}

pixel_shader(looped_ps, ExerciseUniforms, Varying)
{
    float4 sum = in->color;
    msk is_short = sum.x == sum.x;
    for (int i = 0; i < TURNS && any(is_short); i++)
        is_short = lengthen(gp, c, in, &sum);
    return sum;
}

pixel_shader_begin_turns(turns_ps, ExerciseUniforms, Varying, float4, TURNS)
{
    return in->color;
}

pixel_shader_turn(turns_ps, ExerciseUniforms, Varying, float4)
{
    return lengthen(gp, c, in, begun);
}

pixel_shader_end(turns_ps, ExerciseUniforms, Varying, float4)
{
    return *begun;
}

/* clang-format off */
#define TURNING .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0, .inputs = INPUTS, TWO_VARYINGS
program(exercise_looped, parts_vs, looped_ps, TURNING)
program(exercise_in_turns, parts_vs, turns_ps, TURNING)
/* clang-format on */
