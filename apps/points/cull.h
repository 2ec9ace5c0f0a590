/* What of a view a patch is in: in front of it, inside its frustum, facing it.
 *
 * A surfel counts as seen where its disc, out to `reach` radii, is in the frustum, whose sides
 * stand `margin` pixels outside of the picture's, and where it faces the eye. The tests here never
 * lose such a surfel.
 */
#ifndef APPS_POINTS_CULL_H
#define APPS_POINTS_CULL_H

#include "apps/base/camera.h"
#include "apps/points/patches.h"

typedef struct PointView {
    double eye[3];
    CameraAxes axes;
    bool is_parallel;
    double near, far;
    double pixels; /* that a unit takes at depth 1; parallel: at any depth */
    double reach;  /* radii (standard deviations) out to which a surfel is drawn */
    double sides[4][3],
        side_offset[4]; /* planes, unit normals outwards: dot - offset > 0 is outside */
} PointView;

/* Of a picture of width x height pixels.
 * in     camera: in the space of the surfels
 *        reach: radii; margin: pixels that the low-pass filter adds to a splat at most */
PointView point_view(const Camera *camera, uint32_t width, uint32_t height, double reach,
                     double margin);

/* How a box, or its discs, lie in a view. */
typedef struct BoxPlace {
    double nearest, farthest; /* depth of the box's corners */
    double outside;           /* how far from the frustum the box is; negative: not, by any plane */
} BoxPlace;

BoxPlace box_place(const PointView *view, const PatchBox *box);

/* Whether surfels of the box, of at most this radius, may be seen. */
static inline bool box_is_seen(const PointView *view, const BoxPlace *place, double radius)
{
    return place->outside <= view->reach * radius;
}

/* The way from a box to the eye: the angle between it and the axis of a cone, and how far ways from
 * other places of the box differ from it. */
typedef struct EyeWay {
    double cosine, sine, spread_cosine, spread; /* spread 1: any way, the eye is at the box */
} EyeWay;

EyeWay eye_way(const PointView *view, const PatchBox *box, const float axis[3]);

/* The cosines between normals and the ways from surfels to the eye: low <= all of them <= high.
 * order  high <= 0: all face away */
typedef struct Facing {
    double low, high;
} Facing;

/* Of normals in a cone about that axis, of places in that box. */
Facing way_facing(const EyeWay *way, float cone_cosine, float cone_sine);

#endif
