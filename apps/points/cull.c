#include "apps/points/cull.h"

/* Cosines' slack: roundings, and the angle by which packed normals (compress.h) may be off. */
#define PACKED_NORMALS 0.02

PointView point_view(const Camera *camera, uint32_t width, uint32_t height, double reach,
                     double margin)
{
    PointView view = { .axes = camera_axes(camera, (double)width / height),
                       .is_parallel = camera->fovy == 0,
                       .near = camera->near,
                       .far = camera->far,
                       .reach = reach };
    vector_set(view.eye, camera->eye[0], camera->eye[1], camera->eye[2]);
    view.pixels = 0.5 * height / view.axes.half_height;
    const double half[2] = { view.axes.half_width * (1 + 2 * margin / width),
                             view.axes.half_height * (1 + 2 * margin / height) };
    for (int i = 0; i < 4; i++) {
        const double *across = i < 2 ? view.axes.right : view.axes.up;
        const double sign = i % 2 ? -1 : 1;
        double *side = view.sides[i];
        /* sign * across . p <= half * depth, or <= half */
        vector_set(side, 0, 0, 0);
        vector_add_scaled(side, sign, across, side);
        if (!view.is_parallel)
            vector_add_scaled(side, -half[i / 2], view.axes.forward, side);
        vector_normalize(side);
        view.side_offset[i] = vector_dot(side, view.eye) + (view.is_parallel ? half[i / 2] : 0);
    }
    return view;
}

/* Half the length of a box along a direction. */
static double half_along(const PatchBox *box, const double direction[3])
{
    double half = 0;
    for (int i = 0; i < 3; i++) {
        double axis[3];
        vector_widen(box->axes[i], axis);
        half += (double)box->half[i] * fabs(vector_dot(axis, direction));
    }
    return half;
}

BoxPlace box_place(const PointView *view, const PatchBox *box)
{
    double centre[3], from[3];
    vector_widen(box->centre, centre);
    vector_subtract(centre, view->eye, from);
    const double depth = vector_dot(view->axes.forward, from);
    const double half = half_along(box, view->axes.forward);
    BoxPlace place = { .nearest = depth - half, .farthest = depth + half };
    const double before = view->near - place.farthest, behind = place.nearest - view->far;
    place.outside = before > behind ? before : behind;
    for (int i = 0; i < 4; i++) {
        const double outside = vector_dot(view->sides[i], centre) - view->side_offset[i] -
                               half_along(box, view->sides[i]);
        place.outside = outside > place.outside ? outside : place.outside;
    }
    return place;
}

/* The cosine of the sum, or of the difference, of two angles up to 90 degrees and up to 180, kept
 * inside of 0 and 180 degrees. */
static double cosine_of(double cosine, double sine, double widen_cosine, double widen_sine,
                        int sign)
{
    const double beyond = sign > 0 ? -widen_cosine : widen_cosine;
    if (sign > 0 ? cosine <= beyond : cosine >= beyond)
        return sign > 0 ? -1 : 1;
    return cosine * widen_cosine - sign * sine * widen_sine;
}

EyeWay eye_way(const PointView *view, const PatchBox *box, const float axis[3])
{
    double way[3], about[3], centre[3], half[3], spread = 0;
    vector_widen(axis, about);
    vector_widen(box->centre, centre);
    vector_widen(box->half, half);
    vector_subtract(view->eye, centre, way);
    if (view->is_parallel) {
        vector_set(way, -view->axes.forward[0], -view->axes.forward[1], -view->axes.forward[2]);
    } else {
        const double distance = sqrt(vector_dot(way, way)), radius = sqrt(vector_dot(half, half));
        spread = distance > radius ? radius / distance : 1;
        vector_normalize(way);
    }
    double cosine = vector_dot(about, way);
    cosine = cosine < -1 ? -1 : cosine > 1 ? 1 : cosine;
    return (EyeWay){ cosine, sqrt(1 - cosine * cosine), sqrt(1 - spread * spread), spread };
}

/* With v the way from the box's centre to the eye, a the cone's axis and b the angle by which ways
 * from other places of the ball around the box differ from v at most, an angle between a normal and
 * a way is that of a and v, more or less at most the cone's angle and b.
 * source Shirman and Abi-Ezzi, "The cone of normals technique", Eurographics 1993 */
Facing way_facing(const EyeWay *way, float cone_cosine, float cone_sine)
{
    const double cosine = (double)cone_cosine, sine = (double)cone_sine;
    if (cosine <= 0 || way->spread >= 1)
        return (Facing){ -1, 1 };
    const double sum_cosine = cosine * way->spread_cosine - sine * way->spread;
    const double sum_sine = sine * way->spread_cosine + cosine * way->spread;
    const double low = cosine_of(way->cosine, way->sine, sum_cosine, sum_sine, 1) - PACKED_NORMALS;
    const double high =
        cosine_of(way->cosine, way->sine, sum_cosine, sum_sine, -1) + PACKED_NORMALS;
    return (Facing){ low < -1 ? -1 : low, high > 1 ? 1 : high };
}
