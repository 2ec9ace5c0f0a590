/* The vertex shader in lanes. */
#ifndef GP_FAST_VERTICES_H
#define GP_FAST_VERTICES_H

#include "pipeline/fast/lanes/memory/tile.h"

/* Shades vertices [first, first + count) of a draw (counted from its first vertex). */
void fast_shade_vertices(const FastDraw *draw, uint32_t first, uint32_t count);

/* Varyings of a draw that shades again. Vertices count from the draw's first, and rise within a
 * packet.
 * out  varying: [packet][component][lane]; packets: FAST_SPRITE_BATCHES at most */
void fast_shade_varyings(const FastDraw *draw, const uint32_t (*vertex)[GP_LANES], uint32_t packets,
                         float *varying);

#endif
