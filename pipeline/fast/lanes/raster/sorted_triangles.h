/* Large triangles, sorted front to back where the nearest fragment of the draw wins. */
#ifndef GP_FAST_SORTED_TRIANGLES_H
#define GP_FAST_SORTED_TRIANGLES_H

#include "pipeline/fast/lanes/memory/tile.h"
#include "pipeline/units/setup.h"

enum { FAST_SORTED = 64 }; /* that wait for each other */

/* A large triangle that waits for others, and the codes of all its depths in the tile. */
typedef struct FastSortedTriangle {
    GpTriangle triangle;
    int32_t nearest, farthest;
} FastSortedTriangle;

typedef struct FastSortedTriangles {
    uint32_t count;
    FastSortedTriangle triangle[FAST_SORTED];
    uint8_t order[FAST_SORTED]; /* front to back, as far as it is free */
} FastSortedTriangles;

/* Rasterizes one set-up triangle into the tile, by the path of its draw: now, or sorted with
 * others. */
void fast_fill_triangle(Tile *tile, const GpTriangle *triangle);

/* Fills those that wait. Before any other fragment of the draw is made. */
void fast_fill_sorted(Tile *tile);

#endif
