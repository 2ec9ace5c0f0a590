/* Output: reads and writes render targets (R24, R27, R37). */
#ifndef GP_OUTPUT_H
#define GP_OUTPUT_H

#include "pipeline/resources/packet.h"

/* Loads what a target holds under the living pixels into quad->destination[target]. */
void gp_output_load(const GpSurface *surface, int target, GpQuad *quad);

/* Sets the channels of the pixels that replace (quad->replaced) to 0, but for those of keep
 * (R37). */
void gp_output_clear(GpSurface *surface, unsigned keep, const GpQuad *quad);

/* Stores quad->color[target] of the living pixels, rounded to the surface's format.
 * in   keep: bit c, channel c keeps its bits (R37) */
void gp_output_store(GpSurface *surface, int target, unsigned keep, const GpQuad *quad);

#endif
