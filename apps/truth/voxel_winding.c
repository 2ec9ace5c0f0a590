#include "apps/truth/voxel_winding.h"

#include "apps/truth/triangle.h"

#include <stdlib.h>

/* Where lines are, beside the centres of voxels. */
static const double aside[3] = { 0x1p-30, 0x1.6a09e667f3bcdp-30, 0x1.bb67ae8584caap-30 };

/* A triangle above so many of a column's voxels. */
typedef struct Crossing {
    int32_t below; /* 0 to size */
    int32_t turn;  /* 1 or -1 */
} Crossing;

/* Crossings by columns u + size * v: those of column i from start[i] to start[i + 1]. */
typedef struct Columns {
    uint32_t size;
    int axis, u, v;
    uint32_t *start;
    Crossing *crossings;
} Columns;

/* --- crossings -------------------------------------------------------------------------------- */

static int32_t clamp(double value, uint32_t size)
{
    return (int32_t)fmin(fmax(value, 0), size);
}

/* Lines first <= i < end that may cross a triangle; false: there are none. They are found
 * generously: a line goes by the centre, but for `aside`. */
static bool find_lines(const TruthTriangle *triangle, int axis, uint32_t size, int32_t range[2])
{
    const double margin = 1.0 / 256;
    double low, high;
    truth_bounds(triangle, axis, &low, &high);
    range[0] = clamp(ceil(low - 0.5 - margin), size);
    range[1] = clamp(floor(high - 0.5 + margin) + 1, size);
    return range[0] < range[1];
}

/* Counts the crossings of a triangle, or, from the back, puts them in their places. */
static void add_triangle(const Columns *columns, const TruthTriangle *triangle, bool puts)
{
    const uint32_t size = columns->size;
    double normal[3];
    int32_t u[2], v[2];
    if (!find_lines(triangle, columns->u, size, u) || !find_lines(triangle, columns->v, size, v))
        return;
    const TruthProjection p = truth_project(triangle, columns->axis);
    truth_normal(triangle, normal);
    if (normal[columns->axis] == 0)
        return;
    for (int32_t j = v[0]; j < v[1]; j++)
        for (int32_t i = u[0]; i < u[1]; i++) {
            const double x = i + 0.5 + aside[p.u], y = j + 0.5 + aside[p.v];
            uint32_t *at = &columns->start[(uint32_t)i + size * (uint32_t)j];
            if (!truth_covers(&p, x, y))
                continue;
            if (!puts) {
                ++*at;
                continue;
            }
            const double depth = truth_depth(triangle, normal, &p, x, y);
            columns->crossings[--*at] = (Crossing){ clamp(ceil(depth - 0.5 - aside[p.axis]), size),
                                                    normal[p.axis] > 0 ? 1 : -1 };
        }
}

/* Counts, sums, and fills from the back, so that each column's start is reached at last. */
static GpResult find_crossings(const TruthTriangle *triangles, uint32_t count, Columns *columns)
{
    const size_t all = (size_t)columns->size * columns->size;
    columns->start = gp_alloc(all + 1, sizeof *columns->start);
    if (!columns->start)
        return GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < count; i++)
        add_triangle(columns, &triangles[i], false);
    for (size_t i = 1; i <= all; i++)
        columns->start[i] += columns->start[i - 1];
    columns->crossings = gp_alloc((size_t)columns->start[all] + 1, sizeof *columns->crossings);
    if (!columns->crossings)
        return GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < count; i++)
        add_triangle(columns, &triangles[i], true);
    return GP_OK;
}

/* --- columns ---------------------------------------------------------------------------------- */

/* The highest first. */
static int compare(const void *a, const void *b)
{
    const Crossing *x = a, *y = b;
    return (y->below > x->below) - (y->below < x->below);
}

static void set_run(uint8_t *bits, size_t first, size_t step, int32_t low, int32_t end)
{
    for (int32_t k = low; k < end; k++) {
        const size_t i = first + (size_t)k * step;
        bits[i / 8] = (uint8_t)(bits[i / 8] | 1u << i % 8);
    }
}

/* first: the bit of the column's lowest voxel; step: to the next above it */
static void sweep(Crossing *crossings, uint32_t count, size_t first, size_t step,
                  VoxelWinding *winding)
{
    int32_t number = 0;
    qsort(crossings, count, sizeof *crossings, compare);
    for (uint32_t i = 0; i < count; i++) {
        const int32_t end = crossings[i].below, low = i + 1 < count ? crossings[i + 1].below : 0;
        number += crossings[i].turn;
        if (i % 2 == 0)
            set_run(winding->odd, first, step, low, end);
        if (number == 0)
            continue;
        set_run(winding->inside, first, step, low, end);
        winding->doubled += number % 2 == 0 ? (uint64_t)(end - low) : 0;
    }
    winding->odd_columns += count % 2;
}

GpResult voxel_winding_make(const TruthTriangle *triangles, uint32_t count, uint32_t size, int axis,
                            VoxelWinding *winding)
{
    const size_t step[3] = { 1, size, (size_t)size * size };
    Columns columns = { .size = size, .axis = axis, .u = (axis + 1) % 3, .v = (axis + 2) % 3 };
    VoxelWinding made = { gp_alloc(voxel_bytes(size), 1), gp_alloc(voxel_bytes(size), 1), 0, 0 };
    GpResult result =
        made.odd && made.inside ? find_crossings(triangles, count, &columns) : GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < size * size && !result; i++)
        sweep(columns.crossings + columns.start[i], columns.start[i + 1] - columns.start[i],
              i % size * step[columns.u] + i / size * step[columns.v], step[axis], &made);
    gp_free(columns.start);
    gp_free(columns.crossings);
    if (result)
        voxel_winding_free(&made);
    else
        *winding = made;
    return result;
}

void voxel_winding_free(VoxelWinding *winding)
{
    gp_free(winding->odd);
    gp_free(winding->inside);
    *winding = (VoxelWinding){ .odd = NULL };
}
