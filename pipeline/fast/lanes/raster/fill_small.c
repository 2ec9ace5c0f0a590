/* Small triangles: some rows at a time, down the columns of their boxes. */
#include "pipeline/fast/lanes/raster/column.h"
#include "pipeline/fast/lanes/raster/fill.h"

/* One triangle at work. */
typedef struct Filling {
    const Filler *f;
    EarlyTest early;
    FastFragmentPath path;
    const TriangleBatch *b;
    uint32_t lane;
    int32_t code; /* its nearest one, where the test is the usual one */
} Filling;

/* By the triangle's nearest code. */
GP_INLINE msk can_pass(const Filling *w, itg stored)
{
    return (msk)(w->code - w->f->allowance < stored);
}

/* The usual test, where nothing is ordered. Steps of which nothing is visible go on: a branch there
 * is hard to foresee (meshes take 2 to 7 % less; small draws that hide each other 3 % more).
 * returns numbers that are negative in lanes that pass */
GP_INLINE itg fill_rows(const Filling *w, const Column *c, int32_t x, int32_t y)
{
    Tile *tile = w->f->tile;
    const uint32_t at = fast_at(x, y);
    const itg stored = load_rows(tile->depth + at, c->wide);
    const itg code = nearer_codes(w->f, w->early, depth_of(w->b, w->lane, c));
    const itg passes = (code - w->f->allowance - stored) & ~outside(c); /* codes are not negative */
    store_rows(tile->depth + at, c->wide, itg_select_negative(passes, code, stored));
    if (w->path == FAST_VISIBLE) {
        const itg number = itg_set((int32_t)w->f->number);
        const itg shown = load_rows(tile->visibility->record + at, c->wide);
        store_rows(tile->visibility->record + at, c->wide,
                   itg_select_negative(passes, number, shown));
    }
    return passes;
}

/* Any tests, any fragment path. */
GP_INLINE msk fill_quads(const Filling *w, const Column *c, int32_t x, int32_t y, msk live)
{
    if (is_usual(w->early))
        live &= can_pass(w, load_lanes(w->f->tile->depth + fast_at(x, y), true));
    if (w->path != FAST_DEPTH_ONLY && !msk_any(live))
        return live;
    flt z = w->early == EARLY_NONE ? flt_set(0) : depth_of(w->b, w->lane, c);
    return send_lanes(w->f, w->early, w->path, true, x, y, live, z);
}

GP_INLINE msk fill_column(const Filling *w, int32_t left, int32_t wide)
{
    const TriangleBatch *b = w->b;
    const int32_t top = b->y[w->lane], bottom = top + b->height[w->lane];
    itg passed = itg_set(0);
    Column c = column_at(b, w->lane, left - b->x[w->lane], wide);
    for (int32_t y = top; y <= bottom; y += c.rows, go_down(&c))
        passed |= wide ? fill_rows(w, &c, left, y) : fill_quads(w, &c, left, y, covered(&c));
    return (msk)(passed >> 31);
}

/* Returns the lanes that passed. */
GP_INLINE msk fill_triangle(const Filling *w)
{
    const bool rows = w->path != FAST_ORDERED && is_usual(w->early);
    const int32_t right = w->b->x[w->lane] + w->b->width[w->lane];
    msk passed = itg_set(0);
    for (int32_t left = w->b->x[w->lane]; left <= right; left += rows ? WIDE : QUADS_WIDE) {
        if (!rows)
            passed |= fill_column(w, left, 0);
        else if (NARROW < WIDE && right - left < NARROW)
            passed |= fill_column(w, left, NARROW);
        else
            passed |= fill_column(w, left, WIDE);
    }
    return passed;
}

GP_INLINE void fill(Filler f, EarlyTest early, FastFragmentPath path, const TriangleBatch *b,
                    unsigned lanes)
{
    Tile *tile = f.tile;
    const itg codes = is_usual(early) ? nearer_codes(&f, early, b->nearest) : itg_set(0);
    for (; lanes; lanes &= lanes - 1) {
        uint32_t lane = (uint32_t)__builtin_ctz(lanes);
        FastTriangleRecord *record = &tile->records->record[tile->records->count];
        f.number = tile->records->count;
        f.front = b->front >> lane & 1;
        if (path == FAST_ORDERED)
            fast_write_record(f.d, b, lane, record);
        const Filling work = { &f, early, path, b, lane, codes[lane] };
        msk passed = fill_triangle(&work);
        if (path == FAST_DEPTH_ONLY || !msk_any(passed))
            continue;
        if (path == FAST_VISIBLE)
            fast_write_record(f.d, b, lane, record);
        tile->records->count++;
    }
}

void fast_fill_small(const Filler *f, const TriangleBatch *b, unsigned lanes)
{
    const FastFragmentPath path = f->d->path;
    if (f->early == EARLY_NEARER_FLOAT && path == FAST_DEPTH_ONLY)
        fill(*f, EARLY_NEARER_FLOAT, FAST_DEPTH_ONLY, b, lanes);
    else if (f->early == EARLY_NEARER_FLOAT && path == FAST_VISIBLE)
        fill(*f, EARLY_NEARER_FLOAT, FAST_VISIBLE, b, lanes);
    else if (f->early == EARLY_NEARER_FLOAT)
        fill(*f, EARLY_NEARER_FLOAT, FAST_ORDERED, b, lanes);
    else if (f->early == EARLY_NEARER_UNORM)
        fill(*f, EARLY_NEARER_UNORM, path, b, lanes);
    else if (f->early == EARLY_NONE)
        fill(*f, EARLY_NONE, path, b, lanes);
    else
        fill(*f, EARLY_ANY, path, b, lanes);
}
