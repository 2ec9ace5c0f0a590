/* Shading of gathered packets: pixels of several triangles or points. */
#ifndef GP_FAST_GATHERED_H
#define GP_FAST_GATHERED_H

#include "pipeline/fast/lanes/memory/packet.h"

/* Shades gathered packets of one draw that replaces everything, and writes what comes out. */
void fast_shade_gathered(Tile *tile, const FastDraw *draw, const FastGathered *gathered, int count);

#endif
