/* What every exercise takes from its vertices. For shader files only. */
#ifndef TESTS_EXERCISE_SHARED_H
#define TESTS_EXERCISE_SHARED_H

#include <glasspipe/shader.h>

typedef struct Vertex {
    float4 position, color;
    float2 uv;
} Vertex;

typedef struct OneColor {
    float4 color;
} OneColor;

/* Gives pixels the colour alone. */
#define colored_vertex_shader(name)                                                                \
    vertex_shader(name, ExerciseUniforms, Vertex, OneColor)                                        \
    {                                                                                              \
        *position = m4x4(in->position, c->matrix);                                                 \
        out->color = in->color;                                                                    \
    }                                                                                              \
    struct name##_follows

/* clang-format off */
#define INPUTS { { GP_POSITION, 4 }, { GP_COLOR, 4 }, { GP_TEXCOORD0, 2 } }
/* clang-format on */

#endif
