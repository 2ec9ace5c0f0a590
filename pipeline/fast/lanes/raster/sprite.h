/* Filling point sprites. */
#ifndef GP_FAST_SPRITE_H
#define GP_FAST_SPRITE_H

#include "pipeline/fast/draws/bin.h"
#include "pipeline/fast/lanes/memory/tile.h"

/* Asks memory for the vertices of points: better some time before they are filled. */
void fast_prefetch_points(const FastDraw *draw, const FastPrimitiveMask *mask);

/* Rasterizes any number of points of the present draw. Primitives are those of the pass. */
void fast_fill_sprites(Tile *tile, const uint32_t *primitives, uint32_t count);

#endif
