/* Parametric surfaces, point by point.
 * source Dong, Chen, Bao, Zhang and Peng, "Real-time voxelization for complex polygonal models",
 *        Pacific Graphics 2004: parametric surfaces by points evaluated in the vertex shader */
#include "shaders_c/voxel/inputs/parametric.h"
#include "shaders_c/voxel/inputs/points_shared.h"

typedef struct Vertex {
    float2 uv;
} Vertex;

#define TURN 6.28318530717958647692f

vertex_shader(voxel_sphere_vs, VoxelParametricUniforms, Vertex, PointVarying)
{
    float2 around = sincos_(in->uv.x * TURN), up = sincos_((in->uv.y - 0.5f) * (TURN / 2));
    float3 place = mul(vec3(around.x * up.x, up.y, around.y * up.x), c->radius);
    *position = set_voxel(&c->place, place, out, point_size);
}

/* A place at a distance from the axis, in a direction round it. */
GP_INLINE float3 round_axis(flt distance, flt height, float2 around)
{
    return vec3(distance * around.x, height, distance * around.y);
}

vertex_shader(voxel_torus_vs, VoxelParametricUniforms, Vertex, PointVarying)
{
    float2 tube = mul(sincos_(in->uv.y * TURN), c->width);
    float3 place = round_axis(tube.x + c->radius, tube.y, sincos_(in->uv.x * TURN));
    *position = set_voxel(&c->place, place, out, point_size);
}

/* A band that makes half a turn about itself on its way round. */
vertex_shader(voxel_moebius_vs, VoxelParametricUniforms, Vertex, PointVarying)
{
    float2 half_turn = mul(sincos_(in->uv.x * (TURN / 2)), (in->uv.y - 0.5f) * c->width);
    float3 place = round_axis(half_turn.x + c->radius, half_turn.y, sincos_(in->uv.x * TURN));
    *position = set_voxel(&c->place, place, out, point_size);
}

/* A figure of eight that does. */
vertex_shader(voxel_klein_vs, VoxelParametricUniforms, Vertex, PointVarying)
{
    float2 half_turn = sincos_(in->uv.x * (TURN / 2));
    flt wide = sin_(in->uv.y * TURN), high = sin_(in->uv.y * (2 * TURN));
    float3 place = round_axis(half_turn.x * wide - half_turn.y * high + c->radius,
                              half_turn.y * wide + half_turn.x * high, sincos_(in->uv.x * TURN));
    *position = set_voxel(&c->place, place, out, point_size);
}

GP_INLINE float4 bernstein(flt t)
{
    flt s = 1.0f - t;
    return vec4(s * s * s, s * s * t * 3.0f, s * t * t * 3.0f, t * t * t);
}

vertex_shader(voxel_bezier_vs, VoxelParametricUniforms, Vertex, PointVarying)
{
    float4 by_u = bernstein(in->uv.x), by_v = bernstein(in->uv.y);
    const flt row_weight[4] = { by_v.x, by_v.y, by_v.z, by_v.w };
    float3 place = sp3(bcast(0));
    for (int row = 0; row < 4; row++) {
        const float(*p)[3] = c->control[row];
        float3 along = mad(u3(p[3]), by_u.w, mul(u3(p[2]), by_u.z));
        along = mad(u3(p[1]), by_u.y, along);
        along = mad(u3(p[0]), by_u.x, along);
        place = mad(along, row_weight[row], place);
    }
    *position = set_voxel(&c->place, place, out, point_size);
}

pixel_shader(voxel_parametric_ps, VoxelParametricUniforms, PointVarying)
{
    return in->bit;
}

/* clang-format off */
#define DECLARATIONS POINT_DECLARATIONS, .inputs = { { GP_TEXCOORD0, 2 } }, POINT_VARYINGS

program(voxel_sphere_program, voxel_sphere_vs, voxel_parametric_ps, DECLARATIONS)
program(voxel_torus_program, voxel_torus_vs, voxel_parametric_ps, DECLARATIONS)
program(voxel_moebius_program, voxel_moebius_vs, voxel_parametric_ps, DECLARATIONS)
program(voxel_klein_program, voxel_klein_vs, voxel_parametric_ps, DECLARATIONS)
program(voxel_bezier_program, voxel_bezier_vs, voxel_parametric_ps, DECLARATIONS)
/* clang-format on */
