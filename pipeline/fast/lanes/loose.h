/* Mixes of ordered draws. Where depth comes late, their pixels are tested as a row of their own, below
 * the tile's last: gathered there before, and scattered afterwards. */
#ifndef GP_FAST_LOOSE_H
#define GP_FAST_LOOSE_H

#include "pipeline/fast/lanes/tile.h"

/* Whether there is room for the pixels from (x, y) on, and none of them is in the mix. */
bool FAST(mix_takes)(const FastMix *mix, int32_t x, int32_t y, unsigned live);

void FAST(mix_begin)(FastMix *mix, uint32_t record);
void FAST(mix_add)(FastMix *mix, uint32_t record, int32_t x, int32_t y, unsigned live, flt depth,
                   float *mix_depth);

void FAST(gather_depth)(Tile *tile, const FastMix *mix);
void FAST(scatter_depth)(Tile *tile, const FastMix *mix);

#endif
