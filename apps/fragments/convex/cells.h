/* The cells of a picture that something is drawn in: where passes over pixels have work. */
#ifndef APPS_FRAGMENTS_CONVEX_CELLS_H
#define APPS_FRAGMENTS_CONVEX_CELLS_H

#include "apps/fragments/order/screen.h"

enum { CELL_SIDE = 16, CELL_TILE = 64 /* pixels that are cleared together */ };

/* Memory is a frame's. */
typedef struct Cells {
    uint32_t across, down, tiles_across, tiles_down;
    uint32_t width, height;
    uint8_t *is_used;   /* [down][across] */
    GpGeometry corners; /* of all cells, clip space */
} Cells;

/* Without memory is_used is NULL. */
Cells cells_make(Frame *frame, uint32_t width, uint32_t height);

void cells_clear(Cells *cells);
void cells_use(Cells *cells, const ScreenBox *box); /* those that a box meets */

/* Two triangles for each row of used neighbours. */
GpGeometry cells_geometry(const Cells *cells, Frame *frame);

/* The tiles that have used cells, as rectangles; none: no memory, or nothing is used. */
const GpRect *cells_rects(const Cells *cells, Frame *frame, uint32_t *count);

#endif
