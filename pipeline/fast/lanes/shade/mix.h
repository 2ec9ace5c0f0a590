/* Mixes: pixels of several triangles or points on their way through the shader. */
#ifndef GP_FAST_MIX_H
#define GP_FAST_MIX_H

#include "pipeline/fast/lanes/tile.h"

/* Inputs of a draw's mixes: [mix][component]. */
void FAST(interpolate_mixes)(Tile *tile, const FastDraw *draw, const FastMix *mixes, int count,
                             flt *in);

/* Writes shaded mixes of a draw that replaces everything: color is [mix][target][channel]. */
void FAST(write_mixes)(Tile *tile, const FastDraw *draw, const FastMix *mixes, int count,
                       const flt *color);

/* Shades mixes of one draw and writes what comes out. */
void FAST(shade_mixes)(Tile *tile, const FastDraw *draw, const FastMix *mixes, int count);

#endif
