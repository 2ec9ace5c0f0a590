/* Each point sets the voxel that it lies in. */
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

vertex_shader(voxel_points_vs, VoxelPointsUniforms, PointVertex, PointVarying)
{
    *position = set_voxel(c, in->position, out, point_size);
}

pixel_shader(voxel_points_ps, VoxelPointsUniforms, PointVarying)
{
    return in->bit;
}

program(voxel_points_program, voxel_points_vs, voxel_points_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } }, .varyings = { { "bit", 4, GP_FLAT } },
        .writes_point_size = true)
