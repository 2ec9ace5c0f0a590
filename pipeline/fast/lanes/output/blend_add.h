/* Blending that only adds, of sprites, into targets of floats: what splats and glows do. While such
 * a draw is at work its targets are sums (memory/sums.h). */
#ifndef GP_FAST_BLEND_ADD_H
#define GP_FAST_BLEND_ADD_H

#include "pipeline/fast/lanes/memory/sums.h"
#include "pipeline/fast/lanes/output/shaded.h"

/* Whether fragments of points come as pairs of neighbours in a row, in lanes k and k + 4 of every
 * eight, which are added together: some of them dead. Where depth is tested, too few would pass. */
GP_INLINE bool fast_adds_pairs(const FastDraw *d)
{
    return GP_LANES >= 8 && d->only_adds && d->packs_points && !d->wants_depth;
}

/* Blends gathered packets of such a draw, fragment by fragment. A pixel may be in a packet several
 * times. */
void fast_add_packets(Tile *tile, const FastDraw *draw, const FastShaded *shaded);

#endif
