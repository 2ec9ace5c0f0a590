/* Tiles of one colour: where nothing but a clear has come, and a pass that puts layers together
 * covers all of the tile, one pixel tells what all are. Around a model, and between its parts, such
 * passes then cost next to nothing, which is 7 % of dual peeling. */
#ifndef GP_FAST_EVEN_TILE_H
#define GP_FAST_EVEN_TILE_H

#include "pipeline/fast/lanes/memory/tile.h"

/* Draws a pass of one draw (FastDraw.is_even), whose targets are not held yet, if it leaves the
 * tile as even as it was.
 * returns whether it did; otherwise nothing has changed */
bool fast_draw_even(Tile *tile, const FastPass *pass);

#endif
