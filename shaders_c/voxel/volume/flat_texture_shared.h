/* Places on flat textures, and their voxels. For shader files only. */
#ifndef SHADERS_VOXEL_VOLUME_FLAT_TEXTURE_SHARED_H
#define SHADERS_VOXEL_VOLUME_FLAT_TEXTURE_SHARED_H

#include "pipeline/shader.h"
#include "shaders_c/voxel/volume/flat_texture.h"

/* Whole part of a / b for whole numbers below 2^22. */
GP_INLINE flt whole_part(flt a, float b)
{
    return floor_((a + 0.5f) * (1.0f / b));
}

/* Top left texel of a slab's patch. */
GP_INLINE float2 patch_origin(const FlatTextureLayout *sheet, flt slab)
{
    flt row = whole_part(slab, sheet->columns);
    return vec2((slab - row * sheet->columns) * sheet->size, row * sheet->size);
}

/* Slab, and place in it, of a texel of the sheet. */
GP_INLINE float3 texel_column(const FlatTextureLayout *sheet, float2 texel)
{
    flt column = whole_part(texel.x, sheet->size), row = whole_part(texel.y, sheet->size);
    return vec3(texel.x - column * sheet->size, texel.y - row * sheet->size,
                row * sheet->columns + column);
}

/* A place in texels of the sheet, in clip space. */
GP_INLINE float4 sheet_position(const FlatTextureLayout *sheet, float2 texel)
{
    return vec4(texel.x * (2.0f / sheet->width) - 1.0f, 1.0f - texel.y * (2.0f / sheet->height),
                0.5f, 1);
}

/* Bits below `end` of each byte of a word, plus 1: 1 to 256. */
GP_INLINE float4 bytes_below(flt end)
{
    float4 scale = vec4(1.0f / 65536, 1.0f / 256, 1, 1.0f / 16777216); /* red green blue alpha */
    return max(min(mul(scale, exp_(end)), 256.0f), 1.0f);
}

/* The word of bits k < end, whole numbers, as bytes / 255. */
GP_INLINE float4 bits_below(flt end)
{
    return mul(sub(bytes_below(end), 1.0f), 1.0f / 255);
}

/* The word of bits first <= k < end; none where end <= first. */
GP_INLINE float4 bits_between(flt first, flt end)
{
    return mul(max(sub(bytes_below(end), bytes_below(first)), 0.0f), 1.0f / 255);
}

#endif
