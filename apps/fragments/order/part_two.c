#include "apps/fragments/order/part_two.h"

#include "apps/base/symmetric.h"
#include "apps/base/vector.h"

#include <float.h>
#include <string.h>

typedef struct Ends {
    double low, high;
} Ends;

static const float *corner_of(const PartWork *work, uint32_t at)
{
    const FragmentMesh *mesh = work->mesh->mesh;
    return mesh->positions[mesh->indices[3 * (size_t)work->mesh->pieces->faces[at / 3] + at % 3]];
}

static double along(const double normal[3], const float *point)
{
    return normal[0] * (double)point[0] + normal[1] * (double)point[1] +
           normal[2] * (double)point[2];
}

/* How far a piece reaches along a direction. */
static Ends ends_of(const PartWork *work, uint32_t piece, const double normal[3])
{
    const Pieces *pieces = work->mesh->pieces;
    Ends ends = { DBL_MAX, -DBL_MAX };
    for (uint32_t i = 3 * pieces->first[piece]; i < 3 * pieces->first[piece + 1]; i++) {
        const double at = along(normal, corner_of(work, i));
        ends.low = fmin(ends.low, at);
        ends.high = fmax(ends.high, at);
    }
    return ends;
}

/* --- planes ----------------------------------------------------------------------------------- */

static void set_plane(Parting *parting, uint32_t low, uint32_t high, const double normal[3],
                      double distance)
{
    *parting = (Parting){ .low = low, .high = high, .kind = PARTING_PLANE, .slab = NO_SLAB };
    memcpy(parting->plane, normal, 3 * sizeof *normal);
    parting->plane[3] = distance;
}

/* Tries planes across a direction. */
static bool part_along(const PartWork *work, uint32_t a, uint32_t b, const double normal[3],
                       Parting *parting)
{
    const Ends one = ends_of(work, a, normal), other = ends_of(work, b, normal);
    if (one.high <= other.low + work->mesh->doubt)
        set_plane(parting, a, b, normal, (one.high + other.low) / 2);
    else if (other.high <= one.low + work->mesh->doubt)
        set_plane(parting, b, a, normal, (other.high + one.low) / 2);
    else
        return false;
    return true;
}

/* A piece is behind the planes of its faces, as they are turned; whether another is in front of one
 * of them. */
static bool part_by_faces(const PartWork *work, uint32_t piece, uint32_t other, Parting *parting)
{
    const Pieces *pieces = work->mesh->pieces;
    const double sign = pieces->inward[piece] ? -1 : 1;
    for (uint32_t i = pieces->first[piece]; i < pieces->first[piece + 1]; i++) {
        const double *plane = work->mesh->planes[pieces->faces[i]];
        bool in_front = vector_dot(plane, plane) > 0;
        for (uint32_t k = 3 * pieces->first[other]; k < 3 * pieces->first[other + 1] && in_front;
             k++)
            in_front = sign * (along(plane, corner_of(work, k)) - plane[3]) >= -work->mesh->doubt;
        if (!in_front)
            continue;
        set_plane(parting, piece, other, plane, plane[3]);
        for (int k = 0; k < 4; k++)
            parting->plane[k] *= sign;
        return true;
    }
    return false;
}

/* Whether a piece is behind all planes of another. */
static bool is_nested(const PartWork *work, uint32_t outer, uint32_t inner)
{
    const Pieces *pieces = work->mesh->pieces;
    const double sign = pieces->inward[outer] ? -1 : 1;
    for (uint32_t i = pieces->first[outer]; i < pieces->first[outer + 1]; i++) {
        const double *plane = work->mesh->planes[pieces->faces[i]];
        for (uint32_t k = 3 * pieces->first[inner]; k < 3 * pieces->first[inner + 1]; k++)
            if (sign * (along(plane, corner_of(work, k)) - plane[3]) > work->mesh->doubt)
                return false;
    }
    return true;
}

/* The corner of a piece that is farthest along a direction. */
static const float *farthest(const PartWork *work, uint32_t piece, const double way[3], double sign)
{
    const Pieces *pieces = work->mesh->pieces;
    const float *found = corner_of(work, 3 * pieces->first[piece]);
    double most = -DBL_MAX;
    for (uint32_t i = 3 * pieces->first[piece]; i < 3 * pieces->first[piece + 1]; i++) {
        const float *point = corner_of(work, i);
        const double at = sign * along(way, point);
        found = at > most ? point : found;
        most = at > most ? at : most;
    }
    return found;
}

/* Walks over the differences of points of both pieces towards the one that is least: across it lies
 * a plane that parts them, if one does with room to spare. */
static bool part_by_nearest(const PartWork *work, uint32_t a, uint32_t b, Parting *parting)
{
    enum { STEPS = 32 };
    double least[3];
    for (int k = 0; k < 3; k++)
        least[k] = (double)corner_of(work, 3 * work->mesh->pieces->first[b])[k] -
                   (double)corner_of(work, 3 * work->mesh->pieces->first[a])[k];
    for (int step = 0; step < STEPS; step++) {
        const float *of_a = farthest(work, a, least, 1), *of_b = farthest(work, b, least, -1);
        double next[3], way[3];
        for (int k = 0; k < 3; k++)
            next[k] = (double)of_b[k] - (double)of_a[k];
        vector_subtract(next, least, way);
        if (vector_dot(next, least) > 0) {
            vector_normalize(least);
            return part_along(work, a, b, least, parting);
        }
        const double square = vector_dot(way, way);
        const double share = square > 0 ? fmin(-vector_dot(least, way) / square, 1) : 0;
        if (!(share > 0))
            return false;
        vector_add_scaled(least, share, way, least);
    }
    return false;
}

/* --- slabs ------------------------------------------------------------------------------------ */

/* The shortest axis of the corners of a piece's faces that stand at places of another's, or else of
 * all. */
static void short_axis(PartWork *work, uint32_t piece, uint32_t other, double axis[3])
{
    const Pieces *pieces = work->mesh->pieces;
    const uint32_t *indices = work->mesh->mesh->indices;
    Moments touching = { .count = 0 }, all = { .count = 0 };
    double values[3], vectors[3][3];
    for (int k = 0; k < 3; k++)
        touching.origin[k] = all.origin[k] = (double)corner_of(work, 3 * pieces->first[piece])[k];
    work->marks++;
    for (uint32_t i = 3 * pieces->first[other]; i < 3 * pieces->first[other + 1]; i++)
        work->mark[work->place_of[indices[3 * (size_t)pieces->faces[i / 3] + i % 3]]] = work->marks;
    for (uint32_t i = pieces->first[piece]; i < pieces->first[piece + 1]; i++) {
        const uint32_t *corner = indices + 3 * (size_t)pieces->faces[i];
        bool touches = false;
        for (int c = 0; c < 3; c++)
            touches |= work->mark[work->place_of[corner[c]]] == work->marks;
        for (uint32_t c = 0; c < 3; c++) {
            moments_add(&all, corner_of(work, 3 * i + c));
            if (touches)
                moments_add(&touching, corner_of(work, 3 * i + c));
        }
    }
    const Symmetric spread = moments_covariance(touching.count > 0 ? &touching : &all);
    symmetric_eigen(&spread, values, vectors);
    memcpy(axis, vectors[2], sizeof vectors[2]);
}

/* The slab across an axis that parts them. returns which is the lower */
static uint32_t slab_along(const PartWork *work, uint32_t a, uint32_t b, const double axis[3],
                           Slab *slab)
{
    const Ends one = ends_of(work, a, axis), other = ends_of(work, b, axis);
    const bool turned = one.low + one.high > other.low + other.high;
    memcpy(slab->normal, axis, sizeof slab->normal);
    slab->low = turned ? one.low : other.low;
    slab->high = turned ? other.high : one.high;
    return turned ? b : a;
}

static void part_by_slab(PartWork *work, uint32_t a, uint32_t b, Parting *parting, Slab *slab)
{
    double axis[2][3];
    Slab tried[2];
    short_axis(work, a, b, axis[0]);
    short_axis(work, b, a, axis[1]);
    uint32_t low[2];
    for (int i = 0; i < 2; i++)
        low[i] = slab_along(work, a, b, axis[i], &tried[i]);
    const int thin = tried[1].high - tried[1].low < tried[0].high - tried[0].low;
    *slab = tried[thin];
    set_plane(parting, low[thin], low[thin] == a ? b : a, slab->normal,
              (slab->low + slab->high) / 2);
    parting->kind = PARTING_SLAB;
}

/* --- both ------------------------------------------------------------------------------------- */

void part_two(PartWork *work, uint32_t a, uint32_t b, Parting *parting, Slab *slab)
{
    for (int k = 3; k < ORDER_AXES; k++) { /* boxes are not apart */
        double axis[3] = { order_axes[k][0], order_axes[k][1], order_axes[k][2] };
        vector_normalize(axis);
        if (part_along(work, a, b, axis, parting))
            return;
    }
    if (part_by_faces(work, a, b, parting) || part_by_faces(work, b, a, parting))
        return;
    for (int turn = 0; turn < 2; turn++)
        if (is_nested(work, turn ? b : a, turn ? a : b)) {
            *parting = (Parting){ turn ? b : a, turn ? a : b, PARTING_NESTED, NO_SLAB, { 0 } };
            return;
        }
    if (!part_by_nearest(work, a, b, parting))
        part_by_slab(work, a, b, parting, slab);
}
