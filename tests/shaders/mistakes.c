/* Programs with one mistake of declaration each: see mistakes.h. */
#include <glasspipe/shader.h>
#include "tests/shaders/mistakes.h"

typedef struct Vertex {
    float2 position;
    float3 color;
} Vertex;

typedef struct Equal {
    float3 position, normal;
} Equal;

typedef struct Varying {
    float3 color;
    float2 place;
} Varying;

typedef struct Targets {
    float4 first, second;
} Targets;

/* clang-format off */
#define INPUTS   .inputs = { { GP_POSITION, 2 }, { GP_COLOR, 3 } }
#define VARYINGS .varyings = { { "color", 3, GP_PERSPECTIVE }, { "place", 2, GP_PERSPECTIVE } }
/* clang-format on */

#define VERTEX_SHADER(name) vertex_shader(name, MistakesUniforms, Vertex, Varying)
#define PIXEL_SHADER(name)  pixel_shader(name, MistakesUniforms, Varying)

GP_INLINE void transform(const MistakesUniforms *c, const Vertex *in, float4 *position,
                         Varying *out)
{
    *position = vec4(in->position.x * c->scale, in->position.y * c->scale, 0.5f, 1);
    out->color = in->color;
    out->place = in->position;
}

VERTEX_SHADER(plain_vs)
{
    transform(c, in, position, out);
}
VERTEX_SHADER(size_vs)
{
    transform(c, in, position, out);
    *point_size = in->color.x * 3.0f;
}
VERTEX_SHADER(texture_vs)
{
    transform(c, in, position, out);
    out->color = xyz(texldl(3, vec4(in->position.x, in->position.y, 0, 0)));
}
VERTEX_SHADER(place_vs)
{
    transform(c, in, position, out);
    out->place = vpos();
}
VERTEX_SHADER(no_varying_vs)
{
    Varying whole;
    transform(c, in, position, &whole);
    out->color = in->color;
    out->place.x = in->position.x;
}

PIXEL_SHADER(plain_ps)
{
    return rgba(in->color, in->place.y);
}
PIXEL_SHADER(samplers_ps)
{
    return texld(5, in->place);
}
PIXEL_SHADER(loop_ps)
{
    float4 sum = sp4(bcast(0));
    flt left = in->place.x;
    for (int i = 0; i < 4 && any(left > 0.5f); i++) {
        sum = add(sum, texldl(5, vec4(in->place.x, left, 0, 0)));
        left = left - 1.0f;
    }
    return sum;
}
PIXEL_SHADER(slot_ps)
{
    return texld(16, in->place);
}
PIXEL_SHADER(negative_slot_ps)
{
    return texld(-1, in->place);
}
PIXEL_SHADER(far_slot_ps)
{
    return texld(40, in->place);
}
PIXEL_SHADER(local_ps)
{
    return gp_load_local(2);
}
PIXEL_SHADER(discard_ps)
{
    discard(in->place.x > 1000.0f);
    return rgba(in->color, 1);
}
PIXEL_SHADER(texkill_ps)
{
    texkill(in->color);
    return rgba(in->color, 1);
}
PIXEL_SHADER(depth_ps)
{
    odepth(in->place.x);
    return rgba(in->color, 1);
}
PIXEL_SHADER(pixel_ps)
{
    return rgba(in->color, vpos().x);
}
PIXEL_SHADER(face_ps)
{
    return rgba(in->color, vface());
}
PIXEL_SHADER(derivatives_ps)
{
    return rgba(dsy(in->color), 1);
}
pixel_shader_targets(target_ps, MistakesUniforms, Varying, Targets)
{
    out->first = rgba(in->color, 1);
    out->second.x = in->color.x;
}

program(mistake_none, size_vs, discard_ps, VARYINGS, .may_discard = true, INPUTS,
        .pixel_profile = GP_PS_2_0, .writes_point_size = true, .vertex_profile = GP_VS_2_0)

#define MISTAKE(field, vs, ps, ...)                                                                \
    program(mistake_##field, vs, ps, INPUTS, VARYINGS, ##__VA_ARGS__)

MISTAKE(samplers, plain_vs, samplers_ps)
MISTAKE(samplers_in_loop, plain_vs, loop_ps)
MISTAKE(vertex_samplers, texture_vs, plain_ps)
MISTAKE(local_reads, plain_vs, local_ps)
MISTAKE(may_discard, plain_vs, discard_ps)
MISTAKE(texkill, plain_vs, texkill_ps)
MISTAKE(writes_depth, plain_vs, depth_ps)
MISTAKE(writes_point_size, size_vs, plain_ps)
MISTAKE(uses_pixel, plain_vs, pixel_ps)
MISTAKE(uses_face, plain_vs, face_ps)
MISTAKE(uses_derivatives, plain_vs, derivatives_ps)
MISTAKE(slot, plain_vs, slot_ps, .samplers = 0xffff)
MISTAKE(negative_slot, plain_vs, negative_slot_ps)
MISTAKE(far_slot, plain_vs, far_slot_ps)
MISTAKE(no_depth, plain_vs, plain_ps, .writes_depth = true)
MISTAKE(no_point_size, plain_vs, plain_ps, .writes_point_size = true)
MISTAKE(varying_unwritten, no_varying_vs, plain_ps)
MISTAKE(target_unwritten, plain_vs, target_ps)
MISTAKE(vertex_place, place_vs, plain_ps)

program(mistake_inputs_swapped, plain_vs, plain_ps, VARYINGS,
        .inputs = { { GP_COLOR, 3 }, { GP_POSITION, 2 } })
program(mistake_inputs_sum, plain_vs, plain_ps, VARYINGS,
        .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 3 } })
program(mistake_varyings_sum, plain_vs, plain_ps, INPUTS,
        .varyings = { { "color", 3, GP_PERSPECTIVE } })

vertex_shader(equal_vs, MistakesUniforms, Equal, Varying)
{
    *position = rgba(in->position, 1);
    out->color = in->normal;
    out->place = vec2(in->normal.x, c->scale);
}
program(mistake_inputs_swapped_equal, equal_vs, plain_ps, VARYINGS,
        .inputs = { { GP_COLOR, 3 }, { GP_POSITION, 3 } })

VERTEX_SHADER(no_position_vs)
{
    float4 other;
    transform(c, in, &other, out);
    position->x = other.x;
    position->y = other.y;
}
program(mistake_position_unwritten, no_position_vs, plain_ps, INPUTS, VARYINGS)

typedef struct Named {
    float2 position;
    float3 normal, color;
} Named;

vertex_shader(named_vs, MistakesUniforms, Named, Varying)
{
    *position = vec4(in->position.x, in->position.y, 0.5f, 1);
    out->color = mul(in->color, in->normal.x);
    out->place = in->position;
}
program(mistake_inputs_named, named_vs, plain_ps, VARYINGS,
        .inputs = { { GP_POSITION, 2 }, { GP_COLOR, 3 }, { GP_NORMAL, 3 } })
