/* The pixel shader over a block of packets. */
#ifndef GP_FAST_PIXEL_SHADER_H
#define GP_FAST_PIXEL_SHADER_H

#include "pipeline/fast/lanes/shade/shader_block.h"

/* Runs the pixel shader of a draw over packets whose inputs are in the tile's shader block. */
void fast_run_pixel_shader(Tile *tile, const FastDraw *draw, const FastPacketBlock *packets);

#endif
