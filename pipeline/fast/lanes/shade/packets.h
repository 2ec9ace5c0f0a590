/* Packets on their way through the shader, in order. */
#ifndef GP_FAST_PACKETS_H
#define GP_FAST_PACKETS_H

#include "pipeline/fast/lanes/memory/packet.h"

/* Shades packets of one draw, and blends them in their order. */
void fast_shade_packets(Tile *tile, const FastDraw *draw, const FastPacketBlock *packets);

/* The same for packets whose inputs are there. */
void fast_shade_inputs(Tile *tile, const FastDraw *draw, const FastPacketBlock *packets);

#endif
