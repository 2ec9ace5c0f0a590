/* The ways to fill triangles; which one takes which is the batch's choice. */
#ifndef GP_FAST_FILL_H
#define GP_FAST_FILL_H

#include "pipeline/fast/lanes/raster/batch.h"

/* The triangles of `lanes`, in their order: tiny ones of which nothing is ordered and no stencil is
 * touched; those that are ordered, without depth or quads; and any whose edges fit into 32 bits. */
void fast_fill_tiny(const Filler *filler, const TriangleBatch *batch, unsigned lanes);
void fast_fill_compacted(const Filler *filler, const TriangleBatch *batch, unsigned lanes);
void fast_fill_small(const Filler *filler, const TriangleBatch *batch, unsigned lanes);

/* The same of small triangles whose fragments are sorted, and have one colour. */
void fast_fill_one_color(const Filler *filler, const TriangleBatch *batch, unsigned lanes);

/* How much of the tile a set-up triangle covers. */
typedef enum FastCover { FAST_COVERS_NONE, FAST_COVERS_SOME, FAST_COVERS_ALL } FastCover;
FastCover fast_cover(const Tile *tile, const GpTriangle *triangle);

/* One set-up triangle of any size, by the path of its draw. Bit i of strips[y]: not all of it is hidden in
 * strip i, GP_LANES pixels wide, of row y of the tile; strips: NULL where that is not known. */
void fast_fill_large(Tile *tile, const GpTriangle *triangle, const uint32_t strips[FAST_TILE]);

#endif
