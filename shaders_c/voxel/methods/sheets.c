/* Voxels of one bit: the power of two that belongs to a voxel is looked up and added. And those of
 * more bits that say no more than that something is there, or how often.
 * source Dong, Chen, Bao, Zhang and Peng, "Real-time voxelization for complex polygonal models",
 *        Pacific Graphics 2004: texelization, its table of 8 x 1, and four targets at once */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/voxel/methods/sheets.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"

/* A fragment's place along the axis. */
typedef struct Place {
    flt target; /* 0 to 3; others: none of the four */
    flt voxel;  /* of its texel */
} Place;

/* Over the whole viewport, which is the slab's patch; depth, which is not clipped, goes to the
 * fragments. */
GP_INLINE float4 place_on_patch(const VoxelSheetsUniforms *c, float3 position, flt *depth)
{
    float3 place = m4x3(position, c->to_flat);
    *depth = place.z;
    return vec4(place.x * (2.0f / c->size) - 1.0f, 1.0f - place.y * (2.0f / c->size), 0.5f, 1);
}

GP_INLINE Place find_place(const VoxelSheetsUniforms *c, flt depth, float per_texel)
{
    flt voxel = floor_(depth);
    flt slab = floor_((voxel + 0.5f) * (1.0f / per_texel));
    return (Place){ sel(voxel < c->size, slab - c->first_slab, -1), voxel - slab * per_texel };
}

GP_INLINE void put_texel(SlabTargets *out, flt target, float4 texel)
{
    for (int i = 0; i < 4; i++)
        out->slab[i] = sel(target == (float)i, texel, 0);
}

/* Adds a value of up to 16 bits to its place. */
GP_INLINE void put_value(const VoxelSheetsUniforms *c, flt depth, flt value, SlabTargets *out)
{
    Place place = find_place(c, depth, c->per_texel);
    flt high = floor_(value * (1.0f / 256)), low = value - 256.0f * high;
    float4 bytes = add(mul(u4(c->low), low * (1.0f / 255)), mul(u4(c->high), high * (1.0f / 255)));
    put_texel(out, place.target,
              vec4(sel(place.voxel == c->voxel_of[0], bytes.x, 0),
                   sel(place.voxel == c->voxel_of[1], bytes.y, 0),
                   sel(place.voxel == c->voxel_of[2], bytes.z, 0),
                   sel(place.voxel == c->voxel_of[3], bytes.w, 0)));
}

/* --- bits and densities ----------------------------------------------------------------------- */

vertex_shader(voxel_place_vs, VoxelSheetsUniforms, PointVertex, DepthVarying)
{
    *position = place_on_patch(c, in->position, &out->depth);
}

pixel_shader_targets(voxel_bits_ps, VoxelSheetsUniforms, DepthVarying, SlabTargets)
{
    Place place = find_place(c, in->depth, 32);
    flt byte = floor_((place.voxel + 0.5f) * (1.0f / 8)), bit = place.voxel - 8.0f * byte;
    flt power = texld(0, vec2((bit + 0.5f) * (1.0f / 8), 0.5f)).x;
    put_texel(out, place.target, in_byte(byte, power));
}

program(voxel_bits_program, voxel_place_vs, voxel_bits_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } }, .varyings = { { "depth", 1, GP_PERSPECTIVE } },
        .samplers = 1 << 0)

pixel_shader_targets(voxel_density_ps, VoxelSheetsUniforms, DepthVarying, SlabTargets)
{
    put_value(c, in->depth, bcast(c->offset), out);
}

program(voxel_density_program, voxel_place_vs, voxel_density_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } }, .varyings = { { "depth", 1, GP_PERSPECTIVE } })

/* --- what 8 and 16 bits hold: whole numbers in one or two bytes, by codes of ours ------------- */

typedef struct ValueVertex {
    float3 position, value;
} ValueVertex;

typedef struct ValueVarying {
    flt depth;
    float3 value;
} ValueVarying;

vertex_shader(voxel_normals_vs, VoxelSheetsUniforms, ValueVertex, ValueVarying)
{
    *position = place_on_patch(c, in->position, &out->depth);
    out->value = m3x3(in->value, c->to_volume);
}

GP_INLINE flt fold(flt a, flt b)
{
    return sel(a >= 0.0f, 1.0f - abs_(b), abs_(b) - 1.0f);
}

/* The octahedron |x| + |y| + |z| = 1 laid flat: its lower half is folded out over the corners.
 * source Meyer, Suessmuth, Sussner, Stamminger and Greiner, "On floating-point normal vectors",
 *        EGSR 2010 */
pixel_shader_targets(voxel_normals_ps, VoxelSheetsUniforms, ValueVarying, SlabTargets)
{
    float3 n = in->value;
    n = mul(n, rcp(abs_(n.x) + abs_(n.y) + abs_(n.z)));
    flt a = sel(n.z < 0.0f, fold(n.x, n.y), n.x), b = sel(n.z < 0.0f, fold(n.y, n.x), n.y);
    flt first = floor_(sat(a * 0.5f + 0.5f) * c->levels[0] + 0.5f);
    flt second = floor_(sat(b * 0.5f + 0.5f) * c->levels[1] + 0.5f);
    put_value(c, in->depth, first * c->weights[0] + second * c->weights[1] + c->offset, out);
}

program(voxel_normals_program, voxel_normals_vs, voxel_normals_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_B, .inputs = { { GP_POSITION, 3 }, { GP_NORMAL, 3 } },
        .varyings = { { "depth", 1, GP_PERSPECTIVE }, { "value", 3, GP_PERSPECTIVE } })

vertex_shader(voxel_colors_vs, VoxelSheetsUniforms, ValueVertex, ValueVarying)
{
    *position = place_on_patch(c, in->position, &out->depth);
    out->value = in->value;
}

/* Black is nearly so: 0 says that nothing is there. */
pixel_shader_targets(voxel_colors_ps, VoxelSheetsUniforms, ValueVarying, SlabTargets)
{
    float3 whole = floor_(add(mul(sat(in->value), u3(c->levels)), 0.5f));
    flt code = dp3(whole, u3(c->weights));
    put_value(c, in->depth, max(code, 1), out);
}

program(voxel_colors_program, voxel_colors_vs, voxel_colors_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 3 } },
        .varyings = { { "depth", 1, GP_PERSPECTIVE }, { "value", 3, GP_PERSPECTIVE } })
