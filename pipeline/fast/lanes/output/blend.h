/* The output end for colour: blending and write masks. */
#ifndef GP_FAST_BLEND_H
#define GP_FAST_BLEND_H

#include "pipeline/fast/lanes/output/shaded.h"

/* Whether several layers of one place are blended in registers: where an operation needs what was
 * there, as a number. */
GP_INLINE bool fast_blends_layers(const GpBlend *blend)
{
    return blend->op != GP_BLEND_OFF && !gp_blend_is_logic(blend->op);
}

/* Blends and writes shaded packets, in their order. Of whole ones that are blended as layers only
 * the first layer's places count. */
void fast_blend_packets(Tile *tile, const FastDraw *draw, const FastShaded *shaded);

#endif
