/* What a surface takes, asked before it is made. */
#ifndef GP_SURFACE_MEMORY_H
#define GP_SURFACE_MEMORY_H

#include "pipeline/resources/surface.h"

/* Levels that a surface of this description has, and texels of one of them along a side. */
uint32_t gp_surface_levels(const GpSurfaceDesc *desc);
uint32_t gp_surface_level_side(uint32_t side, uint32_t level);

/* Bytes of texels that such a surface has of its own: all but some hundred bytes of what it takes.
 * in desc: one that gp_surface_create takes */
uint64_t gp_surface_bytes(const GpSurfaceDesc *desc);

#endif
