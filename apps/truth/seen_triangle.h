/* A triangle as a picture sees it, in double: which places it covers, and at what depth.
 *
 * source Olano and Greer, "Triangle scan conversion using 2D homogeneous coordinates", Graphics
 *        Hardware 1997: triangles are not clipped, not even those that begin behind the eye */
#ifndef APPS_TRUTH_SEEN_TRIANGLE_H
#define APPS_TRUTH_SEEN_TRIANGLE_H

#include "apps/base/camera.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct SeenView {
    Camera camera;
    CameraAxes axes;
    uint32_t width, height;
} SeenView;

SeenView seen_view(const Camera *camera, uint32_t width, uint32_t height);

/* Corners are (X, Y, Z, W), where (X / W, Y / W) is a place in pixels, y down, Z / W its depth, 0
 * near, 1 far; W is 1 where rays are parallel. A place (x, y) is inside where edge[i] . (x, y, 1)
 * are of one sign; they are also the shares of the corners in it. */
typedef struct SeenTriangle {
    double edge[3][3];
    double z[3], w[3];
    double low[2], high[2]; /* box of what is to be asked for, in pixels */
    bool is_before;         /* all corners are before the eye: edges end */
    double at[3][2];        /* then where they are */
} SeenTriangle;

void seen_triangle_make(const SeenView *view, const float (*positions)[3], const uint32_t index[3],
                        SeenTriangle *seen);

/* A triangle at a place. */
typedef struct SeenAt {
    /* An edge is as near as snapped corners may bring it, 1/256 pixel; so are the edges that the
     * near and the far plane make. */
    bool is_near_edge;
    bool is_covered; /* and neither too near nor too far */
    double depth;    /* of what is covered, 0..1 */
    /* as far as corners that are snapped to 1/256 pixel and rounded to floats may move it */
    double moved;
} SeenAt;

void seen_triangle_at(const SeenTriangle *seen, const double place[2], SeenAt *at);

#endif
