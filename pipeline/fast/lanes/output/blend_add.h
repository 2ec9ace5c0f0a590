/* Blending that only adds, of sprites, into targets of floats: what splats and glows do.
 *
 * Their rows are short, begin anywhere, and lie on those of the sprite before. So while such a draw
 * is at work in a tile, the four channels of a pixel stand side by side: a fragment is added by one
 * load and one store, which never meet the end of a cache line, and what one stores the next one
 * that wants it finds whole. */
#ifndef GP_FAST_BLEND_ADD_H
#define GP_FAST_BLEND_ADD_H

#include "pipeline/fast/lanes/output/shaded.h"

typedef struct FastSums {
    int targets; /* that are held here instead of in their planes */
    _Alignas(64) float pixel[GP_MAX_TARGETS][FAST_PIXELS][4];
} FastSums;

/* Whether fragments of points come as pairs of neighbours in a row, in lanes k and k + 4 of every
 * eight, which are added together: some of them dead. Where depth is tested, too few would pass. */
GP_INLINE bool fast_adds_pairs(const FastDraw *d)
{
    return GP_LANES >= 8 && d->only_adds && d->packs_points && !d->wants_depth;
}

/* Takes the targets of a draw out of their planes, and brings them back. */
void fast_begin_sums(Tile *tile, const FastDraw *draw);
void fast_end_sums(Tile *tile);

/* Blends gathered packets of such a draw, fragment by fragment. A pixel may be in a packet several
 * times. */
void fast_add_packets(Tile *tile, const FastDraw *draw, const FastShaded *shaded);

#endif
