#include "apps/depth_images/drawing/merge.h"

#include "apps/base/bounds.h"
#include "apps/base/vector.h"

#include <math.h>
#include <string.h>

enum {
    SIDE = MERGE_SIDE,
    PATCH_POINTS = (SIDE + 1) * (SIDE + 1),
    PATCH_INDICES = SIDE * SIDE * 6,
};

/* Errors of the points that halve triangles, over squares that cover the grid and may reach
 *      beyond. */
typedef struct Merging {
    const MergeGrid *grid;
    double tolerance;
    uint32_t squares[2], size[2]; /* across and down; points: squares * SIDE + 1 */
    float *errors;                /* [size[1]][size[0]] */
    MergedMesh mesh;
    uint32_t vertex_room, index_room;
    /* of the patch's points, 1 + that of the vertex; 0: it is none yet */
    uint32_t number[PATCH_POINTS];
    uint32_t square[2];
} Merging;

/* --- how far triangles are from their points -------------------------------------------------- */

static bool is_inside(const Merging *merging, int64_t x, int64_t y)
{
    return x >= 0 && y >= 0 && x < merging->size[0] && y < merging->size[1];
}

static bool is_there(const MergeGrid *grid, int64_t x, int64_t y)
{
    return x < grid->columns && y < grid->rows &&
           isfinite(grid->position[y * grid->columns + x][0]);
}

static const float *point_at(const MergeGrid *grid, int64_t x, int64_t y)
{
    static const float none[3] = { INFINITY, 0, 0 };
    return is_there(grid, x, y) ? grid->position[y * grid->columns + x] : none;
}

/* in   x, y: a point that is there */
static bool is_cut(const MergeGrid *grid, int64_t x, int64_t y, int side)
{
    return grid->cut && (grid->cut[y * grid->columns + x] & side);
}

/* Whether a cell must stay as it is. */
static bool is_broken(const MergeGrid *grid, int64_t x, int64_t y)
{
    for (int i = 0; i < 4; i++)
        if (!is_there(grid, x + (i & 1), y + (i >> 1)))
            return true;
    return is_cut(grid, x, y, MERGE_CUT_RIGHT) || is_cut(grid, x, y, MERGE_CUT_DOWN) ||
           is_cut(grid, x + 1, y, MERGE_CUT_DOWN) || is_cut(grid, x, y + 1, MERGE_CUT_RIGHT);
}

static float error_at(const Merging *merging, int64_t x, int64_t y)
{
    return is_inside(merging, x, y) ? merging->errors[y * merging->size[0] + x] : 0;
}

/* From a point to the middle between two others about it: along its normal, or aside as far as
 * counts. */
static float bend(const Merging *merging, int64_t x, int64_t y, int64_t dx, int64_t dy)
{
    const MergeGrid *grid = merging->grid;
    const float *middle = point_at(grid, x, y);
    const float *a = point_at(grid, x - dx, y - dy), *b = point_at(grid, x + dx, y + dy);
    double off[3], out = 0;
    for (int k = 0; k < 3; k++)
        off[k] = (double)middle[k] - 0.5 * ((double)a[k] + (double)b[k]);
    const double length = sqrt(vector_dot(off, off));
    if (!isfinite(length))
        return INFINITY;
    for (int k = 0; k < 3 && grid->normal; k++)
        out += off[k] * (double)grid->normal[y * grid->columns + x][k];
    return (float)(grid->normal ? fmax(fabs(out), length / MERGE_ASIDE) : length);
}

/* A bound for all points of the triangles that a point halves: what it is off itself, and what
 * those are that halve their halves, on its four sides; NULL: those are not halved. */
static void set_error(Merging *merging, int64_t x, int64_t y, float own, const int64_t below[4][2])
{
    float most = 0;
    for (int i = 0; i < 4 && below; i++) {
        const float error = error_at(merging, x + below[i][0], y + below[i][1]);
        most = error > most ? error : most;
    }
    merging->errors[y * merging->size[0] + x] = own + most;
}

/* Middles of the sides, s long, of squares: across (dx = s / 2) or down. */
static void find_side_errors(Merging *merging, int64_t s, bool across)
{
    const int64_t h = s / 2, q = s / 4, dx = across ? h : 0, dy = across ? 0 : h;
    const int64_t below[4][2] = { { q, q }, { -q, q }, { q, -q }, { -q, -q } };
    for (int64_t y = dy; y < merging->size[1]; y += s)
        for (int64_t x = dx; x < merging->size[0]; x += s) {
            float own = bend(merging, x, y, dx, dy);
            for (int i = 0; i < 4 && s == 2; i++) {
                const int64_t cx = x - (i & 1), cy = y - (i >> 1);
                if (cx >= 0 && cy >= 0 && cx + 1 < merging->size[0] && cy + 1 < merging->size[1] &&
                    is_broken(merging->grid, cx, cy))
                    own = INFINITY;
            }
            set_error(merging, x, y, own, s == 2 ? NULL : below);
        }
}

/* The diagonal of a square of side s runs through the middle of the square twice as large. */
static bool falls(int64_t column, int64_t row, int64_t s)
{
    return s == SIDE || ((column ^ row) & 1) == 0;
}

static void find_middle_errors(Merging *merging, int64_t s)
{
    const int64_t h = s / 2;
    const int64_t below[4][2] = { { h, 0 }, { -h, 0 }, { 0, h }, { 0, -h } };
    for (int64_t y = h; y < merging->size[1]; y += s)
        for (int64_t x = h; x < merging->size[0]; x += s) {
            const float own = bend(merging, x, y, h, falls(x / s, y / s, s) ? h : -h);
            set_error(merging, x, y, own, below);
        }
}

/* Points of the first column and of the last are the same ones. */
static void join_ends(Merging *merging)
{
    const uint32_t last = merging->grid->columns - 1;
    const bool whole = last % SIDE == 0;
    for (uint32_t y = 0; merging->grid->wraps && y < merging->size[1]; y++) {
        float *a = &merging->errors[(size_t)y * merging->size[0]], *b = a + last;
        *a = *b = whole ? (*a > *b ? *a : *b) : INFINITY;
    }
}

static void find_errors(Merging *merging)
{
    for (int64_t s = 2; s <= SIDE; s *= 2) {
        join_ends(merging);
        find_side_errors(merging, s, true);
        find_side_errors(merging, s, false);
        join_ends(merging);
        find_middle_errors(merging, s);
    }
}

/* --- triangles -------------------------------------------------------------------------------- */

static uint32_t vertex_of(Merging *merging, const int64_t point[2])
{
    const int64_t x = point[0] - merging->square[0] * SIDE,
                  y = point[1] - merging->square[1] * SIDE;
    uint32_t *number = &merging->number[y * (SIDE + 1) + x];
    if (!*number) {
        merging->mesh.points[merging->mesh.vertex_count++] =
            (uint32_t)(point[1] * merging->grid->columns + point[0]);
        *number = merging->mesh.vertex_count;
    }
    return *number - 1;
}

/* Whether half a cell may be drawn: its right angle is at c. */
static bool is_whole(const MergeGrid *grid, const int64_t a[2], const int64_t b[2],
                     const int64_t c[2])
{
    const int64_t *const corners[3] = { a, b, c };
    for (int i = 0; i < 3; i++)
        if (!is_there(grid, corners[i][0], corners[i][1]))
            return false;
    const int64_t x = a[0] < b[0] ? a[0] : b[0], y = a[1] < b[1] ? a[1] : b[1];
    if (grid->whole_cells && is_broken(grid, x, y))
        return false;
    return !is_cut(grid, x, c[1], MERGE_CUT_RIGHT) && !is_cut(grid, c[0], y, MERGE_CUT_DOWN);
}

/* Whether some point of a triangle's box is needed. */
static bool is_needed(const MergeGrid *grid, const int64_t *const corners[3])
{
    if (!grid->needed)
        return true;
    const uint32_t *sums = grid->needed;
    int64_t low[2], high[2];
    for (int k = 0; k < 2; k++) {
        const int64_t a = corners[0][k], b = corners[1][k], c = corners[2][k];
        const int64_t last = (k ? grid->rows : grid->columns) - 1;
        low[k] = a < b ? (a < c ? a : c) : b < c ? b : c;
        high[k] = a > b ? (a > c ? a : c) : b > c ? b : c;
        high[k] = (high[k] < last ? high[k] : last) + 1;
    }
    const int64_t stride = grid->columns + 1;
    return sums[high[1] * stride + high[0]] - sums[low[1] * stride + high[0]] -
           sums[high[1] * stride + low[0]] + sums[low[1] * stride + low[0]];
}

/* A triangle with its right angle at c; seen from outside, a, b, c turn counter-clockwise. */
static void add_triangle(Merging *merging, const int64_t a[2], const int64_t b[2],
                         const int64_t c[2])
{
    const int64_t m[2] = { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2 };
    const bool is_last = (a[0] + b[0]) & 1;
    if (!is_last && !((double)error_at(merging, m[0], m[1]) <= merging->tolerance)) {
        add_triangle(merging, c, a, m);
        add_triangle(merging, b, c, m);
        return;
    }
    if (is_last && !is_whole(merging->grid, a, b, c))
        return;
    const int64_t *const corners[3] = { a, b, c };
    for (int i = 0; i < 3 && is_needed(merging->grid, corners); i++)
        merging->mesh.indices[merging->mesh.index_count++] = vertex_of(merging, corners[i]);
}

/* --- patches ---------------------------------------------------------------------------------- */

/* Room for one patch more. */
static bool make_room(void **array, uint32_t *room, uint32_t count, uint32_t more)
{
    if (count + more <= *room)
        return true;
    const uint32_t wanted = 2 * count + more;
    void *larger = gp_alloc_unset((size_t)wanted * sizeof(uint32_t));
    if (!larger)
        return false;
    if (count)
        memcpy(larger, *array, count * sizeof(uint32_t));
    gp_free(*array);
    *array = larger;
    *room = wanted;
    return true;
}

/* What a patch is made of, as merged_patch_bound has it. */
typedef struct Bounded {
    const float (*position)[3];
    const uint32_t *points, *indices;
} Bounded;

static const float *vertex_position(const Bounded *bounded, uint32_t vertex)
{
    return bounded->position[bounded->points ? bounded->points[vertex] : vertex];
}

static void find_ball(const Bounded *bounded, MergedPatch *patch)
{
    const uint32_t *indices = bounded->indices + patch->first_index;
    Bounds box = bounds_of_nothing;
    double square = 0;
    for (uint32_t i = 0; i < patch->index_count; i++) {
        const float *p = vertex_position(bounded, indices[i]);
        bounds_add(&box, (double[3]){ (double)p[0], (double)p[1], (double)p[2] });
    }
    for (int k = 0; k < 3; k++)
        patch->center[k] = (box.low[k] + box.high[k]) / 2;
    for (uint32_t i = 0; i < patch->index_count; i++) {
        const float *p = vertex_position(bounded, indices[i]);
        double away[3] = { (double)p[0], (double)p[1], (double)p[2] };
        vector_subtract(away, patch->center, away);
        square = fmax(square, vector_dot(away, away));
    }
    patch->radius = sqrt(square);
}

static void normal_of(const Bounded *bounded, const uint32_t *corners, double normal[3])
{
    const float *a = vertex_position(bounded, corners[0]),
                *b = vertex_position(bounded, corners[1]),
                *c = vertex_position(bounded, corners[2]);
    double side[2][3];
    for (int k = 0; k < 3; k++) {
        side[0][k] = (double)b[k] - (double)a[k];
        side[1][k] = (double)c[k] - (double)a[k];
    }
    vector_cross(side[0], side[1], normal);
    vector_normalize(normal);
}

static void find_cone(const Bounded *bounded, MergedPatch *patch)
{
    const uint32_t *indices = bounded->indices + patch->first_index;
    double normal[3], least = 1;
    for (uint32_t i = 0; i < patch->index_count; i += 3) {
        normal_of(bounded, indices + i, normal);
        vector_add_scaled(patch->axis, 1, normal, patch->axis);
    }
    vector_normalize(patch->axis);
    for (uint32_t i = 0; i < patch->index_count; i += 3) {
        normal_of(bounded, indices + i, normal);
        if (vector_dot(normal, normal) > 0)
            least = fmin(least, vector_dot(normal, patch->axis));
    }
    patch->sine = least > 0 ? sqrt(fmax(0, 1 - least * least)) : 1;
}

void merged_patch_bound(const float (*position)[3], const uint32_t *points, const uint32_t *indices,
                        MergedPatch *patch)
{
    const Bounded bounded = { position, points, indices };
    find_ball(&bounded, patch);
    find_cone(&bounded, patch);
}

static GpResult add_patch(Merging *merging, uint32_t column, uint32_t row)
{
    MergedMesh *mesh = &merging->mesh;
    const int64_t x = column * SIDE, y = row * SIDE;
    const int64_t corners[4][2] = {
        { x, y }, { x + SIDE, y }, { x, y + SIDE }, { x + SIDE, y + SIDE }
    };
    if (!make_room((void **)&mesh->points, &merging->vertex_room, mesh->vertex_count,
                   PATCH_POINTS) ||
        !make_room((void **)&mesh->indices, &merging->index_room, mesh->index_count, PATCH_INDICES))
        return GP_ERROR_MEMORY;
    MergedPatch patch = { .first_vertex = mesh->vertex_count, .first_index = mesh->index_count };
    memset(merging->number, 0, sizeof merging->number);
    merging->square[0] = column;
    merging->square[1] = row;
    add_triangle(merging, corners[3], corners[0], corners[2]);
    add_triangle(merging, corners[0], corners[3], corners[1]);
    patch.vertex_count = mesh->vertex_count - patch.first_vertex;
    patch.index_count = mesh->index_count - patch.first_index;
    if (!patch.index_count)
        return GP_OK;
    merged_patch_bound(merging->grid->position, mesh->points, mesh->indices, &patch);
    mesh->patches[mesh->patch_count++] = patch;
    return GP_OK;
}

GpResult merge_grid(const MergeGrid *grid, double tolerance, MergedMesh *mesh, GpError *error)
{
    Merging *merging = gp_alloc(1, sizeof *merging);
    GpResult result = GP_OK;
    if (!merging)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    merging->grid = grid;
    merging->tolerance = tolerance;
    const uint32_t points[2] = { grid->columns, grid->rows };
    for (int i = 0; i < 2; i++) {
        merging->squares[i] = (points[i] + SIDE - 2) / SIDE; /* of points - 1 cells */
        merging->size[i] = merging->squares[i] * SIDE + 1;
    }
    const size_t squares = (size_t)merging->squares[0] * merging->squares[1];
    merging->errors = gp_alloc((size_t)merging->size[0] * merging->size[1], sizeof(float));
    merging->mesh.patches = gp_alloc(squares, sizeof *merging->mesh.patches);
    if (!merging->errors || !merging->mesh.patches)
        result = GP_ERROR_MEMORY;
    else
        find_errors(merging);
    for (uint32_t i = 0; i < squares && !result; i++)
        result = add_patch(merging, i % merging->squares[0], i / merging->squares[0]);
    gp_free(merging->errors);
    if (result)
        merged_free(&merging->mesh);
    else
        *mesh = merging->mesh;
    gp_free(merging);
    return result ? gp_fail(error, result, "out of memory") : GP_OK;
}

void merged_free(MergedMesh *mesh)
{
    gp_free(mesh->points);
    gp_free(mesh->indices);
    gp_free(mesh->patches);
    *mesh = (MergedMesh){ 0 };
}

/* A triangle of normal n turns away where n . way >= radius, from the eye to the ball's middle; and
 * n . way is least where n leans by the whole cone's angle: for way . axis >= sine length + radius
 * it is enough. */
bool merged_may_face(const MergedPatch *patch, const double eye[3], bool parallel)
{
    double way[3];
    for (int k = 0; k < 3; k++)
        way[k] = parallel ? -eye[k] : patch->center[k] - eye[k];
    const double length = sqrt(vector_dot(way, way));
    return patch->sine >= 1 ||
           vector_dot(way, patch->axis) < patch->sine * length + (parallel ? 0 : patch->radius);
}
