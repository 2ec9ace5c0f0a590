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
 * box, but for three roundings of the terms' size at most, there and anywhere. Numbers all: a corner
 * has a place only with a finite depth (R3), and biases are finite. */
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

enum { STRIPS = FAST_TILE / GP_LANES }; /* of a row */

/* What is known to be hidden from codes of `nearest` on, as fast_fill_large wants it. */
typedef struct Hidden {
    int32_t nearest;
    uint32_t strips[FAST_TILE];
} Hidden;

_Static_assert(STRIPS <= 32, "strips of a row have a bit each");

/* Where in the tile the nearest depth of a triangle would pass, as far as strips tell. */
typedef struct Passing {
    int32_t top, bottom; /* rows */
    itg columns[STRIPS]; /* negative: in some row */
} Passing;

/* What is hidden stays so while depths only come nearer, and triangles are not nearer than the one for
 * which it was found: of a row only strips that were not hidden are looked at again. */
static void find_passing(const Tile *tile, const FastBox *box, int32_t bound, Hidden *hidden,
                         Passing *passing)
{
    const unsigned inside = (2u << box->x1 / GP_LANES) - (1u << box->x0 / GP_LANES);
    *passing = (Passing){ .top = FAST_TILE, .bottom = -1 };
    for (int32_t y = box->y0; y <= box->y1; y++) {
        const uint32_t *row = tile->depth + fast_at(0, y);
        unsigned passes = 0;
        for (unsigned left = hidden->strips[y] & inside; left; left &= left - 1) {
            const int i = __builtin_ctz(left);
            const itg before = bound - load_lanes(row + i * GP_LANES, false);
            passing->columns[i] |= before;
            passes |= (unsigned)(msk_bits((msk)(before < 0)) != 0) << i;
        }
        hidden->strips[y] = (hidden->strips[y] & ~inside) | passes;
        if (!passes)
            continue;
        passing->top = passing->bottom < 0 ? y : passing->top;
        passing->bottom = y;
    }
}

/* Cuts a box in the tile to where the nearest depth would pass; false: nowhere. */
static bool cut_to_passing(const Tile *tile, int32_t bound, Hidden *hidden, FastBox *box)
{
    Passing passing;
    find_passing(tile, box, bound, hidden, &passing);
    int32_t left = FAST_TILE, right = -1;
    for (int32_t i = 0; i < STRIPS; i++) {
        const unsigned bits = msk_bits((msk)(passing.columns[i] < 0));
        if (!bits)
            continue;
        left = right < 0 ? i * GP_LANES + __builtin_ctz(bits) : left;
        right = i * GP_LANES + 31 - __builtin_clz(bits);
    }
    box->x0 = left > box->x0 ? left : box->x0;
    box->x1 = right < box->x1 ? right : box->x1;
    box->y0 = passing.top;
    box->y1 = passing.bottom;
    return box->x0 <= box->x1; /* there are rows where there are columns */
}

static void fill_visible(Tile *tile, const Filler *f, FastSortedTriangle *sorted, Hidden *hidden)
{
    GpTriangle *t = &sorted->triangle;
    FastBox box = { t->x0 - tile->x0, t->y0 - tile->y0, t->x1 - tile->x0, t->y1 - tile->y0 };
    if (sorted->nearest < hidden->nearest)
        memset(hidden->strips, 255, sizeof hidden->strips);
    hidden->nearest = sorted->nearest;
    if (!cut_to_passing(tile, sorted->nearest - f->allowance, hidden, &box))
        return;
    t->x0 = tile->x0 + box.x0;
    t->y0 = tile->y0 + box.y0;
    t->x1 = tile->x0 + box.x1;
    t->y1 = tile->y0 + box.y1;
    fast_fill_large(tile, t, hidden->strips);
}

void fast_fill_sorted(Tile *tile)
{
    if (!tile->sorted->count)
        return;
    const Filler f = fast_filler(tile);
    Hidden hidden = { .nearest = INT32_MAX };
    for (uint32_t i = 0; i < tile->sorted->count; i++) {
        fast_flush_packets(tile); /* they may hide it */
        fill_visible(tile, &f, &tile->sorted->triangle[tile->sorted->order[i]], &hidden);
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
