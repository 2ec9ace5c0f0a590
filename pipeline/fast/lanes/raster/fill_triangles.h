/* Triangles of a tile, set up in batches or one at a time. */
#ifndef GP_FAST_FILL_TRIANGLES_H
#define GP_FAST_FILL_TRIANGLES_H

#include "pipeline/fast/lanes/memory/tile.h"

/* Rasterizes triangles of the present draw that are inside all planes: any number, of any size.
 * Primitives are those of the pass. */
void fast_fill_triangles(Tile *tile, const uint32_t *primitives, uint32_t count);

/* The same of one triangle, by its corners. */
void fast_fill_corners(Tile *tile, const GpScreenVertex corner[3]);

#endif
