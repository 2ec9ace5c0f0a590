#include "apps/fragments/order/front.h"

#include "apps/fragments/pieces/side.h"

#include <string.h>

FrontView front_view(const FragmentMesh *mesh, const double (*planes)[4], double doubt,
                     const Camera *camera)
{
    FrontView view = {
        .mesh = mesh, .planes = planes, .doubt = doubt, .is_parallel = camera->fovy <= 0
    };
    if (view.is_parallel) {
        const CameraAxes axes = camera_axes(camera, 1);
        memcpy(view.eye, axes.forward, sizeof view.eye);
    } else {
        memcpy(view.eye, camera->eye, sizeof view.eye);
    }
    return view;
}

static const float *corner_of(const FrontView *view, uint32_t face, uint32_t corner)
{
    return view->mesh->positions[view->mesh->indices[3 * (size_t)face + corner]];
}

/* --- by planes -------------------------------------------------------------------------------- */

/* On which side of a face's plane the eye is: 1, -1, or 0 where that cannot be told. */
static int eye_side(const FrontView *view, uint32_t face)
{
    const double *plane = view->planes[face];
    const double along = vector_dot(plane, view->eye);
    const double distance = view->is_parallel ? -along : along - plane[3];
    return (distance > view->doubt) - (distance < -view->doubt);
}

static int corner_side(const FrontView *view, uint32_t face, const float point[3])
{
    const double *plane = view->planes[face];
    const double distance = plane[0] * (double)point[0] + plane[1] * (double)point[1] +
                            plane[2] * (double)point[2] - plane[3];
    if (distance > view->doubt || distance < -view->doubt)
        return distance > 0 ? 1 : -1;
    return side_of_plane(corner_of(view, face, 0), corner_of(view, face, 1),
                         corner_of(view, face, 2), point);
}

enum { TOWARD = 1, AWAY = 2 };

/* On which sides of a face's plane another's corners are, seen from the eye. */
static unsigned sides_of(const FrontView *view, uint32_t face, uint32_t other, int eye)
{
    unsigned sides = 0;
    for (uint32_t c = 0; c < 3; c++) {
        const int side = eye * corner_side(view, face, corner_of(view, other, c));
        sides |= side > 0 ? TOWARD : side < 0 ? AWAY : 0;
    }
    return sides;
}

/* --- by the corners of what two triangles have in common -------------------------------------- */

typedef double Vector[3];

/* A triangle's corners, from the eye, and the planes through the eye and its edges. */
typedef struct Cone {
    Vector corner[3], edge[3];
} Cone;

static void find_cone(const FrontView *view, uint32_t face, Cone *cone)
{
    for (uint32_t c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            cone->corner[c][k] =
                (double)corner_of(view, face, c)[k] - (view->is_parallel ? 0 : view->eye[k]);
    for (int c = 0; c < 3; c++) {
        const double *from = cone->corner[c], *to = cone->corner[(c + 1) % 3];
        if (view->is_parallel) {
            Vector along;
            vector_subtract(to, from, along);
            vector_cross(along, view->eye, cone->edge[c]);
        } else {
            vector_cross(from, to, cone->edge[c]);
        }
    }
}

/* The value of an edge's plane at a point from the eye. */
static double edge_at(const FrontView *view, const Cone *cone, int edge, const Vector point)
{
    const double at = vector_dot(cone->edge[edge], point);
    return view->is_parallel ? at - vector_dot(cone->edge[edge], cone->corner[edge]) : at;
}

/* How far along the view a point is. */
static double depth_at(const FrontView *view, const Vector point)
{
    return view->is_parallel ? vector_dot(point, view->eye) : sqrt(vector_dot(point, point));
}

static unsigned compare_depths(double a, double b)
{
    const double same = 1e-11 * (fabs(a) + fabs(b));
    return a < b - same ? FRONT_FIRST : b < a - same ? FRONT_SECOND : 0;
}

/* Where one triangle's edge is cut by the plane of another's, if it is; else false. */
static bool cut_edge(const Vector from, const Vector to, double from_side, double to_side,
                     Vector cut)
{
    if (!((from_side > 0 && to_side < 0) || (from_side < 0 && to_side > 0)))
        return false;
    const double share = from_side / (from_side - to_side);
    for (int k = 0; k < 3; k++)
        cut[k] = from[k] + share * (to[k] - from[k]);
    return true;
}

/* Orders at the crossings of edges, as seen. */
static unsigned compare_edges(const FrontView *view, const Cone *a, const Cone *b)
{
    double a_by_b[3][3], b_by_a[3][3]; /* [edge of the other][corner] */
    unsigned order = 0;
    for (int e = 0; e < 3; e++)
        for (int c = 0; c < 3; c++) {
            a_by_b[e][c] = edge_at(view, b, e, a->corner[c]);
            b_by_a[e][c] = edge_at(view, a, e, b->corner[c]);
        }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            const int i1 = (i + 1) % 3, k1 = (k + 1) % 3;
            Vector of_a, of_b;
            if (cut_edge(a->corner[i], a->corner[i1], a_by_b[k][i], a_by_b[k][i1], of_a) &&
                cut_edge(b->corner[k], b->corner[k1], b_by_a[i][k], b_by_a[i][k1], of_b))
                order |= compare_depths(depth_at(view, of_a), depth_at(view, of_b));
        }
    return order;
}

/* Whether a point is seen inside a triangle. */
static bool is_inside(const FrontView *view, const Cone *cone, const Vector point)
{
    int positive = 0, negative = 0;
    for (int e = 0; e < 3; e++) {
        const double at = edge_at(view, cone, e, point);
        positive += at > 0;
        negative += at < 0;
    }
    return positive == 3 || negative == 3;
}

/* Orders at the corners of `other` that are seen inside `face`: those towards the eye are in
 * front. */
static unsigned compare_corners(const FrontView *view, uint32_t face, const Cone *cone,
                                uint32_t other, const Cone *points, int eye)
{
    unsigned sides = 0;
    for (uint32_t c = 0; c < 3; c++)
        if (is_inside(view, cone, points->corner[c])) {
            const int side = eye * corner_side(view, face, corner_of(view, other, c));
            sides |= side > 0 ? TOWARD : side < 0 ? AWAY : 0;
        }
    return sides;
}

static double middle_depth(const FrontView *view, const Cone *cone)
{
    Vector middle;
    for (int k = 0; k < 3; k++)
        middle[k] = (cone->corner[0][k] + cone->corner[1][k] + cone->corner[2][k]) / 3;
    return depth_at(view, middle);
}

static unsigned turned(unsigned order)
{
    return (order & 1) << 1 | order >> 1;
}

static unsigned compare_parts(const FrontView *view, uint32_t a, uint32_t b, int eye_a, int eye_b)
{
    Cone cone[2];
    find_cone(view, a, &cone[0]);
    find_cone(view, b, &cone[1]);
    unsigned order = compare_edges(view, &cone[0], &cone[1]);
    order |= turned(compare_corners(view, a, &cone[0], b, &cone[1], eye_a));
    order |= compare_corners(view, b, &cone[1], a, &cone[0], eye_b);
    if (order == 0) /* they meet on the screen by its steps alone */
        order = middle_depth(view, &cone[0]) <= middle_depth(view, &cone[1]) ? FRONT_FIRST
                                                                             : FRONT_SECOND;
    return order;
}

unsigned front_of_two(const FrontView *view, uint32_t a, uint32_t b)
{
    const int eye_a = eye_side(view, a), eye_b = eye_side(view, b);
    if (eye_a) {
        const unsigned sides = sides_of(view, a, b, eye_a);
        if (sides == 0)
            return a < b ? FRONT_FIRST : FRONT_SECOND;
        if (sides != (TOWARD | AWAY))
            return sides == TOWARD ? FRONT_SECOND : FRONT_FIRST;
    }
    if (eye_b) {
        const unsigned sides = sides_of(view, b, a, eye_b);
        if (sides == TOWARD || sides == AWAY)
            return sides == TOWARD ? FRONT_FIRST : FRONT_SECOND;
    }
    return compare_parts(view, a, b, eye_a, eye_b);
}
