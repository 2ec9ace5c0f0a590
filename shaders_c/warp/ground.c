#include "shaders_c/warp/ground.h"
#include "shaders_c/common/vertices_shared.h"

typedef struct GroundVertex {
    float2 spot;
} GroundVertex;

typedef struct GroundVarying {
    float2 spot; /* from which all else follows: fewer numbers to carry to each pixel */
} GroundVarying;

vertex_shader(ground_vs, GroundUniforms, GroundVertex, GroundVarying)
{
    *position = m4x4(vec3(in->spot.x, 0, in->spot.y), c->mvp);
    out->spot = in->spot;
}

GP_INLINE float3 color_at(GpInvocation *gp, const GroundUniforms *c, float2 spot)
{
    return xyz(texld(0, mul(spot, c->repeats)));
}

GP_INLINE flt map_row(const float row[3], float2 spot)
{
    return mad(spot.x, bcast(row[0]), mad(spot.y, bcast(row[1]), row[2]));
}

pixel_shader(ground_ps, GroundUniforms, GroundVarying)
{
    return rgba(mul(color_at(gp, c, in->spot), add(u3(c->ambient), u3(c->direct))), 1);
}

pixel_shader(ground_shadowed_ps, GroundUniforms, GroundVarying)
{
    float3 place = vec3(map_row(c->map[0], in->spot), map_row(c->map[1], in->spot),
                        map_row(c->map[2], in->spot));
    float3 light = mad(u3(c->direct), texld(1, place).x, u3(c->ambient));
    return rgba(mul(color_at(gp, c, in->spot), light), 1);
}

program(ground_program, ground_vs, ground_ps, MODEL_2_0, .inputs = { { GP_POSITION, 2 } },
        .varyings = { { "spot", 2, GP_PERSPECTIVE } }, .samplers = 1 << 0)
program(ground_shadowed_program, ground_vs, ground_shadowed_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 2 } }, .varyings = { { "spot", 2, GP_PERSPECTIVE } },
        .samplers = 1 << 0 | 1 << 1)
