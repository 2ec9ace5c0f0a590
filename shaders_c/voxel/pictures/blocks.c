/* Blocks of voxels: the greatest byte of ten columns. A byte of a flat texture of bits is eight
 * voxels along z, and not 0 where any of them is there. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/voxel/pictures/blocks.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"

clip_vertex_shader(voxel_blocks_vs, VoxelBlocksUniforms);

/* The i-th of a block's ten voxels along an axis; those past the volume's sides stand for
 * others. */
GP_INLINE flt tenth(const VoxelBlocksUniforms *c, flt block, int i)
{
    flt voxel = block * (float)VOXEL_BLOCK + (float)(i - 1);
    return min(max(voxel, 0), c->flat.size - 1);
}

enum { TEN = VOXEL_BLOCK + 2 };

pixel_shader(voxel_block_rows_ps, VoxelBlocksUniforms, NoVarying)
{
    float2 at = vpos();
    flt slab = whole_part(at.x, c->columns), block = at.x - slab * c->columns;
    float2 origin = patch_origin(&c->flat, slab);
    flt y = (origin.y + at.y + 0.5f) * (1.0f / c->flat.height);
    float4 most = sp4(bcast(0));
    for (int i = 0; i < TEN; i++) {
        flt x = origin.x + tenth(c, block, i) + 0.5f;
        float2 texel = vec2(x * (1.0f / c->flat.width), y);
        most = max(most, max(texld(0, texel), texld(1, texel)));
    }
    return most;
}

/* The blocks below the first slab's and above the last slab's do not exist: reads stay inside the
 * texture, and what they find makes blocks full that might be empty, which does no harm. */
pixel_shader(voxel_blocks_ps, VoxelBlocksUniforms, NoVarying)
{
    float2 at = add(vpos(), 0.5f);
    flt below = max((at.x - c->columns) * (1.0f / c->width), 0);
    flt x = at.x * (1.0f / c->width), above = (at.x + c->columns) * (1.0f / c->width);
    float4 most = sp4(bcast(0));
    flt last_below = bcast(0), first_above = bcast(0);
    for (int i = 0; i < TEN; i++) {
        flt y = (tenth(c, at.y - 0.5f, i) + 0.5f) * (1.0f / c->height);
        most = max(most, texld(0, vec2(x, y)));
        last_below = max(last_below, texld(0, vec2(below, y)).w);
        first_above = max(first_above, texld(0, vec2(min(above, 1.0f - 0.5f / c->width), y)).z);
    }
    flt low = max(most.z, most.y), high = max(most.x, most.w);
    return vec4(max(most.y, high), max(low, most.x), max(low, last_below), max(high, first_above));
}

/* clang-format off */
#define BLOCKS_DECLARATIONS                                                                        \
    .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_3_0, .inputs = { { GP_POSITION, 3 } }

program(voxel_block_rows_program, voxel_blocks_vs, voxel_block_rows_ps, BLOCKS_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1, .uses_pixel = true)
program(voxel_blocks_program, voxel_blocks_vs, voxel_blocks_ps, BLOCKS_DECLARATIONS,
        .samplers = 1 << 0, .uses_pixel = true)
/* clang-format on */
