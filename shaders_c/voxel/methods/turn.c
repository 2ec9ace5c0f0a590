/* The synthesis of flat textures: what belongs at a texel stands in as many texels of the
 * other one as a texel has voxels, one below, or beside, the other.
 * source Dong et al., Pacific Graphics 2004: lookup tables for places and for bits. DEVIATES:
 *        theirs is a map of every place to every place; ours has an entry for each depth, since
 *        what is left is a turn. */
#include "shaders_c/common/cover_shared.h"
#include "shaders_c/voxel/methods/turn.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"

cover_vertex_shader(voxel_turn_vs, VoxelTurnUniforms);

/* Texels in a row: the first one's place in the texture, and how far it is to the next. */
typedef struct Column {
    float2 start, step;
    flt part, byte; /* where in each the voxel is */
    flt left;       /* voxels of the volume from the first on: what comes after is empty */
} Column;

GP_INLINE Column find_column(GpInvocation *gp, const VoxelTurnUniforms *c, flt depth, flt other,
                             flt z)
{
    const FlatTextureLayout *flat = &c->flat;
    float4 place = texldl(1, vec4((depth + 0.5f) * (1.0f / flat->size), 0.5f, 0, 0));
    float2 texel = vec2(1.0f / flat->width, 1.0f / flat->height);
    float2 from = add(mul(u2(c->aside), other), mul(u2(c->down), z));
    return (Column){ mul(add(add(xy(place), from), 0.5f), texel), mul(u2(c->down), texel), place.z,
                     place.w, flat->size - z };
}

/* The column that belongs at a texel. */
GP_INLINE Column column_here(GpInvocation *gp, const VoxelTurnUniforms *c, float3 at)
{
    float2 place = vec2(at.x, at.y);
    return find_column(gp, c, dp2(place, u2(c->depth)), dp2(place, u2(c->across)),
                       at.z * c->flat.per_texel);
}

GP_INLINE float4 read_voxel(GpInvocation *gp, const Column *column, int k)
{
    float2 place = mad(column->step, (float)k, column->start);
    return sel(column->left > (float)k, texldl(0, vec4(place.x, place.y, 0, 0)), 0);
}

pixel_shader(voxel_found_ps, VoxelTurnUniforms, CoverVarying)
{
    float2 at = vpos();
    flt slab = whole_part(at.x, c->octets), octet = at.x - slab * c->octets;
    Column column = find_column(gp, c, octet * 8.0f, at.y, slab * 32.0f);
    float4 mask = in_byte(column.byte, bcast(1));
    flt found[4];
    for (int b = 0; b < 4; b++) {
        found[b] = bcast(0);
        for (int k = 0; k < 8; k++)
            found[b] = max(found[b], dp4(read_voxel(gp, &column, 8 * b + k), mask));
    }
    return vec4(found[0], found[1], found[2], found[3]);
}

program(voxel_found_program, voxel_turn_vs, voxel_found_ps, MODEL_3_0, COVER_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1, .uses_pixel = true)

/* Most of a surface's volume is empty: there no bits are looked for. */
pixel_shader(voxel_turn_bits_ps, VoxelTurnUniforms, CoverVarying)
{
    float3 at = texel_column(&c->flat, vpos());
    Column column = column_here(gp, c, at);
    flt octet = at.z * c->octets + floor_(dp2(vec2(at.x, at.y), u2(c->depth)) * (1.0f / 8));
    float4 found = texldl(
        3, vec4((octet + 0.5f) * (1.0f / (c->octets * c->slabs)),
                (dp2(vec2(at.x, at.y), u2(c->across)) + 0.5f) * (1.0f / c->flat.size), 0, 0));
    const flt any_of[4] = { found.x, found.y, found.z, found.w };
    float4 mask = in_byte(column.byte, bcast(1));
    flt byte[4];
    for (int b = 0; b < 4; b++) {
        byte[b] = bcast(0);
        for (int k = 0; k < 8 && any(any_of[b] > 0.0f); k++) {
            flt code = dp4(read_voxel(gp, &column, 8 * b + k), mask);
            flt bit = texldl(2, vec4(code * (255.0f / 256) + 0.5f / 256, column.part, 0, 0)).x;
            byte[b] = byte[b] + bit * ((float)(1 << k) / 255);
        }
    }
    return vec4(byte[2], byte[1], byte[0], byte[3]);
}

program(voxel_turn_bits_program, voxel_turn_vs, voxel_turn_bits_ps, MODEL_3_0, COVER_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1 | 1 << 2 | 1 << 3, .uses_pixel = true)

pixel_shader(voxel_turn_bytes_ps, VoxelTurnUniforms, CoverVarying)
{
    Column column = column_here(gp, c, texel_column(&c->flat, vpos()));
    float4 mask = in_byte(column.byte, bcast(1));
    return vec4(dp4(read_voxel(gp, &column, 2), mask), dp4(read_voxel(gp, &column, 1), mask),
                dp4(read_voxel(gp, &column, 0), mask), dp4(read_voxel(gp, &column, 3), mask));
}

program(voxel_turn_bytes_program, voxel_turn_vs, voxel_turn_bytes_ps, MODEL_3_0, COVER_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1, .uses_pixel = true)

pixel_shader(voxel_turn_pairs_ps, VoxelTurnUniforms, CoverVarying)
{
    Column column = column_here(gp, c, texel_column(&c->flat, vpos()));
    float4 first = read_voxel(gp, &column, 0), second = read_voxel(gp, &column, 1);
    msk upper = column.byte == 2.0f; /* red and alpha; else blue and green */
    return vec4(sel(upper, second.x, second.z), sel(upper, first.w, first.y),
                sel(upper, first.x, first.z), sel(upper, second.w, second.y));
}

program(voxel_turn_pairs_program, voxel_turn_vs, voxel_turn_pairs_ps, MODEL_3_0, COVER_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1, .uses_pixel = true)
