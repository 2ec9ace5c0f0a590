/* Where covered pixels go: through the early tests, then along the route of their draw. */
#ifndef GP_FAST_ROUTE_H
#define GP_FAST_ROUTE_H

#include "pipeline/fast/lanes/tile.h"

typedef struct Filler {
    Tile *tile;
    const FastDraw *d;
    uint32_t number; /* of the record, where one is needed */
    bool front;
} Filler;

/* One row of lanes, from (x, y) of the tile on: tests that come early, and on along the draw's route.
 * in   live: bit i, lane i is covered; z: its depth, where the draw wants depth
 * returns the lanes that passed, which whole quads are still to be made of */
unsigned FAST(route_lanes)(const Filler *filler, int32_t x, int32_t y, unsigned live, flt z);

#endif
