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

/* Strips of a tile, GP_LANES pixels wide, of which not all is hidden from codes of `nearest` on:
 * bit i of of_row[y] is that from x = i GP_LANES on. */
typedef struct FastNotHidden {
    int32_t nearest;
    uint32_t of_row[FAST_TILE];
} FastNotHidden;

_Static_assert(FAST_TILE / GP_LANES <= 32, "strips of a row have a bit each");

/* One set-up triangle of any size, by the path of its draw.
 * inout strips: of a draw whose nearest fragment wins, of which no code is nearer; what the tile's
 *       depths now hide leaves them. NULL: nothing is known */
void fast_fill_large(Tile *tile, const GpTriangle *triangle, FastNotHidden *strips);

#endif
