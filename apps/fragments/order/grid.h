/* The order of convex pieces as the paper finds it: by borders between the cells of a grid, and
 * within a cell by what parts its pieces.
 *
 * A border between two cells has the one in front that the eye is on the side of, and a piece waits
 * for those
 * in front of its cells. Pieces in one cell are parted by planes, by slabs that are drawn between
 * them, or the one is nested in the other (parting.h). Where pieces wait for each other in a circle
 * the circle is cut: the nearest of it comes first.
 *
 * Planes that fit no view and circles that are cut make pixels wrong, and they are counted. order.h
 * is the remedy.
 *
 * source paper 002, section 3.2; circles: Williams, "Visibility-ordering meshed polyhedra", ACM
 *        Transactions on Graphics 11(2), 1992
 * DEVIATES: cells have no fixed size. Crowded ones are to be divided into grids of their own, and
 *        whatever those are, borders are between boxes that are apart; so all such boxes have one.
 *        (Of a hand in 6,758 pieces at 256x256, 117 pixels beyond edges are wrong with as many
 *        cells as pieces, 69 with 8 times as many, 42 with 64 times, 29 so; all 5,135 where pieces
 *        of a cell come by their distance.) Orders are not recorded by the sectors that planes cut
 *        a sphere into: the sector is on which sides of its planes the eye is, and to ask that
 *        takes 1.6 of the order's 54 ms. A piece waits for those that it shares pixels with, not
 *        for all in front of its cells, and pieces that share none share a level: no order that is
 *        seen is another */
#ifndef APPS_FRAGMENTS_ORDER_GRID_H
#define APPS_FRAGMENTS_ORDER_GRID_H

#include "apps/fragments/order/order.h"
#include "apps/fragments/order/parting.h"

/* out    order: as order_find makes it; its knots are faces of slabs, 4 layers at most in a level;
 *        split_sides: sides of pieces and slabs in circles that were cut
 * errors GP_ERROR_MEMORY */
GpResult order_by_grid(const OrderMesh *mesh, const Partings *partings, const FragmentView *view,
                       const Screen *screen, Order *order, GpError *error);

#endif
