/* Framebuffer fetch: what the pixels of a packet hold. */
#ifndef GP_FAST_FRAMEBUFFER_FETCH_H
#define GP_FAST_FRAMEBUFFER_FETCH_H

#include "pipeline/fast/lanes/memory/tile.h"

/* Makes a slot that the program reads ready, before a block's call. */
void fast_begin_fetch(Tile *tile, const GpTexture *textures, int slot);

/* gp_load_local; the call's `local` is the tile. */
void fast_fetch_framebuffer(const GpShaderCall *call, int slot, int packet, int lanes,
                            float *texel);

#endif
