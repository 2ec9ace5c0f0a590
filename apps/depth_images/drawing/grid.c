#include "apps/depth_images/drawing/grid.h"

#include "apps/depth_images/drawing/merge.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

enum { SIDES = 4 };

typedef struct Builder {
    const GridSetting *setting;
    DepthLattice lattice;
    double reach;
    uint32_t *vertex_of; /* of the lattice's vertices, and 1; 0: none yet */
    WarpGrid grid;
    uint32_t vertex_room, index_room;
    bool failed;
} Builder;

/* --- arrays that grow ------------------------------------------------------------------------- */

static void *room_for(Builder *b, void *array, uint32_t count, uint32_t *room, size_t size)
{
    if (count <= *room)
        return array;
    const uint32_t larger = 2 * count + 1024;
    void *moved = realloc(array, larger * size);
    b->failed = b->failed || !moved;
    *room = moved ? larger : *room;
    return moved ? moved : array;
}

static uint32_t add_vertex(Builder *b, GridVertex vertex)
{
    WarpGrid *g = &b->grid;
    g->vertices =
        room_for(b, g->vertices, g->vertex_count + 1, &b->vertex_room, sizeof *g->vertices);
    if (b->failed)
        return 0;
    g->vertices[g->vertex_count] = vertex;
    return g->vertex_count++;
}

/* Counter-clockwise in the picture; the other way where the image sees backs, if that is asked for.
 * in  place: of a vertex that tells */
static void add_triangle(Builder *b, const int32_t place[2], uint32_t i, uint32_t j, uint32_t k)
{
    WarpGrid *g = &b->grid;
    const bool turned = b->setting->turned &&
                        b->lattice.away[(size_t)place[1] * b->lattice.width + (size_t)place[0]];
    const uint32_t corner[3] = { i, turned ? k : j, turned ? j : k };
    g->indices = room_for(b, g->indices, g->index_count + 3, &b->index_room, sizeof *g->indices);
    if (b->failed)
        return;
    memcpy(g->indices + g->index_count, corner, sizeof corner);
    g->index_count += 3;
}

/* --- vertices --------------------------------------------------------------------------------- */

/* in  at: of the lattice; color: the same, where its colour is */
static uint32_t vertex_at(Builder *b, const double at[2], double flat, const double color[2])
{
    const double most = (double)FLT_MAX, depth = depth_flat(b->lattice.is_parallel, flat);
    return add_vertex(
        b, (GridVertex){
               (float)depth_lattice_place(&b->lattice, 0, at[0]),
               (float)depth_lattice_place(&b->lattice, 1, at[1]),
               (float)fmin(fmax(depth, -most), most),
               (float)(depth_lattice_place(&b->lattice, 0, color[0]) / b->lattice.image[0]),
               (float)(depth_lattice_place(&b->lattice, 1, color[1]) / b->lattice.image[1]) });
}

static double flat_at(const DepthLattice *lattice, const int32_t place[2])
{
    return (double)lattice->flat[(size_t)place[1] * lattice->width + (size_t)place[0]];
}

static uint32_t lattice_vertex(Builder *b, const int32_t place[2])
{
    uint32_t *known = &b->vertex_of[(size_t)place[1] * b->lattice.width + (size_t)place[0]];
    const double at[2] = { place[0], place[1] };
    if (!*known)
        *known = vertex_at(b, at, flat_at(&b->lattice, place), at) + 1;
    return *known - 1;
}

/* --- whole cells ------------------------------------------------------------------------------ */

/* Places in pixels of the picture, and depths so that a unit of them is seen as a pixel, from an
 * eye as far aside as the nearest point is away: where nothing is farther off than the tolerance,
 * so are pixels. */
static GpResult make_points(const Builder *b, float (**points)[3], uint8_t **cuts)
{
    const DepthLattice *lattice = &b->lattice;
    const size_t count = (size_t)lattice->width * lattice->height;
    double nearest = 0;
    *points = gp_alloc(count, sizeof **points);
    *cuts = gp_alloc(count, 1);
    if (!*points || !*cuts)
        return GP_ERROR_MEMORY;
    for (size_t i = 0; i < count; i++)
        nearest = fmax(nearest, (double)lattice->flat[i]);
    const double unit = lattice->is_parallel ? lattice->texel : lattice->texel * nearest;
    for (size_t i = 0; i < count; i++) {
        const double at[2] = { (double)(i % lattice->width), (double)(i / lattice->width) };
        const float flat = lattice->flat[i];
        for (int axis = 0; axis < 2; axis++)
            (*points)[i][axis] =
                isnan(flat) ? INFINITY : (float)depth_lattice_place(&b->lattice, axis, at[axis]);
        (*points)[i][2] = (float)((double)flat / unit);
        (*cuts)[i] = (lattice->neighbour[i] & EDGE_RIGHT ? 0 : MERGE_CUT_RIGHT) |
                     (lattice->neighbour[i] & EDGE_DOWN ? 0 : MERGE_CUT_DOWN);
    }
    return GP_OK;
}

static void add_merged(Builder *b, const MergedMesh *mesh)
{
    for (uint32_t i = 0; i < mesh->index_count && !b->failed; i += 3) {
        uint32_t corner[3];
        int32_t place[2];
        for (int k = 0; k < 3; k++) {
            const uint32_t point = mesh->points[mesh->indices[i + (uint32_t)k]];
            place[0] = (int32_t)(point % b->lattice.width);
            place[1] = (int32_t)(point / b->lattice.width);
            corner[k] = lattice_vertex(b, place);
        }
        add_triangle(b, place, corner[0], corner[1], corner[2]);
    }
}

static GpResult add_whole_cells(Builder *b)
{
    const double tolerance = b->setting->tolerance;
    float(*points)[3] = NULL;
    uint8_t *cuts = NULL;
    MergedMesh mesh = { .points = NULL };
    GpResult result = make_points(b, &points, &cuts);
    if (!result)
        result = merge_grid(&(MergeGrid){ .columns = b->lattice.width,
                                          .rows = b->lattice.height,
                                          .position = (const float(*)[3])points,
                                          .cut = cuts,
                                          .whole_cells = true },
                            tolerance != 0 ? tolerance : GRID_TOLERANCE, &mesh, NULL);
    if (!result)
        add_merged(b, &mesh);
    merged_free(&mesh);
    gp_free(points);
    gp_free(cuts);
    return result;
}

/* --- cells in which a surface ends ------------------------------------------------------------ */

/* Clockwise from the upper left. */
static const int32_t corner_x[SIDES] = { 0, 1, 1, 0 }, corner_y[SIDES] = { 0, 0, 1, 1 };

typedef struct Cell {
    int32_t x, y;
    bool is_there[SIDES];
    bool joined[SIDES]; /* corner i with the next one */
} Cell;

static bool has_bit(const DepthLattice *lattice, int32_t x, int32_t y, EdgeNeighbour bit)
{
    return x >= 0 && y >= 0 && x < (int32_t)lattice->width && y < (int32_t)lattice->height &&
           (lattice->neighbour[(size_t)y * lattice->width + (size_t)x] & bit);
}

static Cell cell_at(const Builder *b, int32_t x, int32_t y)
{
    Cell cell = { x, y, { false }, { false } };
    for (int i = 0; i < SIDES; i++) {
        const int32_t place[2] = { x + corner_x[i], y + corner_y[i] };
        cell.is_there[i] = place[0] >= 0 && place[1] >= 0 && place[0] < (int32_t)b->lattice.width &&
                           place[1] < (int32_t)b->lattice.height &&
                           !isnan(flat_at(&b->lattice, place));
    }
    cell.joined[0] = has_bit(&b->lattice, x, y, EDGE_RIGHT);
    cell.joined[1] = has_bit(&b->lattice, x + 1, y, EDGE_DOWN);
    cell.joined[2] = has_bit(&b->lattice, x, y + 1, EDGE_RIGHT);
    cell.joined[3] = has_bit(&b->lattice, x, y, EDGE_DOWN);
    return cell;
}

/* By how much a surface's flat depth goes on in half a step, from what is on its other side. */
static double half_slope(const Builder *b, const int32_t place[2], int axis, int32_t way)
{
    const DepthLattice *lattice = &b->lattice;
    const GridEnds *ends = &b->setting->ends;
    int32_t behind[2] = { place[0], place[1] };
    behind[axis] -= way;
    const int32_t *first = way > 0 ? behind : place;
    if (!has_bit(lattice, first[0], first[1], axis ? EDGE_DOWN : EDGE_RIGHT))
        return 0;
    const double here = flat_at(lattice, place), lean = ends->lean > 0 ? ends->lean : 1;
    double half = lean * (here - flat_at(lattice, behind)) / 2;
    const double texels = depth_lattice_texels(lattice, here, half);
    if (ends->most > 0 && texels > ends->most)
        half *= ends->most / texels;
    return lattice->is_parallel ? half : fmax(half, -here / 2); /* no farther than twice */
}

/* A corner of a cell, and what its surface is half a step from it, on either axis, towards the
 * middle. */
typedef struct Corner {
    int32_t place[2], way[2];
    double flat, slope[2];
} Corner;

static Corner corner_of(const Builder *b, const Cell *cell, int i)
{
    Corner corner = { .place = { cell->x + corner_x[i], cell->y + corner_y[i] },
                      .way = { 1 - 2 * corner_x[i], 1 - 2 * corner_y[i] } };
    corner.flat = flat_at(&b->lattice, corner.place);
    for (int axis = 0; axis < 2; axis++)
        corner.slope[axis] = half_slope(b, corner.place, axis, corner.way[axis]);
    return corner;
}

/* Out from a corner, towards the one before it or after it. */
static uint32_t end_vertex(Builder *b, const Corner *corner, int axis)
{
    double at[2] = { corner->place[0], corner->place[1] };
    const double color[2] = { at[0], at[1] };
    at[axis] += b->reach * corner->way[axis];
    return vertex_at(b, at, corner->flat + 2 * b->reach * corner->slope[axis], color);
}

/* The middle of a cell all corners of which are one surface, but for one side. */
static uint32_t middle_vertex(Builder *b, const Corner corner[SIDES])
{
    const int32_t *left = corner[1].place, *right = corner[2].place;
    const double color[2] = { (left[0] + right[0]) / 2.0, (left[1] + right[1]) / 2.0 };
    const double at[2] = { (corner[0].place[0] + corner[2].place[0]) / 2.0,
                           (corner[0].place[1] + corner[2].place[1]) / 2.0 };
    return vertex_at(b, at, (corner[1].flat + corner[2].flat) / 2, color);
}

/* Corners first..first + count - 1 are one surface, which ends before and after them. Colours are
 * those between the corners, so that no other surface's are mixed in.
 * source Lorensen, Cline, "Marching cubes", SIGGRAPH 1987, of squares, cut in their sides'
 *      middles */
static void add_end(Builder *b, const Cell *cell, int first, int count)
{
    Corner corner[SIDES];
    uint32_t v[SIDES];
    for (int i = 0; i < count; i++) {
        corner[i] = corner_of(b, cell, (first + i) % SIDES);
        v[i] = lattice_vertex(b, corner[i].place);
    }
    const int32_t *place = corner[0].place;
    const uint32_t begin = end_vertex(b, &corner[0], first % 2 ? 0 : 1);
    const uint32_t end = end_vertex(b, &corner[count - 1], (first + count - 1) % 2 ? 1 : 0);
    if (count == 1) {
        add_triangle(b, place, begin, end, v[0]);
    } else if (count < SIDES) {
        add_triangle(b, place, begin, v[1], v[0]);
        add_triangle(b, place, begin, end, v[1]);
        if (count == 3)
            add_triangle(b, place, v[1], end, v[2]);
    } else {
        const uint32_t middle = middle_vertex(b, corner);
        add_triangle(b, place, begin, middle, v[0]);
        for (int i = 0; i + 1 < SIDES; i++)
            add_triangle(b, place, v[i], middle, v[i + 1]);
        add_triangle(b, place, v[SIDES - 1], middle, end);
    }
}

static void add_ends(Builder *b, int32_t x, int32_t y)
{
    const Cell cell = cell_at(b, x, y);
    for (int i = 0; i < SIDES && !depth_lattice_is_whole(&b->lattice, x, y); i++) {
        int count = 1;
        if (!cell.is_there[i] || cell.joined[(i + SIDES - 1) % SIDES])
            continue; /* no surface begins here */
        while (count < SIDES && cell.joined[(i + count - 1) % SIDES])
            count++;
        add_end(b, &cell, i, count);
    }
}

/* --- all -------------------------------------------------------------------------------------- */

static GpResult build(Builder *b)
{
    b->vertex_of = gp_alloc((size_t)b->lattice.width * b->lattice.height, sizeof *b->vertex_of);
    const GpResult result = b->vertex_of ? add_whole_cells(b) : GP_ERROR_MEMORY;
    for (int32_t y = -1; y < (int32_t)b->lattice.height && !result; y++)
        for (int32_t x = -1; x < (int32_t)b->lattice.width && !b->failed; x++)
            add_ends(b, x, y);
    return b->failed ? GP_ERROR_MEMORY : result;
}

GpResult warp_grid_make(const DepthLattice *pixels, const GridSetting *setting, WarpGrid *grid)
{
    Builder b = { .setting = setting,
                  .lattice = *pixels,
                  .reach = setting->reach > 0 ? fmin(setting->reach, 0.5) : 0.5 };
    const bool is_thin = setting->step > 1;
    GpResult result = is_thin ? depth_lattice_thin(pixels, setting->step, &b.lattice) : GP_OK;
    if (!result)
        result = build(&b);
    if (is_thin)
        depth_lattice_free(&b.lattice);
    gp_free(b.vertex_of);
    if (result)
        warp_grid_free(&b.grid);
    else
        *grid = b.grid;
    return result;
}

void warp_grid_free(WarpGrid *grid)
{
    free(grid->vertices);
    free(grid->indices);
    *grid = (WarpGrid){ .vertices = NULL };
}
