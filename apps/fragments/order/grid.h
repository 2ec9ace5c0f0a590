/* The order of convex pieces as the paper finds it: by the cells of a uniform grid, front to back.
 *
 * Cells are visited layer by layer, row by row, cell by cell, from the eye's on. A piece that is in several
 * cells waits until those in front of all of them are done; where pieces wait for each other in a circle, the
 * circle is cut. Pieces of one cell come by the distance of their middles.
 *
 * Which of two pieces in one cell is in front follows from neither, and a circle that is cut is drawn in
 * some order: pixels are wrong, and counted. order.h is the remedy.
 *
 * source paper 002, section 3.2
 * DEVIATES: pieces of one cell are parted by their middles, not by slabs, orders by sectors and grids
 *        within cells; pieces that share no pixel share a level, which changes no order that is seen */
#ifndef APPS_FRAGMENTS_ORDER_GRID_H
#define APPS_FRAGMENTS_ORDER_GRID_H

#include "apps/fragments/order/order.h"

/* out    order: as order_find makes it, without knots; split_sides: circles that were cut
 * errors GP_ERROR_MEMORY */
GpResult order_by_grid(const OrderMesh *mesh, const FragmentView *view, const Screen *screen,
                       Order *order, GpError *error);

#endif
