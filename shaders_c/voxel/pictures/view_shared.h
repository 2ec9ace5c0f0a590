/* Voxels of flat textures as slices find them. For shader files only. */
#ifndef SHADERS_VOXEL_PICTURES_VIEW_SHARED_H
#define SHADERS_VOXEL_PICTURES_VIEW_SHARED_H

#include "shaders_c/common/slices_shared.h"
#include "shaders_c/voxel/pictures/blocks.h"
#include "shaders_c/voxel/pictures/view.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"

/* Where a voxel's word is, and which bit is the voxel's. */
typedef struct VoxelPlace {
    float2 coord;
    flt bit;
} VoxelPlace;

/* Of whole numbers. */
GP_INLINE VoxelPlace place_of_voxel(const FlatTextureLayout *flat, float3 voxel)
{
    flt slab = whole_part(voxel.z, flat->per_texel);
    float2 origin = patch_origin(flat, slab);
    return (VoxelPlace){
        .coord = vec2((origin.x + voxel.x + 0.5f) * (1.0f / flat->width),
                      (origin.y + voxel.y + 0.5f) * (1.0f / flat->height)),
        .bit = voxel.z - slab * flat->per_texel,
    };
}

/* Bit 0..31 of a word read as four bytes / 255: half, or more, of what is left of the bits up to
 * it. The half that is added to the byte lies below all bits, and hides what division by 255
 * rounds. */
GP_INLINE msk has_bit(float4 word, flt bit)
{
    flt byte = sel(bit < 16.0f, sel(bit < 8.0f, word.z, word.y), sel(bit < 24.0f, word.x, word.w));
    flt in_byte = bit - 8.0f * floor_(bit * (1.0f / 8));
    return frc((byte * 255.0f + 0.5f) * exp_(-1.0f - in_byte)) >= 0.5f;
}

/* --- the ray in a slab ------------------------------------------------------------------------ */

enum { STEPS = 3 };

/* The voxels that it goes through, and for which share of its way. */
typedef struct Walk {
    float2 voxel[STEPS];
    flt share[STEPS];
} Walk;

/* Share of the way to the boundary between two voxels that are the same or neighbours; 1: none. */
GP_INLINE flt crossing(flt from, flt to, flt first, flt last)
{
    flt share = (max(first, last) - from) * rcp(to - from);
    return sel(first == last, bcast(1), sat(share));
}

GP_INLINE Walk walk_slab(const SlabRay *ray)
{
    float2 first = floor_(ray->start), last = floor_(ray->end);
    flt u = crossing(ray->start.x, ray->end.x, first.x, last.x);
    flt v = crossing(ray->start.y, ray->end.y, first.y, last.y);
    msk u_first = u < v;
    flt one = min(u, v), two = max(u, v);
    return (Walk){ .voxel = { first,
                              vec2(sel(u_first, last.x, first.x), sel(u_first, first.y, last.y)),
                              last },
                   .share = { one, two - one, 1.0f - two } };
}

/* The voxel's kind; 0: empty, or beside the volume along u or v. */
GP_INLINE flt kind_at(GpInvocation *gp, const VoxelViewUniforms *c, float2 across, flt layer,
                      bool two)
{
    float2 from_centre = abs_(sub(across, (c->flat.size - 1) * 0.5f));
    msk inside = max(from_centre.x, from_centre.y) < c->flat.size * 0.5f;
    VoxelPlace place = place_of_voxel(&c->flat, voxel_at(&c->slices, across, layer));
    flt kind = sel(has_bit(texld(0, place.coord), place.bit), bcast(VOXEL_KIND_FIRST), 0);
    if (two)
        kind = kind + sel(has_bit(texld(1, place.coord), place.bit), bcast(VOXEL_KIND_SECOND), 0);
    return sel(inside, kind, 0);
}

/* Whether the way through a slab may meet a voxel: its block has any, or a neighbour. */
GP_INLINE msk is_near_voxels(GpInvocation *gp, const VoxelViewUniforms *c, const SlabRay *ray)
{
    float2 inside = min(max(floor_(ray->start), 0.0f), c->flat.size - 1);
    float3 block = floor_(mul(voxel_at(&c->slices, inside, ray->layer), 1.0f / (float)VOXEL_BLOCK));
    flt slab = floor_(block.z * 0.25f), byte = block.z - slab * 4.0f;
    float4 blocks =
        texld(3, vec2((slab * c->block_columns + block.x + 0.5f) * (1.0f / c->blocks_width),
                      (block.y + 0.5f) * (1.0f / c->blocks_height)));
    flt own = sel(byte < 2.0f, sel(byte < 1.0f, blocks.z, blocks.y),
                  sel(byte < 3.0f, blocks.x, blocks.w));
    return own > 0.0f;
}

/* Length of the ray in voxels of the volume in slot 0. What absorbs does so by the length of the
 * way in it: light loses the same share in each unit. */
GP_INLINE flt way_in_first(GpInvocation *gp, const VoxelViewUniforms *c, const SlabRay *ray)
{
    Walk walk = walk_slab(ray);
    msk near = is_near_voxels(gp, c, ray);
    flt share = bcast(0);
    for (int i = 0; i < STEPS && any(near); i++) {
        flt kind = kind_at(gp, c, walk.voxel[i], ray->layer, false);
        share = mad(kind, walk.share[i], share);
    }
    return sel(near, share * way_through(&c->slices, ray), 0);
}

#endif
