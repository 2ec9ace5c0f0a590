#include "shaders_c/points/disc_shared.h"

typedef struct RoundVarying {
    float2 sprite;
    float3 color;
} RoundVarying;

GP_INLINE EyeSurfel before_eye(const SplatUniforms *c, const SurfelVertex *in)
{
    return surfel_before_eye(c, in->position, in->normal, in->radius);
}

pixel_shader(flat_ps, SplatUniforms, FlatVarying)
{
    return rgba(in->color, 1);
}

pixel_shader(lit_flat_ps, LitPointUniforms, FlatVarying)
{
    return rgba(in->color, 1);
}

GP_INLINE float4 round_color(GpInvocation *gp, const RoundVarying *in)
{
    float2 p = mad(in->sprite, 2, -1);
    discard(dp2(p, p) > 1.0f);
    return rgba(in->color, 1);
}

pixel_shader(round_ps, SplatUniforms, RoundVarying)
{
    return round_color(gp, in);
}

pixel_shader(lit_round_ps, LitPointUniforms, RoundVarying)
{
    return round_color(gp, in);
}

/* --- as they are ------------------------------------------------------------------------------ */

vertex_shader(point_pixel_vs, SplatUniforms, SurfelVertex, FlatVarying)
{
    EyeSurfel eye = before_eye(c, in);
    *position = surfel_clip(c, &eye, bcast(0));
    out->color = surfel_color(c, in);
}

vertex_shader(point_square_vs, SplatUniforms, SurfelVertex, FlatVarying)
{
    EyeSurfel eye = before_eye(c, in);
    *position = surfel_clip(c, &eye, bcast(0));
    *point_size = disc_side(&eye);
    out->color = surfel_color(c, in);
}

vertex_shader(point_round_vs, SplatUniforms, SurfelVertex, RoundVarying)
{
    EyeSurfel eye = before_eye(c, in);
    *position = surfel_clip(c, &eye, bcast(0));
    *point_size = disc_side(&eye);
    out->sprite = vec2(0, 0); /* of points it runs from 0 to 1 over the square */
    out->color = surfel_color(c, in);
}

/* --- lit -------------------------------------------------------------------------------------- */

vertex_shader(lit_pixel_vs, LitPointUniforms, SurfelVertex, FlatVarying)
{
    EyeSurfel eye = before_eye(&c->splat, in);
    *position = surfel_clip(&c->splat, &eye, bcast(0));
    out->color = lit_color(c, in, &eye);
}

vertex_shader(lit_square_vs, LitPointUniforms, SurfelVertex, FlatVarying)
{
    EyeSurfel eye = before_eye(&c->splat, in);
    *position = surfel_clip(&c->splat, &eye, bcast(0));
    *point_size = disc_side(&eye);
    out->color = lit_color(c, in, &eye);
}

vertex_shader(lit_round_vs, LitPointUniforms, SurfelVertex, RoundVarying)
{
    EyeSurfel eye = before_eye(&c->splat, in);
    *position = surfel_clip(&c->splat, &eye, bcast(0));
    *point_size = disc_side(&eye);
    out->sprite = vec2(0, 0);
    out->color = lit_color(c, in, &eye);
}

/* clang-format off */
#define FLAT_DECLARATIONS                                                                          \
    MODEL_2_0, .inputs = { SURFEL_INPUTS }, .varyings = { { "color", 3, GP_FLAT } }
#define ROUND_DECLARATIONS                                                                         \
    MODEL_2_0, .inputs = { SURFEL_INPUTS },                                                        \
    .varyings = { { "sprite", 2, GP_SPRITE_COORD }, { "color", 3, GP_FLAT } },                     \
    .may_discard = true, .writes_point_size = true
/* clang-format on */

program(point_pixel_program, point_pixel_vs, flat_ps, FLAT_DECLARATIONS)
program(point_square_program, point_square_vs, flat_ps, FLAT_DECLARATIONS,
        .writes_point_size = true)
program(point_round_program, point_round_vs, round_ps, ROUND_DECLARATIONS)
program(lit_pixel_program, lit_pixel_vs, lit_flat_ps, FLAT_DECLARATIONS)
program(lit_square_program, lit_square_vs, lit_flat_ps, FLAT_DECLARATIONS,
        .writes_point_size = true)
program(lit_round_program, lit_round_vs, lit_round_ps, ROUND_DECLARATIONS)
