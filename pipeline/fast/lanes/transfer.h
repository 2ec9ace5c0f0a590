/* Rows of texels to planes and back, GP_LANES at a time. */
#ifndef GP_FAST_TRANSFER_H
#define GP_FAST_TRANSFER_H

#include "pipeline/fast/lanes/tile.h"

/* `count` texels of a colour format, to and from a place in the planes. Loading may write up to
 * GP_LANES - 1 words past them, which every row has room for. */
void FAST(load_colors)(GpFormat format, const uint8_t *texels, int32_t count, FastPlanes *planes,
                       uint32_t at);
void FAST(store_colors)(GpFormat format, uint8_t *texels, int32_t count, const FastPlanes *planes,
                        uint32_t at);

/* The same for depth formats. */
void FAST(load_depths)(GpFormat format, const uint8_t *texels, int32_t count,
                       FastDepthPlanes *planes, uint32_t at);
void FAST(store_depths)(GpFormat format, uint8_t *texels, int32_t count,
                        const FastDepthPlanes *planes, uint32_t at);

#endif
