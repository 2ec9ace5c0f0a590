/* As many inputs and varyings as there may be: every semantic, and ten interpolants, of four
 * components. */
#include "tests/shaders/exercise.h"

#include <glasspipe/shader.h>

typedef struct Vertex {
    float4 position, normal, color, texcoord0, texcoord1, texcoord2, texcoord3, tangent, point_size;
} Vertex;

typedef struct Varying {
    float4 v0, v1, v2, v3, v4, v5, v6, v7, v8, v9;
} Varying;

/* clang-format off */
#define INPUTS \
    { { GP_POSITION, 4 }, { GP_NORMAL, 4 }, { GP_COLOR, 4 }, { GP_TEXCOORD0, 4 }, { GP_TEXCOORD1, 4 }, \
      { GP_TEXCOORD2, 4 }, { GP_TEXCOORD3, 4 }, { GP_TANGENT, 4 }, { GP_POINT_SIZE, 4 } }
#define VARYINGS \
    { { "v0", 4, GP_PERSPECTIVE }, { "v1", 4, GP_LINEAR_SCREEN }, { "v2", 4, GP_FLAT }, \
      { "v3", 4, GP_PERSPECTIVE }, { "v4", 4, GP_PERSPECTIVE }, { "v5", 4, GP_PERSPECTIVE }, \
      { "v6", 4, GP_LINEAR_SCREEN }, { "v7", 4, GP_PERSPECTIVE }, { "v8", 4, GP_FLAT }, \
      { "v9", 4, GP_PERSPECTIVE } }
/* clang-format on */

/* Each its own multiple of an input. */
vertex_shader(wide_vs, ExerciseUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->matrix);
    out->v0 = in->color;
    out->v1 = mul(in->normal, 2);
    out->v2 = mul(in->texcoord0, 3);
    out->v3 = mul(in->texcoord1, 4);
    out->v4 = mul(in->texcoord2, 5);
    out->v5 = mul(in->texcoord3, 6);
    out->v6 = mul(in->tangent, 7);
    out->v7 = mul(in->point_size, 8);
    out->v8 = mul(in->color, 9);
    out->v9 = mul(in->normal, 10);
}

/* The sum of all: 55 times an input, where all are alike. */
pixel_shader(wide_ps, ExerciseUniforms, Varying)
{
    float4 sum = add(add(in->v0, in->v1), add(in->v2, in->v3));
    sum = add(sum, add(add(in->v4, in->v5), add(in->v6, in->v7)));
    return add(sum, add(in->v8, in->v9));
}

program(exercise_wide, wide_vs, wide_ps, .vertex_profile = GP_VS_2_SW, .pixel_profile = GP_PS_2_SW,
        .inputs = INPUTS, .varyings = VARYINGS)
