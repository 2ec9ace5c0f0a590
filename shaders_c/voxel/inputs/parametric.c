/* Parametric surfaces as voxels.
 * source Dong, Chen, Bao, Zhang and Peng, "Real-time voxelization for complex polygonal models",
 *        Pacific Graphics 2004: parametric surfaces evaluated in the vertex shader. DEVIATES:
 *        theirs are points, each of which sets its voxel; what the surface only grazes between them
 *        is lost, however close they are. */
#define GP_SHADER_AT_ONCE 4
#include "shaders_c/voxel/inputs/parametric.h"
#include "shaders_c/voxel/methods/columns_shared.h"

#define TURN 6.28318530717958647692f

typedef struct UvVertex {
    float2 a, b, c;
} UvVertex;

/* --- surfaces --------------------------------------------------------------------------------- */

GP_INLINE float3 sphere(const VoxelParametricUniforms *c, float2 uv)
{
    float2 around = sincos_(uv.x * TURN), up = sincos_((uv.y - 0.5f) * (TURN / 2));
    return mul(vec3(around.x * up.x, up.y, around.y * up.x), c->radius);
}

/* A place at a distance from the axis, in a direction round it. */
GP_INLINE float3 round_axis(flt distance, flt height, float2 around)
{
    return vec3(distance * around.x, height, distance * around.y);
}

GP_INLINE float3 torus(const VoxelParametricUniforms *c, float2 uv)
{
    float2 tube = mul(sincos_(uv.y * TURN), c->width);
    return round_axis(tube.x + c->radius, tube.y, sincos_(uv.x * TURN));
}

/* A band that makes half a turn about itself on its way round. */
GP_INLINE float3 moebius(const VoxelParametricUniforms *c, float2 uv)
{
    float2 half_turn = mul(sincos_(uv.x * (TURN / 2)), (uv.y - 0.5f) * c->width);
    return round_axis(half_turn.x + c->radius, half_turn.y, sincos_(uv.x * TURN));
}

/* A figure of eight that does. */
GP_INLINE float3 klein(const VoxelParametricUniforms *c, float2 uv)
{
    float2 half_turn = sincos_(uv.x * (TURN / 2));
    flt wide = sin_(uv.y * TURN), high = sin_(uv.y * (2 * TURN));
    return round_axis(half_turn.x * wide - half_turn.y * high + c->radius,
                      half_turn.y * wide + half_turn.x * high, sincos_(uv.x * TURN));
}

GP_INLINE float4 bernstein(flt t)
{
    flt s = 1.0f - t;
    return vec4(s * s * s, s * s * t * 3.0f, s * t * t * 3.0f, t * t * t);
}

GP_INLINE float3 bezier(const VoxelParametricUniforms *c, float2 uv)
{
    float4 by_u = bernstein(uv.x), by_v = bernstein(uv.y);
    const flt row_weight[4] = { by_v.x, by_v.y, by_v.z, by_v.w };
    float3 place = sp3(bcast(0));
    for (int row = 0; row < 4; row++) {
        const float(*p)[3] = c->control[row];
        float3 along = mad(u3(p[3]), by_u.w, mul(u3(p[2]), by_u.z));
        along = mad(u3(p[1]), by_u.y, along);
        along = mad(u3(p[0]), by_u.x, along);
        place = mad(along, row_weight[row], place);
    }
    return place;
}

/* --- programs --------------------------------------------------------------------------------- */

/* Three evaluations and a triangle's description are more slots than vs_3_0 has: a vertex shader of
 * software vertex processing, as the machine's makers gave it for what did not fit. */
/* clang-format off */
#define SURFACE(name)                                                                              \
    vertex_shader(voxel_##name##_vs, VoxelParametricUniforms, UvVertex, Varying)                   \
    {                                                                                              \
        const Vertex corners = { name(c, in->a), name(c, in->b), name(c, in->c) };                 \
        Placed triangle = place_touched(&c->columns, &corners, VOXEL_PARAMETRIC_MARGIN, out);      \
        describe_triangle(&triangle, 0.5f + VOXEL_PARAMETRIC_MARGIN, out);                         \
        *position = square_centre(&c->columns.flat, &triangle);                                    \
        *point_size = triangle.side;                                                               \
    }                                                                                              \
    program(voxel_##name##_program, voxel_##name##_vs, voxel_parametric_ps,                        \
            .vertex_profile = GP_VS_3_SW, .pixel_profile = GP_PS_3_0,                             \
            .inputs = { { GP_TEXCOORD0, 2 }, { GP_TEXCOORD1, 2 }, { GP_TEXCOORD2, 2 } },           \
            .varyings = VOXEL_COLUMNS_VARYINGS, .writes_point_size = true, .uses_pixel = true)

pixel_shader(voxel_parametric_ps, VoxelParametricUniforms, Varying)
{
    return touched_bits(in, vpos().x - in->place.x, vpos().y - in->place.y,
                        VOXEL_PARAMETRIC_MARGIN);
}

SURFACE(sphere)
SURFACE(torus)
SURFACE(moebius)
SURFACE(klein)
SURFACE(bezier)
/* clang-format on */
