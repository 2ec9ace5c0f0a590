/* Interpolants of all three kinds; many targets; colours from the pixel's place and facing. */
#include "tests/shaders/exercise.h"
#include "tests/shaders/exercise_shared.h"

typedef struct Varying {
    float4 color;
    float2 linear;
    flt flat;
} Varying;

typedef struct TwoTargets {
    float4 first, second;
} TwoTargets;

typedef struct FourTargets {
    float4 first, second, third, fourth;
} FourTargets;

/* clang-format off */
#define VARYINGS \
    { { "color", 4, GP_PERSPECTIVE }, { "linear", 2, GP_LINEAR_SCREEN }, { "flat", 1, GP_FLAT } }
/* clang-format on */

vertex_shader(color_vs, ExerciseUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->matrix);
    out->color = in->color;
    out->linear = in->uv;
    out->flat = in->color.x;
}

pixel_shader(color_ps, ExerciseUniforms, Varying)
{
    float3 color = mad(xyz(in->color), in->flat, xyz(u4(c->color)));
    return rgba(color, in->color.w + in->linear.x * in->linear.y);
}

/* One colour a triangle. */
colored_vertex_shader(flat_vs);

pixel_shader(flat_ps, ExerciseUniforms, OneColor)
{
    return mul(in->color, max(vface(), 0.5f));
}

pixel_shader_targets(two_ps, ExerciseUniforms, Varying, TwoTargets)
{
    out->first = mul(in->color, u4(c->color));
    out->second = vec4(in->linear.x, in->linear.y, in->flat, 1);
}

pixel_shader_targets(four_ps, ExerciseUniforms, Varying, FourTargets)
{
    out->first = in->color;
    out->second = u4(c->color);
    out->third = vec4(in->linear.x, in->linear.y, in->flat, 0.5f);
    out->fourth = sub(in->color, u4(c->color));
}

pixel_shader(position_ps, ExerciseUniforms, Varying)
{
    float2 at = vpos();
    return vec4(frc(at.x * 0.125f), frc(at.y * 0.0625f), max(vface(), 0), in->color.w);
}

program(exercise_color, color_vs, color_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = INPUTS, .varyings = VARYINGS)
program(exercise_targets2, color_vs, two_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS)
program(exercise_targets4, color_vs, four_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS)
program(exercise_position, color_vs, position_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = INPUTS, .varyings = VARYINGS, .uses_pixel = true,
        .uses_face = true)
depth_program(exercise_depth_only, color_vs, .vertex_profile = GP_VS_2_0, .inputs = INPUTS,
              .varyings = VARYINGS)
program(exercise_flat, flat_vs, flat_ps, .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0,
        .inputs = INPUTS, .varyings = { { "color", 4, GP_FLAT } }, .uses_face = true)
