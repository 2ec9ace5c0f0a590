/* Fragments of triangles that have one colour each: they go into their lists at once, by the number
 * that the colour will have, and colours are found later, a lane a triangle. */
#ifndef GP_FAST_ONE_COLOR_H
#define GP_FAST_ONE_COLOR_H

#include "pipeline/fast/lanes/shade/fragments.h"
#include "pipeline/fast/lanes/shade/queue.h"

/* Begins a triangle of the present draw: makes room for its fragments, and gives the number of its
 * colour.
 * in   record: where its record is or will be, once it is the next triangle's turn */
uint32_t fast_begin_color(Tile *tile, uint32_t record, bool front);

/* Forgets the triangle that was begun last, of which no fragment was kept. */
GP_INLINE void fast_undo_color(Tile *tile)
{
    tile->queue->colors--;
    tile->fragments->shaded_count--;
}

/* Finds the colours that are waited for. */
void fast_find_colors(Tile *tile);

#endif
