/* Layers: boxes of one place that lie one on the other, as what covers the screen again and again.
 * They are shaded a few pixels at a time, all layers of these before the next, so that what is
 * blended stays in the nearest cache. Shaders that interpolate take twice as many at once:
 * fill_blend32f takes 8 % less. */
#ifndef GP_FAST_LAYERS_H
#define GP_FAST_LAYERS_H

#include "pipeline/fast/lanes/memory/packet.h"

enum { FAST_LAYERS = 8 };

typedef struct FastLayers {
    uint32_t count;
    FastBox box; /* in the tile */
    uint32_t record[FAST_LAYERS];
} FastLayers;

/* Shades all pixels of the layers, of the tile's present draw; room: FAST_MOST packets. */
void fast_shade_layers(Tile *tile, const FastLayers *layers, FastPacket *room);

#endif
