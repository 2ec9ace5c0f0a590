/* The block of packets that is in the shader, and its values. */
#ifndef GP_FAST_SHADER_BLOCK_H
#define GP_FAST_SHADER_BLOCK_H

#include "pipeline/fast/lanes/memory/packet.h"

enum { FAST_AHEAD = 4 }; /* packets whose inputs may be written at once, past the last too */

/* What a shader's slot reads in place. */
typedef struct FastFetch {
    GpFormat format;          /* GP_FORMAT_NONE: a surface that no slot of the tile holds */
    bool is_float;            /* words of the planes are what is read */
    const float (*sums)[4];   /* a pixel's channels side by side (sums.h), or NULL, and: */
    const uint32_t *plane[4]; /* of each channel, NULL where all pixels have the same: */
    float same[4];
} FastFetch;

typedef struct FastShaderBlock {
    FastPacketBlock at;
    FastFetch fetch[GP_MAX_SAMPLERS];

    /* [packet][component][lane] */
    _Alignas(64) float in[(FAST_BLOCK + FAST_AHEAD) * GP_MAX_VARYINGS * GP_LANES];
    _Alignas(64) float color[FAST_MOST * GP_MAX_TARGETS * 4 * GP_LANES];
    _Alignas(64) float pixel[FAST_MOST * 2 * GP_LANES];
    _Alignas(64) float face[FAST_MOST * GP_LANES];
    _Alignas(64) float shader_depth[FAST_MOST * GP_LANES];
    _Alignas(64) int32_t killed[FAST_MOST * GP_LANES];
} FastShaderBlock;

/* The same as vectors: [packet][component], and [packet][target][channel]. */
GP_INLINE flt *fast_inputs(const Tile *tile)
{
    return (flt *)(void *)tile->block->in;
}

GP_INLINE const flt *fast_colors(const Tile *tile)
{
    return (const flt *)(const void *)tile->block->color;
}

#endif
