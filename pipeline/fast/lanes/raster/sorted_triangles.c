/* Large triangles of a draw whose nearest fragment wins, nearest first.
 *
 * Where only nearer fragments pass, and what survives the shader replaces all that was there, two
 * fragments of a pixel may change places if their depths differ: the farther one is hidden in the
 * end. So large triangles of such a draw wait for each other and are filled front to back, and what
 * is hidden never meets the shader. Back to front, as such draws often come, this saves all layers
 * but those that are seen through the holes of others. */
#include "pipeline/fast/lanes/raster/sorted_triangles.h"

#include "pipeline/fast/lanes/raster/fill.h"

#include <math.h>
#include <string.h>

/* --- the order -------------------------------------------------------------------------------- */

typedef struct Range {
    double low, high;
} Range;

/* Depths in the tile, before they are rounded to binary32: least and greatest at corners of the
 * box, but for three roundings of the terms' size at most, there and anywhere. Numbers all: a
 * corner has a place only with a finite depth (R3), and biases are finite. */
static Range depth_range(const GpTriangle *t)
{
    Range range = { HUGE_VAL, -HUGE_VAL };
    double size = 0;
    for (int corner = 0; corner < 4; corner++) {
        int64_t x = (int64_t)(corner & 1 ? t->x1 : t->x0) * GP_SUBPIXELS + GP_SUBPIXELS / 2;
        int64_t y = (int64_t)(corner & 2 ? t->y1 : t->y0) * GP_SUBPIXELS + GP_SUBPIXELS / 2;
        double part[2];
        for (int i = 0; i < 2; i++)
            part[i] = (double)(t->a[i + 1] * x + t->b[i + 1] * y + t->c[i + 1]) * t->z_step[i];
        const double z = t->z_base + (part[0] + part[1]);
        const double terms = fabs(t->z_base) + fabs(part[0]) + fabs(part[1]);
        range.low = z < range.low ? z : range.low;
        range.high = z > range.high ? z : range.high;
        size = terms > size ? terms : size;
    }
    range.low -= 0x1p-48 * size;
    range.high += 0x1p-48 * size;
    return range;
}

static int32_t depth_code(const Filler *f, double z)
{
    return nearer_codes(f, f->early, flt_set((float)z))[0];
}

static void find_codes(Tile *tile, FastSortedTriangle *sorted)
{
    const Filler f = fast_filler(tile);
    const Range range = depth_range(&sorted->triangle);
    sorted->nearest = depth_code(&f, range.low);
    sorted->farthest = depth_code(&f, range.high);
}

/* Goes before those that it is nearer than, all of it. */
static void sort_triangle(Tile *tile, const GpTriangle *triangle)
{
    if (tile->sorted->count == FAST_SORTED)
        fast_fill_sorted(tile);
    const uint32_t number = tile->sorted->count++;
    FastSortedTriangle *sorted = &tile->sorted->triangle[number];
    sorted->triangle = *triangle;
    find_codes(tile, sorted);
    uint8_t *place = &tile->sorted->order[number];
    while (place > tile->sorted->order &&
           sorted->farthest < tile->sorted->triangle[place[-1]].nearest) {
        place[0] = place[-1];
        place--;
    }
    *place = (uint8_t)number;
}

/* --- what is hidden --------------------------------------------------------------------------- */

/* Whether any strip of a triangle's rows is left. */
static bool is_any_left(const FastNotHidden *strips, int32_t first, int32_t last)
{
    uint32_t any = 0;
    for (int32_t y = first; y <= last; y++)
        any |= strips->of_row[y];
    return any;
}

/* What is hidden stays so while depths only come nearer, and triangles are not nearer than the one
 * for which it was found. */
static void fill_visible(Tile *tile, const FastSortedTriangle *sorted, FastNotHidden *strips)
{
    const GpTriangle *t = &sorted->triangle;
    if (sorted->nearest < strips->nearest)
        memset(strips->of_row, 255, sizeof strips->of_row);
    strips->nearest = sorted->nearest;
    if (is_any_left(strips, t->y0 - tile->y0, t->y1 - tile->y0))
        fast_fill_large(tile, t, strips);
}

void fast_fill_sorted(Tile *tile)
{
    FastNotHidden strips;
    strips.nearest = INT32_MAX;
    for (uint32_t i = 0; i < tile->sorted->count; i++) {
        fast_flush_packets(tile); /* they may hide it */
        fill_visible(tile, &tile->sorted->triangle[tile->sorted->order[i]], &strips);
    }
    tile->sorted->count = 0;
}

void fast_fill_triangle(Tile *tile, const GpTriangle *t)
{
    if (tile->draw->nearest_wins)
        sort_triangle(tile, t);
    else
        fast_fill_large(tile, t, NULL);
}
