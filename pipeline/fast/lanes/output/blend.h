/* The output end for colour: blending and write masks. */
#ifndef GP_FAST_BLEND_H
#define GP_FAST_BLEND_H

#include "pipeline/fast/lanes/output/shaded.h"

/* Blends and writes shaded packets, in their order. */
void fast_blend_packets(Tile *tile, const FastDraw *draw, const FastShaded *shaded);

#endif
