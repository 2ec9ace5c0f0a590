/* Sums: targets of floats that sprites are added to, as splats and glows are.
 *
 * Their rows are short, begin anywhere, and lie on those of the sprite before. So the four channels
 * of a pixel stand side by side: a fragment is added by one load and one store, which never meet
 * the end of a cache line, and what one stores the next one that wants it finds whole. They stay so
 * until someone wants them in planes: a sum that is read in place, and cleared for the next, never
 * is. */
#ifndef GP_FAST_SUMS_H
#define GP_FAST_SUMS_H

#include "pipeline/fast/lanes/memory/tile.h"

/* For each target of the pass at work; whose pixels they hold, the slots know. */
typedef struct FastSums {
    _Alignas(64) float pixel[GP_MAX_TARGETS][FAST_PIXELS][4];
    bool odd[GP_MAX_TARGETS]; /* some are ODD_NAN: planes have what is to stay there */
} FastSums;

/* From planes of so many channels, and back; the other channels are 0, and go nowhere.
 * returns whether some are ODD_NAN */
bool fast_planes_to_sums(const Tile *tile, const FastPlanes *planes, int channels,
                         float (*pixel)[4]);
void fast_sums_to_planes(const Tile *tile, const float (*pixel)[4], int channels,
                         FastPlanes *planes);

/* Every pixel. */
void fast_fill_sums(const Tile *tile, const float value[4], float (*pixel)[4]);

#endif
