#include "apps/fragments/pieces/convex_set.h"

#include "apps/base/vector.h"
#include "apps/fragments/pieces/side.h"

#include <string.h>

/* Planes, or corners, with boxes about each BLOCK of them, from which follows that most are far
 * away. */
enum { BLOCK = 32 };

typedef struct Rows {
    double (*row)[4];    /* a plane's normal, unit length, and distance; a corner and -1 */
    uint32_t *name;      /* the face; the corner's place in the index list */
    double (*box)[2][4]; /* least and greatest of each whole block */
    uint32_t count;
} Rows;

struct ConvexSet {
    const ConvexMesh *mesh;
    bool inward;
    double doubt; /* distances within it of 0 are looked at exactly */
    Rows planes, corners;
    uint32_t *corner_mark; /* by place: the mark of this set, if a corner is among its corners */
    uint32_t *old_count;   /* corners before each face was added */
    uint32_t mark;
};

/* --- rows ------------------------------------------------------------------------------------- */

static bool rows_alloc(Rows *rows, uint32_t room)
{
    rows->row = gp_alloc(room, sizeof *rows->row);
    rows->name = gp_alloc(room, sizeof *rows->name);
    rows->box = gp_alloc(room / BLOCK + 1, sizeof *rows->box);
    return rows->row && rows->name && rows->box;
}

static void rows_free(Rows *rows)
{
    gp_free(rows->row);
    gp_free(rows->name);
    gp_free(rows->box);
}

static void rows_add(Rows *rows, const double row[4], uint32_t name)
{
    const uint32_t at = rows->count++;
    memcpy(rows->row[at], row, sizeof rows->row[at]);
    rows->name[at] = name;
    if (rows->count % BLOCK != 0)
        return;
    double(*box)[4] = rows->box[at / BLOCK];
    for (int k = 0; k < 4; k++)
        box[0][k] = box[1][k] = row[k];
    for (uint32_t i = at + 1 - BLOCK; i < at; i++)
        for (int k = 0; k < 4; k++) {
            box[0][k] = rows->row[i][k] < box[0][k] ? rows->row[i][k] : box[0][k];
            box[1][k] = rows->row[i][k] > box[1][k] ? rows->row[i][k] : box[1][k];
        }
}

static double product_of_rows(const double a[4], const double b[4])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/* The next row from `at` on whose product with another may be above a bound; count: none. */
static uint32_t next_above(const Rows *rows, uint32_t at, const double with[4], double bound)
{
    for (; at < rows->count; at++) {
        if (at % BLOCK == 0 && at + BLOCK <= rows->count) {
            const double(*box)[4] = (const double(*)[4])rows->box[at / BLOCK];
            double most = 0;
            for (int k = 0; k < 4; k++)
                most += fmax(box[0][k] * with[k], box[1][k] * with[k]);
            if (most < bound) {
                at += BLOCK - 1;
                continue;
            }
        }
        if (product_of_rows(rows->row[at], with) >= bound)
            return at;
    }
    return at;
}

/* --- geometry --------------------------------------------------------------------------------- */

/* in   at: a place in the index list */
static const float *vertex_of(const ConvexSet *set, uint32_t at)
{
    return set->mesh->positions[set->mesh->indices[at]];
}

static const float *corner_of(const ConvexSet *set, uint32_t face, uint32_t corner)
{
    const uint32_t turned = set->inward ? 2 - corner : corner;
    return vertex_of(set, 3 * face + turned);
}

static int exact_side(const ConvexSet *set, uint32_t face, const float point[3])
{
    return side_of_plane(corner_of(set, face, 0), corner_of(set, face, 1), corner_of(set, face, 2),
                         point);
}

/* The plane of a face, as a row; false: it has none. */
static bool plane_of(const ConvexSet *set, uint32_t face, double plane[4])
{
    double corner[3][3], side[2][3];
    for (uint32_t c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            corner[c][k] = (double)corner_of(set, face, c)[k];
    vector_subtract(corner[1], corner[0], side[0]);
    vector_subtract(corner[2], corner[0], side[1]);
    vector_cross(side[0], side[1], plane);
    const double area = sqrt(vector_dot(plane, plane));
    const double sides = sqrt(vector_dot(side[0], side[0]) * vector_dot(side[1], side[1]));
    if (!(area > 1e-12 * sides))
        return false;
    for (int k = 0; k < 3; k++)
        plane[k] /= area;
    plane[3] = vector_dot(plane, corner[0]);
    return true;
}

/* Whether two triangles in one plane, turning the same way, lie on each other: no edge of one has
 * the other beyond it. Sides of edges are those of planes through them and a point off the
 * plane. */
static bool lie_on_each_other(const ConvexSet *set, uint32_t a, uint32_t b, const double plane[4])
{
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (fabs(plane[k]) > fabs(plane[axis]))
            axis = k;
    for (int turn = 0; turn < 2; turn++) {
        const uint32_t one = turn ? b : a, other = turn ? a : b;
        for (uint32_t c = 0; c < 3; c++) {
            const float *from = corner_of(set, one, c), *to = corner_of(set, one, (c + 1) % 3);
            float off[3] = { from[0], from[1], from[2] };
            off[axis] += (float)(plane[axis] > 0 ? set->mesh->extent : -set->mesh->extent);
            bool beyond = true;
            for (uint32_t i = 0; i < 3 && beyond; i++)
                beyond = side_of_plane(from, to, off, corner_of(set, other, i)) >= 0;
            if (beyond)
                return false;
        }
    }
    return true;
}

/* --- the test --------------------------------------------------------------------------------- */

/* Whether a corner is behind all planes. */
static bool is_behind_planes(const ConvexSet *set, const float corner[3])
{
    const double row[4] = { (double)corner[0], (double)corner[1], (double)corner[2], -1 };
    const double tolerance = set->mesh->tolerance;
    const double bound = tolerance > 0 ? tolerance : -set->doubt;
    for (uint32_t i = next_above(&set->planes, 0, row, bound); i < set->planes.count;
         i = next_above(&set->planes, i + 1, row, bound))
        if (tolerance > 0 || product_of_rows(set->planes.row[i], row) > set->doubt ||
            exact_side(set, set->planes.name[i], corner) > 0)
            return false;
    return true;
}

static bool has_corners_behind(const ConvexSet *set, uint32_t face, const double plane[4])
{
    const double tolerance = set->mesh->tolerance;
    const double bound = tolerance > 0 ? tolerance : -set->doubt;
    for (uint32_t i = next_above(&set->corners, 0, plane, bound); i < set->corners.count;
         i = next_above(&set->corners, i + 1, plane, bound))
        if (tolerance > 0 || product_of_rows(set->corners.row[i], plane) > set->doubt ||
            exact_side(set, face, vertex_of(set, set->corners.name[i])) > 0)
            return false;
    return true;
}

/* Whether a face lies in the plane of another and over it, or with its back to it. */
static bool lies_on_a_member(const ConvexSet *set, uint32_t face, const double plane[4])
{
    double middle[4] = { 0, 0, 0, -1 };
    for (uint32_t c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            middle[k] += (double)corner_of(set, face, c)[k] / 3;
    for (uint32_t i = next_above(&set->planes, 0, middle, -set->doubt); i < set->planes.count;
         i = next_above(&set->planes, i + 1, middle, -set->doubt)) {
        const uint32_t member = set->planes.name[i];
        bool in_plane = true;
        for (uint32_t c = 0; c < 3 && in_plane; c++)
            in_plane = exact_side(set, member, corner_of(set, face, c)) == 0;
        if (in_plane && (vector_dot(plane, set->planes.row[i]) < 0 ||
                         lie_on_each_other(set, member, face, plane)))
            return true;
    }
    return false;
}

bool convex_set_add(ConvexSet *set, uint32_t face)
{
    const uint32_t *place = set->mesh->links->places;
    const uint32_t begin = 3 * face;
    double plane[4];
    if (!plane_of(set, face, plane))
        return false;
    for (uint32_t at = begin; at < begin + 3; at++)
        if (set->corner_mark[place[at]] != set->mark && !is_behind_planes(set, vertex_of(set, at)))
            return false;
    if (!has_corners_behind(set, face, plane) || lies_on_a_member(set, face, plane))
        return false;
    set->old_count[set->planes.count] = set->corners.count;
    rows_add(&set->planes, plane, face);
    for (uint32_t at = begin; at < begin + 3; at++)
        if (set->corner_mark[place[at]] != set->mark) {
            const float *p = vertex_of(set, at);
            const double row[4] = { (double)p[0], (double)p[1], (double)p[2], -1 };
            set->corner_mark[place[at]] = set->mark;
            rows_add(&set->corners, row, at);
        }
    return true;
}

/* --- life ------------------------------------------------------------------------------------- */

ConvexSet *convex_set_create(const ConvexMesh *mesh)
{
    ConvexSet *set = gp_alloc(1, sizeof *set);
    if (!set)
        return NULL;
    const uint32_t faces = mesh->links->face_count, places = mesh->links->place_count;
    set->mesh = mesh;
    set->doubt = 0x1p-44 * mesh->extent; /* far more than a plane's and a product's roundings */
    set->corner_mark = gp_alloc((size_t)places + 1, sizeof *set->corner_mark);
    set->old_count = gp_alloc((size_t)faces + 1, sizeof *set->old_count);
    if (!rows_alloc(&set->planes, faces) || !rows_alloc(&set->corners, places) ||
        !set->corner_mark || !set->old_count) {
        convex_set_destroy(set);
        return NULL;
    }
    return set;
}

void convex_set_destroy(ConvexSet *set)
{
    if (!set)
        return;
    rows_free(&set->planes);
    rows_free(&set->corners);
    gp_free(set->corner_mark);
    gp_free(set->old_count);
    gp_free(set);
}

void convex_set_begin(ConvexSet *set, bool inward)
{
    set->inward = inward;
    set->planes.count = set->corners.count = 0;
    set->mark++;
}

void convex_set_cut(ConvexSet *set, uint32_t count)
{
    if (count >= set->planes.count)
        return;
    const uint32_t corners = set->old_count[count];
    for (uint32_t i = corners; i < set->corners.count; i++)
        set->corner_mark[set->mesh->links->places[set->corners.name[i]]] = 0;
    set->corners.count = corners;
    set->planes.count = count;
}

uint32_t convex_set_count(const ConvexSet *set)
{
    return set->planes.count;
}

const uint32_t *convex_set_faces(const ConvexSet *set)
{
    return set->planes.name;
}
