/* Places on flat textures of volumes, and what stands there. For shader files only. */
#ifndef SHADERS_VOLUME_ATLAS_SHARED_H
#define SHADERS_VOLUME_ATLAS_SHARED_H

#include <glasspipe/shader.h>
#include "shaders_c/volume/atlas.h"

/* Where (x, y), in texels of a patch, stands in patch `number`; both whole or not. */
GP_INLINE float4 volume_place(const VolumePatches *patches, flt x, flt y, flt number)
{
    flt row = floor_((number + 0.5f) * (1.0f / patches->columns));
    flt column = number - row * patches->columns;
    return vec4(column * patches->patch[0] + (x + 0.5f) * patches->texel[0],
                row * patches->patch[1] + (y + 0.5f) * patches->texel[1], 0, 0);
}

/* The value at a place, in samples, linear between eight: 0 to 1. The volume's box is [0, N -
 * 1]. */
GP_INLINE flt volume_value(GpInvocation *gp, int slot, const VolumePatches *patches, float3 at)
{
    const float thick = (float)VOLUME_SLAB;
    flt slab = floor_(at.z * (1.0f / thick)), above = at.z - slab * thick;
    float4 slices = texldl(slot, volume_place(patches, at.x, at.y, slab));
    flt first = max(1.0f - above, 0), last = max(above - 2.0f, 0);
    flt second = max(1.0f - abs_(above - 1.0f), 0), third = max(1.0f - abs_(above - 2.0f), 0);
    return slices.z * first + slices.y * second + (slices.x * third + slices.w * last);
}

#endif
