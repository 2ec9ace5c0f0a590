/* Points whose fragments share packets. */
#ifndef GP_FAST_PACK_POINTS_H
#define GP_FAST_PACK_POINTS_H

#include "pipeline/fast/lanes/geometry/sprites.h"
#include "pipeline/fast/lanes/raster/fragment_path.h"

/* Queues the fragments of sprites of a draw that packs points: of FAST_SPRITE_BATCHES batches at
 * most. */
void fast_pack_points(const Filler *filler, const SpriteBatch *batches, uint32_t count);

#endif
