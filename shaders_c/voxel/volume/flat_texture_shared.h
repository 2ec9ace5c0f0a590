/* Places on flat textures, and their voxels. For shader files only. */
#ifndef SHADERS_VOXEL_VOLUME_FLAT_TEXTURE_SHARED_H
#define SHADERS_VOXEL_VOLUME_FLAT_TEXTURE_SHARED_H

#include <glasspipe/shader.h>
#include "shaders_c/voxel/volume/flat_texture.h"

/* Whole part of a / b for whole numbers below 2^22. */
GP_INLINE flt whole_part(flt a, float b)
{
    return floor_((a + 0.5f) * (1.0f / b));
}

/* Top left texel of a slab's patch. */
GP_INLINE float2 patch_origin(const FlatTextureLayout *flat, flt slab)
{
    flt row = whole_part(slab, flat->columns);
    return vec2((slab - row * flat->columns) * flat->size, row * flat->size);
}

/* Slab, and place in it, of a texel of the flat texture. */
GP_INLINE float3 texel_column(const FlatTextureLayout *flat, float2 texel)
{
    flt column = whole_part(texel.x, flat->size), row = whole_part(texel.y, flat->size);
    return vec3(texel.x - column * flat->size, texel.y - row * flat->size,
                row * flat->columns + column);
}

/* A place in texels of the flat texture, in clip space. */
GP_INLINE float4 flat_position(const FlatTextureLayout *flat, float2 texel)
{
    return vec4(texel.x * (2.0f / flat->width) - 1.0f, 1.0f - texel.y * (2.0f / flat->height), 0.5f,
                1);
}

/* A number in a byte's channel, 0 in the others; blue is byte 0. */
GP_INLINE float4 in_byte(flt byte, flt number)
{
    return vec4(sel(byte == 2.0f, number, 0), sel(byte == 1.0f, number, 0),
                sel(byte == 0.0f, number, 0), sel(byte == 3.0f, number, 0));
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
