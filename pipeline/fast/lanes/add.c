/* Blending that only adds, of sprites, into targets of 32-bit floats: what splats and glows do. Their
 * rows are short and begin anywhere, and memory takes most of the time: each row is read and written
 * once, by no more than eight lanes, which meet the end of a cache line less often. */
#include "pipeline/fast/lanes/patch.h"

enum { PIECE = GP_LANES < 8 ? GP_LANES : 8 };
typedef float fpiece __attribute__((vector_size(4 * PIECE)));
typedef int32_t ipiece __attribute__((vector_size(4 * PIECE)));

static bool adds(const GpBlend *blend, GpFormat format)
{
    return (format == GP_A32B32G32R32F || format == GP_R32F) && blend->op == GP_BLEND_ADD &&
           blend->src == GP_ONE && blend->dst == GP_ONE && blend->alpha_op == GP_BLEND_OFF &&
           !(blend->keep & 15);
}

bool FAST(only_adds)(const Tile *tile, const FastDraw *d)
{
    int written = gp_program_targets(d->draw->program);
    if (d->draw->geometry.primitive != GP_POINTS || d->needs.quads || !d->needs.color)
        return false;
    for (int t = 0; t < written && t < tile->targets; t++)
        if (!adds(&d->draw->state.blend[t], d->pass->color[t].surface->format))
            return false;
    return true;
}

GP_INLINE ipiece piece_mask(unsigned bits)
{
    ipiece bit;
    GP_UNROLL
    for (int lane = 0; lane < PIECE; lane++)
        bit[lane] = 1 << lane;
    return ((int32_t)bits & bit) != 0;
}

/* A pixel that is not live adds -0, which changes no number. */
GP_INLINE void add_piece(float *plane, const float *source, ipiece live)
{
    ipiece added;
    fpiece sum;
    __builtin_memcpy(&added, source, sizeof added);
    __builtin_memcpy(&sum, plane, sizeof sum);
    sum += (fpiece)((added & live) | (~live & INT32_MIN));
    __builtin_memcpy(plane, &sum, sizeof sum);
}

/* A row, or packed rows. Lanes that follow those of a row are read with it, but never live. */
GP_INLINE void add_patch(FastPlanes *planes, int channels, const FastPatch *patch, unsigned live,
                         const float *color)
{
    const int wide = patch->wide;
    uint32_t at = fast_at(patch->x, patch->y);
    for (; live; live >>= wide, color += wide, at += FAST_PITCH)
        for (int x = 0; x < wide; x += PIECE) {
            const ipiece lives = piece_mask((live & ((1u << wide) - 1)) >> x);
            GP_UNROLL
            for (int c = 0; c < channels; c++)
                add_piece(planes->channel[c] + at + x, color + c * GP_LANES + x, lives);
        }
}

void FAST(add_patches)(Tile *tile, const FastDraw *d, const FastPatch *patches,
                       const unsigned *live, int count, const flt *color)
{
    const int written = gp_program_targets(d->draw->program), stride = 4 * written;
    for (int t = 0; t < written && t < tile->targets; t++) {
        const bool single = d->pass->color[t].surface->format == GP_R32F;
        const flt *source = color + 4 * t;
        for (int p = 0; p < count; p++, source += stride)
            if (single)
                add_patch(tile->planes[t], 1, &patches[p], live[p], (const float *)source);
            else
                add_patch(tile->planes[t], 4, &patches[p], live[p], (const float *)source);
    }
}
