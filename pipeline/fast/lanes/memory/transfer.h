/* The tile's texels to planes and back, GP_LANES at a time. */
#ifndef GP_FAST_TRANSFER_H
#define GP_FAST_TRANSFER_H

#include "pipeline/fast/lanes/memory/tile.h"

typedef struct FastDepthPlanes {
    _Alignas(64) uint32_t depth[FAST_PIXELS]; /* codes */
    _Alignas(64) uint8_t stencil[FAST_PIXELS];
} FastDepthPlanes;

/* Planes: FastPlanes of a colour format, FastDepthPlanes of a depth format. */
void fast_load_tile(const Tile *tile, const GpSurface *surface, void *planes);
void fast_store_tile(const Tile *tile, const GpSurface *surface, const void *planes);

#endif
