/* Each point sets the voxel that it lies in.
 * source Dong, Chen, Bao, Zhang and Peng, "Real-time voxelization for complex polygonal models",
 *        Pacific Graphics 2004: parametric surfaces by points evaluated in the vertex shader */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/voxel/inputs/points.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"

typedef struct PointVarying {
    float4 bit; /* the voxel's, as a colour */
} PointVarying;

/* The texel of a position's voxel, in clip space; no size where the volume ends before. */
GP_INLINE float4 set_voxel(const VoxelPointsUniforms *c, float3 position, PointVarying *out,
                           flt *point_size)
{
    const FlatTextureLayout *flat = &c->flat;
    float3 voxel = floor_(mad(position, c->scale, u3(c->offset)));
    flt slab = floor_(voxel.z * (1.0f / 32)), bit = voxel.z - slab * 32.0f;
    flt low = min(min(voxel.x, voxel.y), voxel.z), high = max(max(voxel.x, voxel.y), voxel.z);
    *point_size = sge(low, 0) * slt(high, flat->size);
    out->bit = bits_between(bit, bit + 1.0f);
    float2 origin = patch_origin(flat, slab);
    return flat_position(flat, vec2(origin.x + voxel.x + 0.5f, origin.y + voxel.y + 0.5f));
}

/* clang-format off */
#define POINT_DECLARATIONS(...)                                                                    \
    MODEL_2_0, .inputs = { __VA_ARGS__ }, .varyings = { { "bit", 4, GP_FLAT } },                   \
    .writes_point_size = true
/* clang-format on */

/* --- given ------------------------------------------------------------------------------------ */

vertex_shader(voxel_points_vs, VoxelPointsUniforms, PointVertex, PointVarying)
{
    *position = set_voxel(c, in->position, out, point_size);
}

pixel_shader(voxel_points_ps, VoxelPointsUniforms, PointVarying)
{
    return in->bit;
}

program(voxel_points_program, voxel_points_vs, voxel_points_ps,
        POINT_DECLARATIONS({ GP_POSITION, 3 }))

/* --- of surfaces ------------------------------------------------------------------------------ */

typedef struct UvVertex {
    float2 uv;
} UvVertex;

#define TURN 6.28318530717958647692f

vertex_shader(voxel_sphere_vs, VoxelParametricUniforms, UvVertex, PointVarying)
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

vertex_shader(voxel_torus_vs, VoxelParametricUniforms, UvVertex, PointVarying)
{
    float2 tube = mul(sincos_(in->uv.y * TURN), c->width);
    float3 place = round_axis(tube.x + c->radius, tube.y, sincos_(in->uv.x * TURN));
    *position = set_voxel(&c->place, place, out, point_size);
}

/* A band that makes half a turn about itself on its way round. */
vertex_shader(voxel_moebius_vs, VoxelParametricUniforms, UvVertex, PointVarying)
{
    float2 half_turn = mul(sincos_(in->uv.x * (TURN / 2)), (in->uv.y - 0.5f) * c->width);
    float3 place = round_axis(half_turn.x + c->radius, half_turn.y, sincos_(in->uv.x * TURN));
    *position = set_voxel(&c->place, place, out, point_size);
}

/* A figure of eight that does. */
vertex_shader(voxel_klein_vs, VoxelParametricUniforms, UvVertex, PointVarying)
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

vertex_shader(voxel_bezier_vs, VoxelParametricUniforms, UvVertex, PointVarying)
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
#define SURFACE_DECLARATIONS POINT_DECLARATIONS({ GP_TEXCOORD0, 2 })

program(voxel_sphere_program, voxel_sphere_vs, voxel_parametric_ps, SURFACE_DECLARATIONS)
program(voxel_torus_program, voxel_torus_vs, voxel_parametric_ps, SURFACE_DECLARATIONS)
program(voxel_moebius_program, voxel_moebius_vs, voxel_parametric_ps, SURFACE_DECLARATIONS)
program(voxel_klein_program, voxel_klein_vs, voxel_parametric_ps, SURFACE_DECLARATIONS)
program(voxel_bezier_program, voxel_bezier_vs, voxel_parametric_ps, SURFACE_DECLARATIONS)
/* clang-format on */
