/* Small programs that between them use every feature of the shader language; for random scenes. */
#ifndef TESTS_SHADERS_EXERCISE_H
#define TESTS_SHADERS_EXERCISE_H

#include "pipeline/shader/program.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One uniform struct serves all of them. */
typedef struct ExerciseUniforms {
    float matrix[4][4]; /* clip to clip */
    float color[4];
    float scale[4]; /* of texture coordinates, and thresholds */
} ExerciseUniforms;

/* Inputs of all: GP_POSITION 4 (clip space), GP_COLOR 4, GP_TEXCOORD0 2; of exercise_wide four of
 * each. */
extern const GpProgram exercise_color, exercise_targets2, exercise_targets4, exercise_texture,
    exercise_dependent, exercise_discard, exercise_depth, exercise_derivatives, exercise_math,
    exercise_local, exercise_vertex_texture, exercise_point, exercise_depth_only, exercise_position,
    exercise_flat, exercise_at_once, exercise_few_in_parts, exercise_whole, exercise_in_parts,
    exercise_looped, exercise_in_turns, exercise_wide;

#ifdef __cplusplus
}
#endif

#endif
