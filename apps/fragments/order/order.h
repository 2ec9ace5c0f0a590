/* The order of a mesh's convex pieces from one view: levels, to be drawn front to back.
 *
 * A level has near faces and far faces, and no pixel is drawn twice by either: pieces that share no
 * pixel are in one level, however many. What is near in a level is in front of what is far in it,
 * and all of it in front of all later levels, wherever they share a pixel.
 *
 * A piece has its near and its far side in one level where nothing is between them; one that is
 * nested in another comes between its sides. Where the sides of pieces come before each other in a
 * circle, they are taken apart, face by face; faces that still do, because they overlap in a circle
 * or cut each other, are a knot, and lie in knots of a level, to be sorted pixel by pixel.
 *
 * source paper 002, sections 3.2 and 4.2; Williams, "Visibility-ordering meshed polyhedra", ACM
 *        Transactions on Graphics 11(2), 1992, of sorting by what is in front of what
 * DEVIATES: the paper goes over a grid's cells, front to back (grid.h), and puts a slab between
 *        neighbours that no plane parts. Which cell is nearer tells nothing of two pieces in one
 *        cell, and the slab has a normal that fits no view. Here every two that share a pixel are
 *        asked, so that the order is right from everywhere. */
#ifndef APPS_FRAGMENTS_ORDER_ORDER_H
#define APPS_FRAGMENTS_ORDER_ORDER_H

#include "apps/fragments/order/order_mesh.h"
#include "apps/fragments/order/screen.h"

/* Owns all; a zeroed one is empty. Faces that cover nothing are left out. */
typedef struct Order {
    uint32_t level_count;
    uint32_t *first;      /* [level_count + 1] of each level in faces */
    uint32_t *faces;      /* in the order of pieces */
    uint32_t *knot_first; /* [level_count + 1] of each level in knots */
    uint32_t *knots;      /* faces of knots */

    /* for who wants to know */
    uint32_t sides;       /* of pieces that are drawn: near ones and far ones */
    uint32_t split_sides; /* taken apart into faces */
    uint32_t knot_count;
} Order;

/* errors GP_ERROR_MEMORY */
GpResult order_find(const OrderMesh *mesh, const FragmentView *view, const Screen *screen,
                    Order *order, GpError *error);
void order_free(Order *order);

/* Room for the lists of order->level_count levels and so many faces, all zero. errors
 * GP_ERROR_MEMORY */
GpResult order_make_room(Order *order, size_t faces);

#endif
