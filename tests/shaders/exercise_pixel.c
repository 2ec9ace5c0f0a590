/* Discard, depth output, derivatives, the whole mathematics, and point sprites. */
#include "tests/shaders/exercise.h"
#include "tests/shaders/exercise_shared.h"

typedef struct Varying {
    float2 sprite;
    float4 color;
} Varying;

/* clang-format off */
#define VARYINGS { { "sprite", 2, GP_SPRITE_COORD }, { "color", 4, GP_PERSPECTIVE } }
/* clang-format on */

vertex_shader(plain_vs, ExerciseUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->matrix);
    out->sprite = in->uv;
    out->color = in->color;
}

vertex_shader(sized_vs, ExerciseUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->matrix);
    out->sprite = in->uv;
    out->color = in->color;
    *point_size = mad(in->color.x, c->scale[3], bcast(1));
}

pixel_shader(discard_ps, ExerciseUniforms, Varying)
{
    texkill(sub(xyz(in->color), c->scale[2]));
    discard(in->sprite.x > 0.9f);
    return in->color;
}

pixel_shader(depth_ps, ExerciseUniforms, Varying)
{
    odepth(mad(in->color.x, in->color.y, in->sprite.x));
    return in->color;
}

pixel_shader(derivatives_ps, ExerciseUniforms, Varying)
{
    float4 squared = mul(in->color, in->color);
    float4 slope = add(abs_(dsx(squared)), abs_(dsy(squared)));
    return mad(slope, 16, mul(in->color, 0.25f));
}

pixel_shader(math_ps, ExerciseUniforms, Varying)
{
    float3 n = nrm(sub(xyz(in->color), 0.5f));
    flt waves = sin_(in->sprite.x * 20.0f) * cos_(in->sprite.y * 20.0f);
    flt power = pow_(in->color.w, mad(in->color.x, 8, bcast(0.5f)));
    float4 light = lit(n.x, n.y, in->color.z * 32.0f);
    flt logs = log_(max(in->color.y, 0)) * exp_(-in->color.z);
    flt bands = floor_(in->sprite.x * 8.0f) * rcp(in->sprite.y + 2.0f);
    float3 both = crs(n, vec3(waves, power, light.z));
    flt far = dp3(both, both) * rsq(dp4(in->color, in->color));
    return vec4(frc(waves + bands), sat(power), cmp(logs, light.y, far), sel(far > 0.5f, far, 1));
}

program(exercise_discard, plain_vs, discard_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS, .may_discard = true)
program(exercise_depth, plain_vs, depth_ps, .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,
        .inputs = INPUTS, .varyings = VARYINGS, .writes_depth = true)
program(exercise_derivatives, plain_vs, derivatives_ps, .vertex_profile = GP_VS_3_0,
        .pixel_profile = GP_PS_3_0, .inputs = INPUTS, .varyings = VARYINGS,
        .uses_derivatives = true)
program(exercise_math, plain_vs, math_ps, .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0,
        .inputs = INPUTS, .varyings = VARYINGS)
program(exercise_point, sized_vs, discard_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = INPUTS, .varyings = VARYINGS, .may_discard = true,
        .writes_point_size = true)
