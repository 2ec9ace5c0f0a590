/* Fragments and the texels of four slabs. For shader files only. */
#ifndef SHADERS_VOXEL_METHODS_SHEETS_SHARED_H
#define SHADERS_VOXEL_METHODS_SHEETS_SHARED_H

#include "pipeline/shader.h"
#include "shaders_c/voxel/methods/sheets.h"

typedef struct Targets {
    float4 slab[4];
} Targets;

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

GP_INLINE void put_texel(Targets *out, flt target, float4 texel)
{
    for (int i = 0; i < 4; i++)
        out->slab[i] = sel(target == (float)i, texel, 0);
}

/* Adds a value of up to 16 bits to its place. */
GP_INLINE void put_value(const VoxelSheetsUniforms *c, flt depth, flt value, Targets *out)
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

#endif
