#include "apps/techniques/shadow/light_fit.h"
#include "apps/scene/bounds.h"

#include <math.h>
#include <string.h>

static const double margin = 1.02;

typedef struct Rectangle {
    double low[2], high[2];
} Rectangle;

static const Rectangle nowhere = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } };

static bool is_empty(const Rectangle *r)
{
    return !(r->low[0] < r->high[0] && r->low[1] < r->high[1]);
}

static double row_times(const double row[4], const double point[3])
{
    return vector_dot(row, point) + row[3];
}

/* What is not before the light may be anywhere on the map. */
static void add_projected(Rectangle *r, double clip[4][4], const double point[3])
{
    double w = row_times(clip[3], point);
    for (int k = 0; k < 2; k++) {
        double x = row_times(clip[k], point) / w;
        r->low[k] = fmin(r->low[k], w > 0 ? x : -HUGE_VAL);
        r->high[k] = fmax(r->high[k], w > 0 ? x : HUGE_VAL);
    }
}

static void intersect(Rectangle *r, const Rectangle *other)
{
    for (int k = 0; k < 2; k++) {
        r->low[k] = fmax(r->low[k], other->low[k]);
        r->high[k] = fmin(r->high[k], other->high[k]);
    }
}

/* Spreads a rectangle over the map. */
static void crop(double clip[4][4], const Rectangle *r, const double side[2])
{
    for (int k = 0; k < 2; k++) {
        double centre = 0.5 * (r->low[k] + r->high[k]);
        for (int i = 0; i < 4; i++)
            clip[k][i] = (clip[k][i] - centre * clip[3][i]) * 2 / side[k];
    }
}

/* --- what can cast ---------------------------------------------------------------------------- */

static Rectangle find_casters(const SceneCasters *casters, double clip[4][4])
{
    const GpPass *pass = &casters->scene->list.passes[0];
    Rectangle r = nowhere;
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        CasterVertices vertices = caster_vertices(casters, i);
        for (uint32_t j; caster_next_vertex(&vertices, &j);) {
            double position[3];
            draw_position(&pass->draws[i], j, position);
            add_projected(&r, clip, position);
        }
    }
    return r;
}

/* Spreads a square around the casters over the map, with a margin for filters. A view in which
 * there are none stays. */
static void fit_casters(const SceneCasters *casters, LightView *view)
{
    static const Rectangle whole = { { -1, -1 }, { 1, 1 } };
    Rectangle r = find_casters(casters, view->clip);
    intersect(&r, &whole);
    if (is_empty(&r))
        return;
    double side = fmax(r.high[0] - r.low[0], r.high[1] - r.low[1]) * margin;
    crop(view->clip, &r, (double[2]){ side, side });
    view->width *= side / 2;
}

/* --- what is seen ----------------------------------------------------------------------------- */

enum { PLANES = 18 }; /* of the eye's frustum, the light's and a box */

typedef struct Plane {
    double normal[3], distance; /* normal . p + distance >= 0 inside */
} Plane;

/* The corners of what can be seen and lit. */
typedef struct Seen {
    uint32_t corners;
    double centre[3];         /* sum of the corners, then their mean */
    double nearest, farthest; /* from the eye, along its view */
    Rectangle place;          /* on the map */
} Seen;

static Plane make_plane(const double row[4], double sign, const double w[4])
{
    Plane plane;
    for (int k = 0; k < 3; k++)
        plane.normal[k] = w[k] + sign * row[k];
    double length = sqrt(vector_dot(plane.normal, plane.normal));
    for (int k = 0; k < 3; k++)
        plane.normal[k] /= length;
    plane.distance = (w[3] + sign * row[3]) / length;
    return plane;
}

/* -w <= x <= w, -w <= y <= w, 0 <= z <= w. */
static void frustum_planes(double clip[4][4], Plane planes[6])
{
    static const double zero[4] = { 0 };
    for (int k = 0; k < 3; k++) {
        planes[2 * k] = make_plane(clip[k], 1, k < 2 ? clip[3] : zero);
        planes[2 * k + 1] = make_plane(clip[k], -1, clip[3]);
    }
}

static void box_planes(const Bounds *box, Plane planes[6])
{
    for (int k = 0; k < 3; k++) {
        double row[4] = { 0 };
        row[k] = 1;
        planes[2 * k] = make_plane(row, 1, (double[4]){ 0, 0, 0, -box->low[k] });
        planes[2 * k + 1] = make_plane(row, -1, (double[4]){ 0, 0, 0, box->high[k] });
    }
}

/* Where three planes meet; false where they do not, in one point. */
static bool meet(const Plane *a, const Plane *b, const Plane *c, double point[3])
{
    double bc[3], ca[3], ab[3];
    vector_cross(b->normal, c->normal, bc);
    vector_cross(c->normal, a->normal, ca);
    vector_cross(a->normal, b->normal, ab);
    double volume = vector_dot(a->normal, bc);
    for (int k = 0; k < 3; k++)
        point[k] = -(a->distance * bc[k] + b->distance * ca[k] + c->distance * ab[k]) / volume;
    return fabs(volume) > 1e-9;
}

static bool is_inside(const Plane *planes, const double point[3], double tolerance)
{
    for (int i = 0; i < PLANES; i++)
        if (vector_dot(planes[i].normal, point) + planes[i].distance < -tolerance)
            return false;
    return true;
}

/* Adds the corners of a convex body: all places where three of its planes meet and that are inside
 * the others. */
static void add_body(Seen *seen, const Plane *planes, double tolerance, double eye[4][4],
                     double clip[4][4])
{
    double point[3];
    for (int a = 0; a < PLANES; a++)
        for (int b = a + 1; b < PLANES; b++)
            for (int c = b + 1; c < PLANES; c++) {
                if (!meet(&planes[a], &planes[b], &planes[c], point) ||
                    !is_inside(planes, point, tolerance))
                    continue;
                double distance = row_times(eye[3], point);
                seen->corners++;
                seen->nearest = fmin(seen->nearest, distance);
                seen->farthest = fmax(seen->farthest, distance);
                for (int k = 0; k < 3; k++)
                    seen->centre[k] += point[k];
                add_projected(&seen->place, clip, point);
            }
}

/* What of the objects' boxes both the eye and the light's map see, and its place under a matrix: at
 * most that of the casters, since the map lights everything beside them. */
static Seen look(const SceneCasters *casters, double eye[4][4], double map[4][4], double clip[4][4])
{
    const GpPass *pass = &casters->scene->list.passes[0];
    Plane planes[PLANES];
    Seen seen = { .nearest = HUGE_VAL, .farthest = -HUGE_VAL, .place = nowhere };
    frustum_planes(eye, planes);
    frustum_planes(map, planes + 6);
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        Bounds box = draw_bounds(&pass->draws[i]);
        double size = fmax(vector_extent(box.low), vector_extent(box.high));
        box_planes(&box, planes + 12);
        add_body(&seen, planes, 1e-9 * size, eye, clip);
    }
    for (int k = 0; k < 3 && seen.corners > 0; k++)
        seen.centre[k] /= seen.corners;
    const Rectangle cast = find_casters(casters, clip);
    intersect(&seen.place, &cast);
    return seen;
}

/* --- the warp --------------------------------------------------------------------------------- */

/* How the eye's view crosses the light's rays in the centre of what is seen. */
typedef struct Crossing {
    double way[2]; /* on the map, away from the eye; unit length */
    double speed;  /* along it, of a step of 1 along the view */
    double sine;   /* between the view and the ray; 0: there is no way */
} Crossing;

static Crossing find_crossing(const Scene *scene, double clip[4][4], const double centre[3])
{
    double forward[3], step[2][3], ray[3], across[3];
    vector_subtract(scene->camera.at, scene->camera.eye, forward);
    vector_normalize(forward);
    double w = row_times(clip[3], centre);
    for (int k = 0; k < 2; k++) {
        double place = row_times(clip[k], centre) / w;
        for (int i = 0; i < 3; i++)
            step[k][i] = (clip[k][i] - place * clip[3][i]) / w;
    }
    vector_cross(step[0], step[1], ray);
    vector_normalize(ray);
    vector_cross(ray, forward, across);
    double x = vector_dot(step[0], forward), y = vector_dot(step[1], forward);
    Crossing crossing = { .speed = sqrt(x * x + y * y), .sine = sqrt(vector_dot(across, across)) };
    crossing.way[0] = x / crossing.speed;
    crossing.way[1] = y / crossing.speed;
    return crossing;
}

/* Turns the map so that y runs along a way, and leaves the rest. */
static void turn(double from[4][4], const double way[2], double to[4][4])
{
    memcpy(to, from, sizeof(double[4][4]));
    for (int i = 0; i < 4; i++) {
        to[0][i] = way[1] * from[0][i] - way[0] * from[1][i];
        to[1][i] = way[0] * from[0][i] + way[1] * from[1][i];
    }
}

/* Gives what is near to the eye more of a map that has been fitted to the casters, and nothing to
 * what the eye cannot see: a projective map of the map's plane, whose lines of equal density lie
 * across the way the eye looks.
 *
 * x y w are multiplied by a 3x3 matrix and z by a number, so that planes stay planes (slope-scaled
 * bias works as ever), order along each ray of the light is kept, and 0 <= z <= w where it held
 * before, on the map. All that lies along a ray of the light has one place on the map: what is seen
 * decides, and whatever shades it is there with it.
 *
 * It stands for perspective shadow maps (Stamminger and Drettakis, SIGGRAPH 2002), which warp by
 * the eye's own matrix. That turns inside out what is behind the eye, so that the eye must be moved
 * back until it sees all casters, and the map's quality jumps as it does; lights become points or
 * sinks of light by the side they are on. A perspective of the light's own space, square to its
 * rays, has neither, and its strength can be chosen.
 *
 * The view stays as it is where the eye looks along the light's rays (duelling frusta: what is near
 * and what is far then share a place on the map, and no warp of it can tell them apart), and where
 * nothing of the map is seen.
 * source Wimmer, Scherzer and Purgathofer, "Light space perspective shadow maps", EGSR 2004: n_opt
 *        of section 4. Theirs is for parallel rays; ours works after the light's own perspective,
 *        where all rays are parallel, at the scale of the centre of what is seen */
static void fit_eye(const SceneCasters *casters, LightView *view)
{
    const Scene *scene = casters->scene;
    static const double least_sine = 0.05; /* 3 degrees */
    double to_eye[4][4], projection[4][4], eye[4][4], turned[4][4], warped[4][4];
    double aspect = (double)scene->picture->width / scene->picture->height;
    camera_view(&scene->camera, to_eye);
    camera_projection(&scene->camera, aspect, projection);
    matrix_multiply(projection, to_eye, eye);

    Seen seen = look(casters, eye, view->clip, view->clip);
    if (is_empty(&seen.place))
        return;
    Crossing crossing = find_crossing(scene, view->clip, seen.centre);
    if (crossing.sine < least_sine)
        return;
    turn(view->clip, crossing.way, turned);
    Rectangle place = look(casters, eye, view->clip, turned).place;
    if (is_empty(&place))
        return;

    /* The near plane, `near` before what is seen first, where a unit of the world across the rays
     * takes speed / sine of the map. */
    double n_opt = (seen.nearest + sqrt(seen.nearest * seen.farthest)) / crossing.sine;
    double near = n_opt * crossing.speed / crossing.sine;
    double depth = place.high[1] - place.low[1];
    double axis = row_times(turned[0], seen.centre) / row_times(turned[3], seen.centre);
    for (int i = 0; i < 4; i++) {
        double w = turned[3][i];
        warped[0][i] = turned[0][i] - axis * w;
        warped[1][i] = turned[1][i] - place.low[1] * w;
        warped[2][i] = turned[2][i] * near; /* at most w * near, and the new w is more than that */
        warped[3][i] = turned[1][i] - (place.low[1] - near) * w;
    }
    Rectangle all = look(casters, eye, view->clip, warped).place;
    if (is_empty(&all))
        return;
    double side[2] = { (all.high[0] - all.low[0]) * margin, (all.high[1] - all.low[1]) * margin };
    crop(warped, &all, side);
    memcpy(view->clip, warped, sizeof view->clip);
    /* The longer side of a texel; that along the way grows by 1 + depth / near: in the centre. */
    view->width *= fmax(side[0], side[1] * sqrt(1 + depth / near)) / 2;
}

LightView light_fit(const SceneCasters *casters, int face, LightFit fit)
{
    LightView view = light_view(casters, face, fit != LIGHT_FIT_LIGHT);
    if (light_shines_around(casters->light) || fit == LIGHT_FIT_LIGHT)
        return view;
    fit_casters(casters, &view);
    if (fit == LIGHT_FIT_EYE)
        fit_eye(casters, &view);
    return view;
}
