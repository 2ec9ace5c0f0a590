/* Every texture read: implicit, projected, biased, explicit, by gradients, dependent, in place, and
 * from the vertex shader. Slots 0 to 2; slot 3 is read in place. */
#include "tests/shaders/exercise.h"
#include "tests/shaders/exercise_shared.h"

typedef struct Varying {
    float4 color;
    float2 uv;
} Varying;

/* clang-format off */
#define VARYINGS { { "color", 4, GP_PERSPECTIVE }, { "uv", 2, GP_PERSPECTIVE } }
/* clang-format on */

vertex_shader(texture_vs, ExerciseUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->matrix);
    out->color = in->color;
    out->uv = mul(in->uv, u2(c->scale));
}

vertex_shader(displaced_vs, ExerciseUniforms, Vertex, Varying)
{
    float4 height = texldl(0, vec4(in->uv.x, in->uv.y, 0, 0));
    *position = add(m4x4(in->position, c->matrix), mul(height, 0.0625f));
    out->color = height;
    out->uv = in->uv;
}

pixel_shader(texture_ps, ExerciseUniforms, Varying)
{
    float4 plain = texld(0, in->uv);
    float4 projected = texldp(1, vec4(in->uv.x, in->uv.y, in->color.x, add(in->color.w, 1)));
    return mad(plain, in->color, projected);
}

pixel_shader(dependent_ps, ExerciseUniforms, Varying)
{
    float4 first = texldb(0, vec4(in->uv.x, in->uv.y, 0, c->scale[2]));
    float2 at = add(xy(first), in->uv);
    float4 second = texldl(1, vec4(at.x, at.y, first.z, in->color.z));
    float4 third = texldd(2, xy(second), vec2(in->color.x, 0), vec2(0, in->color.y));
    return lrp(in->color.w, second, third);
}

pixel_shader(local_ps, ExerciseUniforms, Varying)
{
    return add(gp_load_local(3), mul(in->color, u4(c->color)));
}

program(exercise_texture, texture_vs, texture_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS,
        .samplers = 1 << 0 | 1 << 1)
program(exercise_dependent, texture_vs, dependent_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = INPUTS, .varyings = VARYINGS,
        .samplers = 1 << 0 | 1 << 1 | 1 << 2)
program(exercise_local, texture_vs, local_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS, .local_reads = 1 << 3)
program(exercise_vertex_texture, displaced_vs, texture_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = INPUTS, .varyings = VARYINGS,
        .samplers = 1 << 0 | 1 << 1, .vertex_samplers = 1 << 0)
