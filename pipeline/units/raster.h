/* Rasterizer: finds the quads that a primitive covers, by exact integers (R5-R9). */
#ifndef GP_RASTER_H
#define GP_RASTER_H

#include "pipeline/resources/packet.h"

/* Where the walk over a primitive's quads has come to. */
typedef struct GpRasterWalk {
    const GpTriangle *triangle; /* or NULL */
    const GpPointSprite *sprite;
    int32_t x0, y0, x1, y1; /* pixels of the box, ends included */
    int32_t x, y;           /* next quad */
} GpRasterWalk;

GpRasterWalk gp_raster_triangle(const GpTriangle *triangle);
GpRasterWalk gp_raster_sprite(const GpPointSprite *sprite);

/* The next quad with a covered pixel.
 * out  quad: x, y, mask, front and, of triangles, edge[][]; edge values of pixels outside the
 *      triangle are right too (helpers need them)
 * order rows of quads from the top, left to right
 * returns false at the end */
bool gp_raster_next(GpRasterWalk *walk, GpQuad *quad);

#endif
