/* How two convex pieces are parted. */
#ifndef APPS_FRAGMENTS_ORDER_PART_TWO_H
#define APPS_FRAGMENTS_ORDER_PART_TWO_H

#include "apps/fragments/order/parting.h"

/* What pieces are looked at with. Borrowed. */
typedef struct PartWork {
    const OrderMesh *mesh;
    const uint32_t *place_of; /* of vertices */
    uint32_t *mark;           /* by place: the last that marked it */
    uint32_t marks;
} PartWork;

/* A slab across a direction: what of the pieces reaches beyond its planes leaves them. */
typedef struct Slab {
    double normal[3], low,
        high; /* what is left of the lower piece is up to low, that of the other from high on */
} Slab;

/* out    parting: without the number of its slab; slab: where it is one
 * source planes: of faces of either, across axes, and by nearest points: Gilbert, "An iterative
 *        procedure for computing the minimum of a quadratic form on a convex set", 1966; slabs:
 *        paper 002, section 3.2.2 */
void part_two(PartWork *work, uint32_t a, uint32_t b, Parting *parting, Slab *slab);

#endif
