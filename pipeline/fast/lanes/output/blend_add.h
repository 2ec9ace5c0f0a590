/* Blending that only adds, of sprites, into targets of floats. */
#ifndef GP_FAST_BLEND_ADD_H
#define GP_FAST_BLEND_ADD_H

#include "pipeline/fast/lanes/output/shaded.h"

/* Whether a draw's sprites only add to targets of floats; and how their packets, rows or packed,
 * are blended then. */
bool fast_only_adds(const Tile *tile, const FastDraw *draw);
void fast_add_packets(Tile *tile, const FastDraw *draw, const FastShaded *shaded);

#endif
