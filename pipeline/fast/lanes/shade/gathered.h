/* Gathered packets: pixels of several triangles or points on their way through the shader. */
#ifndef GP_FAST_MIX_H
#define GP_FAST_MIX_H

#include "pipeline/fast/lanes/memory/tile.h"

/* Inputs of a draw's gathered packets: [packet][component]. */
void fast_interpolate_gathered(Tile *tile, const FastDraw *draw, const FastGathered *gathered,
                               int count, flt *in);

/* Writes shaded gathered packets of a draw that replaces everything: color is [packet][target][channel]. */
void fast_write_gathered(Tile *tile, const FastDraw *draw, const FastGathered *gathered, int count,
                         const flt *color);

/* Shades gathered packets of one draw and writes what comes out. */
void fast_shade_gathered(Tile *tile, const FastDraw *draw, const FastGathered *gathered, int count);

#endif
