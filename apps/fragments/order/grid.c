#include "apps/fragments/order/grid.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_CELLS = 16 /* a side */, PIXELS = 16 /* of a cell of the screen */ };

typedef enum Progress { WAITS, IS_VISITED, IS_DONE } Progress;

/* A piece in a cell. */
typedef struct Entry {
    uint32_t cell, piece;
    double distance;
} Entry;

/* A cell is in front of its neighbour on the other side than the eye, along each axis. */
typedef struct Grid {
    const OrderMesh *mesh;
    double low[3], size[3];   /* of cells */
    int32_t count[3], eye[3]; /* cells; the eye's, or the end that is nearest to it */
    Entry *entries;
    uint32_t entry_count, *first; /* [cells + 1] of each cell in entries */
    uint8_t *cell_progress, *piece_progress;
    uint32_t *sequence, drawn, circles; /* pieces in their order */
} Grid;

/* --- cells ------------------------------------------------------------------------------------ */

static int32_t cell_along(const Grid *grid, int axis, double at)
{
    const double cell = (at - grid->low[axis]) / grid->size[axis];
    return cell <= 0 ? 0 : cell >= grid->count[axis] ? grid->count[axis] - 1 : (int32_t)cell;
}

static void cells_of_piece(const Grid *grid, uint32_t piece, int32_t range[3][2])
{
    const PieceSpan *span = &grid->mesh->spans[piece];
    for (int k = 0; k < 3; k++) { /* the first axes of spans are x, y, z */
        range[k][0] = cell_along(grid, k, span->low[k]);
        range[k][1] = cell_along(grid, k, span->high[k]);
    }
}

static uint32_t cell_number(const Grid *grid, const int32_t at[3])
{
    return (uint32_t)((at[2] * grid->count[1] + at[1]) * grid->count[0] + at[0]);
}

static uint32_t cell_total(const Grid *grid)
{
    return (uint32_t)(grid->count[0] * grid->count[1] * grid->count[2]);
}

/* About as many cells as pieces. */
static void place_grid(Grid *grid, const Camera *camera)
{
    const uint32_t pieces = grid->mesh->pieces->count;
    double high[3] = { 0 }, volume = 1;
    for (int k = 0; k < 3; k++) {
        grid->low[k] = pieces ? grid->mesh->spans[0].low[k] : 0;
        high[k] = pieces ? grid->mesh->spans[0].high[k] : 0;
        for (uint32_t p = 1; p < pieces; p++) {
            grid->low[k] = fmin(grid->low[k], grid->mesh->spans[p].low[k]);
            high[k] = fmax(high[k], grid->mesh->spans[p].high[k]);
        }
        volume *= fmax(high[k] - grid->low[k], 1e-30);
    }
    const double side = cbrt(volume / (pieces + 1));
    const CameraAxes axes = camera_axes(camera, 1);
    for (int k = 0; k < 3; k++) {
        const double length = fmax(high[k] - grid->low[k], 1e-30);
        grid->count[k] = (int32_t)fmin(fmax(ceil(length / side), 1), MOST_CELLS);
        grid->size[k] = length / grid->count[k];
        grid->eye[k] = camera->fovy > 0      ? cell_along(grid, k, camera->eye[k])
                       : axes.forward[k] > 0 ? 0
                                             : grid->count[k] - 1;
    }
}

/* --- entries ---------------------------------------------------------------------------------- */

static int compare_entries(const void *a, const void *b)
{
    const Entry *p = a, *q = b;
    if (p->cell != q->cell)
        return p->cell < q->cell ? -1 : 1;
    if (p->distance != q->distance)
        return p->distance < q->distance ? -1 : 1;
    return (p->piece > q->piece) - (p->piece < q->piece);
}

static double distance_of(const Grid *grid, uint32_t piece, const Camera *camera)
{
    const PieceSpan *span = &grid->mesh->spans[piece];
    const CameraAxes axes = camera_axes(camera, 1);
    double from[3];
    for (int k = 0; k < 3; k++)
        from[k] = (span->low[k] + span->high[k]) / 2 - camera->eye[k];
    return camera->fovy > 0 ? vector_dot(from, from) : vector_dot(from, axes.forward);
}

/* Lists, or only counts, the pieces of all cells. */
static uint32_t list_entries(Grid *grid, const Camera *camera)
{
    uint32_t count = 0;
    for (uint32_t p = 0; p < grid->mesh->pieces->count; p++) {
        int32_t range[3][2], at[3];
        const double distance = distance_of(grid, p, camera);
        cells_of_piece(grid, p, range);
        for (at[2] = range[2][0]; at[2] <= range[2][1]; at[2]++)
            for (at[1] = range[1][0]; at[1] <= range[1][1]; at[1]++)
                for (at[0] = range[0][0]; at[0] <= range[0][1]; at[0]++, count++)
                    if (grid->entries)
                        grid->entries[count] = (Entry){ cell_number(grid, at), p, distance };
    }
    return count;
}

static bool fill_grid(Grid *grid, const Camera *camera)
{
    const uint32_t cells = cell_total(grid), pieces = grid->mesh->pieces->count;
    grid->entry_count = list_entries(grid, camera);
    grid->entries = gp_alloc(grid->entry_count, sizeof *grid->entries);
    grid->first = gp_alloc((size_t)cells + 1, sizeof *grid->first);
    grid->cell_progress = gp_alloc(cells, 1);
    grid->piece_progress = gp_alloc(pieces, 1);
    grid->sequence = gp_alloc(pieces, sizeof *grid->sequence);
    if (!grid->entries || !grid->first || !grid->cell_progress || !grid->piece_progress ||
        !grid->sequence)
        return false;
    list_entries(grid, camera);
    qsort(grid->entries, grid->entry_count, sizeof *grid->entries, compare_entries);
    for (uint32_t i = 0; i < grid->entry_count; i++)
        grid->first[grid->entries[i].cell + 1] = i + 1;
    for (uint32_t c = 0; c < cells; c++)
        if (grid->first[c + 1] < grid->first[c])
            grid->first[c + 1] = grid->first[c];
    return true;
}

static void free_grid(Grid *grid)
{
    gp_free(grid->entries);
    gp_free(grid->first);
    gp_free(grid->cell_progress);
    gp_free(grid->piece_progress);
    gp_free(grid->sequence);
}

/* --- visits ----------------------------------------------------------------------------------- */

static void visit_cell(Grid *grid, const int32_t at[3]);

/* The cell in front of a cell along an axis; false: it is the eye's there. */
static bool cell_before(const Grid *grid, const int32_t at[3], int axis, int32_t before[3])
{
    memcpy(before, at, 3 * sizeof *at);
    before[axis] += at[axis] > grid->eye[axis] ? -1 : 1;
    return at[axis] != grid->eye[axis];
}

static bool is_in_range(const int32_t at[3], int32_t range[3][2])
{
    for (int k = 0; k < 3; k++)
        if (at[k] < range[k][0] || at[k] > range[k][1])
            return false;
    return true;
}

/* Draws a piece after all cells in front of its own. */
static void visit_piece(Grid *grid, uint32_t piece)
{
    int32_t range[3][2], at[3], before[3];
    if (grid->piece_progress[piece] != WAITS) {
        grid->circles += grid->piece_progress[piece] == IS_VISITED;
        return;
    }
    grid->piece_progress[piece] = IS_VISITED;
    cells_of_piece(grid, piece, range);
    for (at[2] = range[2][0]; at[2] <= range[2][1]; at[2]++)
        for (at[1] = range[1][0]; at[1] <= range[1][1]; at[1]++)
            for (at[0] = range[0][0]; at[0] <= range[0][1]; at[0]++)
                for (int k = 0; k < 3; k++)
                    if (cell_before(grid, at, k, before) && !is_in_range(before, range))
                        visit_cell(grid, before);
    grid->piece_progress[piece] = IS_DONE;
    grid->sequence[grid->drawn++] = piece;
}

static void visit_cell(Grid *grid, const int32_t at[3])
{
    const uint32_t cell = cell_number(grid, at);
    int32_t before[3];
    if (grid->cell_progress[cell] != WAITS)
        return;
    grid->cell_progress[cell] = IS_VISITED;
    for (int k = 0; k < 3; k++)
        if (cell_before(grid, at, k, before))
            visit_cell(grid, before);
    for (uint32_t i = grid->first[cell]; i < grid->first[cell + 1]; i++)
        visit_piece(grid, grid->entries[i].piece);
    grid->cell_progress[cell] = IS_DONE;
}

static void visit_all(Grid *grid)
{
    int32_t at[3];
    for (at[2] = 0; at[2] < grid->count[2]; at[2]++)
        for (at[1] = 0; at[1] < grid->count[1]; at[1]++)
            for (at[0] = 0; at[0] < grid->count[0]; at[0]++)
                visit_cell(grid, at);
}

/* --- levels ----------------------------------------------------------------------------------- */

/* Pieces in their sequence, each in the first level behind all before it that share a cell of the screen
 * with it. */
typedef struct Levels {
    const Screen *screen;
    uint32_t across, down;
    uint32_t *used;  /* [down][across] levels */
    uint32_t *level; /* [pieces] */
    uint32_t count;
} Levels;

static int32_t between(int32_t value, uint32_t count)
{
    return value < 0 ? 0 : value >= (int32_t)count ? (int32_t)count - 1 : value;
}

/* The most levels that are used under a face; where `level` is not 0, they become it. */
static uint32_t used_under(Levels *levels, uint32_t face, uint32_t level)
{
    const ScreenBox *box = &levels->screen->faces[face].box;
    const int32_t side = PIXELS * 256;
    uint32_t most = 0;
    for (int32_t y = between(box->y0 / side, levels->down);
         y <= between(box->y1 / side, levels->down); y++)
        for (int32_t x = between(box->x0 / side, levels->across);
             x <= between(box->x1 / side, levels->across); x++) {
            uint32_t *used = &levels->used[(size_t)y * levels->across + (uint32_t)x];
            most = *used > most ? *used : most;
            *used = level ? level : *used;
        }
    return most;
}

static void find_level(Levels *levels, const Pieces *pieces, uint32_t piece)
{
    uint32_t level = 0;
    for (int round = 0; round < 2; round++)
        for (uint32_t i = pieces->first[piece]; i < pieces->first[piece + 1]; i++) {
            const uint32_t face = pieces->faces[i];
            if (levels->screen->faces[face].count == 0)
                continue;
            const uint32_t most = used_under(levels, face, round ? level : 0) + 1;
            level = round == 0 && most > level ? most : level;
        }
    levels->level[piece] = level;
    levels->count = level > levels->count ? level : levels->count;
}

/* Faces by the levels of their pieces, in the order of pieces. */
static GpResult list_faces(const Levels *levels, const Pieces *pieces, Order *order)
{
    order->level_count = levels->count;
    order->first = gp_alloc((size_t)levels->count + 2, sizeof *order->first);
    order->knot_first = gp_alloc((size_t)levels->count + 2, sizeof *order->knot_first);
    order->knot_most = gp_alloc((size_t)levels->count + 1, sizeof *order->knot_most);
    order->faces = gp_alloc(pieces->face_count, sizeof *order->faces);
    if (!order->first || !order->knot_first || !order->knot_most || !order->faces)
        return GP_ERROR_MEMORY;
    for (int round = 0; round < 2; round++) {
        for (uint32_t i = 0; i < pieces->face_count; i++) {
            const uint32_t face = pieces->faces[i], level = levels->level[pieces->piece_of[face]];
            if (levels->screen->faces[face].count == 0)
                continue;
            if (round == 0)
                order->first[level + 1]++;
            else
                order->faces[order->first[level]++] = face;
        }
        for (uint32_t n = 0; n <= levels->count && round == 0; n++)
            order->first[n + 1] += order->first[n];
    }
    return GP_OK;
}

static GpResult make_levels(const Grid *grid, const FragmentView *view, const Screen *screen,
                            Order *order)
{
    const Pieces *pieces = grid->mesh->pieces;
    Levels levels = { .screen = screen,
                      .across = (view->width + PIXELS - 1) / PIXELS,
                      .down = (view->height + PIXELS - 1) / PIXELS };
    levels.used = gp_alloc((size_t)levels.across * levels.down, sizeof *levels.used);
    levels.level = gp_alloc(pieces->count, sizeof *levels.level);
    GpResult result = levels.used && levels.level ? GP_OK : GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < grid->drawn && !result; i++)
        find_level(&levels, pieces, grid->sequence[i]);
    if (!result)
        result = list_faces(&levels, pieces, order);
    gp_free(levels.used);
    gp_free(levels.level);
    return result;
}

GpResult order_by_grid(const OrderMesh *mesh, const FragmentView *view, const Screen *screen,
                       Order *order, GpError *error)
{
    Grid grid = { .mesh = mesh };
    Order made = { .level_count = 0 };
    place_grid(&grid, &view->camera);
    GpResult result = fill_grid(&grid, &view->camera) ? GP_OK : GP_ERROR_MEMORY;
    if (!result) {
        visit_all(&grid);
        made.split_sides = grid.circles;
        result = make_levels(&grid, view, screen, &made);
    }
    free_grid(&grid);
    if (result) {
        order_free(&made);
        return gp_fail(error, result, "out of memory");
    }
    *order = made;
    return GP_OK;
}
