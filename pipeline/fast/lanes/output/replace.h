/* Blending after the ternary depth test. */
#ifndef GP_FAST_REPLACE_H
#define GP_FAST_REPLACE_H

#include "pipeline/fast/lanes/output/shaded.h"

/* Blends and writes shaded packets, in their order; what `replaced` tells of is cleared before its
 * fragment is blended. Packets are not gathered, nor in layers: those have no depth. */
void fast_replace_packets(Tile *tile, const FastDraw *draw, const FastShaded *shaded);

#endif
