/* Few varyings, in packets that go through the shader in pairs. */
#define GP_SHADER_FOURS
#include "tests/shaders/exercise.h"
#include "tests/shaders/exercise_shared.h"

colored_vertex_shader(pairs_vs);

pixel_shader(pairs_ps, ExerciseUniforms, OneColor)
{
    return mad(in->color, in->color.w, mul(in->color, u4(c->color)));
}

program(exercise_pairs, pairs_vs, pairs_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = INPUTS, .varyings = { { "color", 4, GP_PERSPECTIVE } })
