/* The order in which cells of a depth image are drawn so that the nearer wins without a depth test.
 *
 * A ray from the eye e crosses the picture along a line through the epipole, where e itself is
 * seen. A point of the ray is seen under an angle from the direction of e that grows along the ray.
 * So of two on one ray that which is nearer to e in the picture, by this angle, hides the other,
 * and comes later: cells go towards the epipole where it stands for e, and away from it where it
 * stands for -e. The picture is cut through the epipole into up to four sheets, in each of which
 * the cells come by rows and columns.
 * source McMillan, "A list-priority rendering algorithm for redisplaying projected surfaces", 1995
 */
#ifndef APPS_DEPTH_IMAGES_DRAWING_ORDER_H
#define APPS_DEPTH_IMAGES_DRAWING_ORDER_H

#include "apps/depth_images/drawing/edges.h"

typedef struct WarpOrder {
    double epipole[2]; /* of the picture, in pixels; infinite where it is only a direction */
    bool away;         /* cells go away from the epipole */
} WarpOrder;

/* in eye: x, y, z, w in the image's axes (right, up, forward); w 0: where parallel rays come
 *      from */
WarpOrder warp_order(const DepthPlane *plane, const DepthPixels *pixels, const double eye[4]);

/* Two triangles of each whole cell of which all depths are between two.
 * out    indices: room for 6 of each cell; of vertices by number of the lattice
 * order  as above
 * returns how many there are */
uint32_t warp_order_cells(const WarpOrder *order, const DepthLattice *lattice,
                          const double range[2], uint32_t *indices);

#endif
