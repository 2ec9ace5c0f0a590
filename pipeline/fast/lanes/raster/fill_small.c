/* Small triangles: some rows at a time, down the columns of their boxes. */
#include "pipeline/fast/lanes/raster/fill.h"

/* Pixels across a column of rows: many boxes have no more than four. */
enum { WIDE = GP_LANES / 2, NARROW = 4 };

/* GP_LANES doubles, in two vectors of a register's width. */
typedef double dbl_half __attribute__((vector_size(4 * GP_LANES)));
typedef struct Doubles {
    dbl_half part[2];
} Doubles;

GP_INLINE Doubles doubles_from_itg(itg a)
{
    dbl wide = dbl_from_itg(a);
    Doubles halves;
    __builtin_memcpy(&halves, &wide, sizeof halves);
    return halves;
}

GP_INLINE flt flt_from_doubles(Doubles a)
{
    typedef float flt_half __attribute__((vector_size(2 * GP_LANES)));
    const flt_half low = __builtin_convertvector(a.part[0], flt_half);
    const flt_half high = __builtin_convertvector(a.part[1], flt_half);
    return __builtin_shufflevector(low, high, LANES_IN_ORDER);
}

/* Edges at the pixels of a packet of some rows, or of quads where `wide` is 0. They go down the
 * column a packet at a time: integers, which stay below 2^53 in binary64 too, so that adding is
 * exact. */
typedef struct Column {
    int32_t wide, rows;
    itg inside[3], inside_step[3];
    itg beyond, below; /* negative right of, and below the box */
    Doubles edge[2];   /* 1 and 2 */
    double edge_step[2];
} Column;

/* The column that begins `left` pixels from the box's first. */
GP_INLINE Column column_at(const TriangleBatch *b, uint32_t lane, int32_t left, int32_t wide)
{
    const int32_t rows = wide ? GP_LANES / wide : 2;
    const itg column = (wide ? lane_numbers() % wide : lane_columns(true)) + left;
    const itg row = wide ? lane_numbers() / wide : lane_rows(true);
    Column c = { .wide = wide,
                 .rows = rows,
                 .beyond = b->width[lane] - column,
                 .below = b->height[lane] - row };
    GP_UNROLL
    for (int i = 0; i < 3; i++) {
        itg stepped = itg_dot2(itg_set(b->steps[i][lane]), column | row << 16);
        c.inside[i] = b->inside[i][lane] + stepped;
        c.inside_step[i] = itg_set(rows * b->down[i][lane]);
        if (i == 0)
            continue;
        c.edge[i - 1] = doubles_from_itg(b->edge[i][lane] + (stepped << GP_SUBPIXEL_BITS));
        c.edge_step[i - 1] = (double)(rows * GP_SUBPIXELS * b->down[i][lane]);
    }
    return c;
}

/* By the sign, which stays in a register for vectors where a comparison might not. */
GP_INLINE msk covered(const Column *c)
{
    return ~((c->inside[0] | c->inside[1] | c->inside[2] | c->beyond | c->below) >> 31);
}

GP_INLINE void go_down(Column *c)
{
    GP_UNROLL
    for (int i = 0; i < 3; i++)
        c->inside[i] += c->inside_step[i];
    GP_UNROLL
    for (int i = 0; i < 4; i++)
        c->edge[i / 2].part[i % 2] += c->edge_step[i / 2];
    c->below -= c->rows;
}

GP_INLINE flt depth_of(const TriangleBatch *b, uint32_t lane, const Column *c)
{
    const double base = b->base[lane], step[2] = { b->step[0][lane], b->step[1][lane] };
    Doubles z;
    GP_UNROLL
    for (int i = 0; i < 2; i++)
        z.part[i] = base + (c->edge[0].part[i] * step[0] + c->edge[1].part[i] * step[1]);
    return flt_from_doubles(z);
}

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

/* The usual test, where nothing is ordered. Steps of which nothing is visible go no further; but
 * where depth is all, going on is cheaper than a branch that is hard to foresee. */
GP_INLINE msk fill_rows(const Filling *w, const Column *c, int32_t x, int32_t y, msk live)
{
    Tile *tile = w->f->tile;
    const uint32_t at = fast_at(x, y);
    const itg stored = load_rows(tile->depth + at, c->wide);
    if (w->path == FAST_VISIBLE) {
        live &= can_pass(w, stored);
        if (!msk_any(live))
            return live;
    }
    const itg code = nearer_codes(w->f, w->early, depth_of(w->b, w->lane, c));
    live &= (code - w->f->allowance - stored) >> 31; /* codes are not negative */
    store_rows(tile->depth + at, c->wide, itg_select(live, code, stored));
    if (w->path == FAST_VISIBLE) {
        const itg number = itg_set((int32_t)w->f->number);
        const itg shown = load_rows(tile->visibility->record + at, c->wide);
        store_rows(tile->visibility->record + at, c->wide, itg_select(live, number, shown));
    }
    return live;
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
    msk passed = itg_set(0);
    Column c = column_at(b, w->lane, left - b->x[w->lane], wide);
    for (int32_t y = top; y <= bottom; y += c.rows, go_down(&c))
        passed |=
            wide ? fill_rows(w, &c, left, y, covered(&c)) : fill_quads(w, &c, left, y, covered(&c));
    return passed;
}

/* Returns the lanes that passed. */
GP_INLINE msk fill_triangle(const Filling *w)
{
    const bool rows = w->path != FAST_ORDERED && is_usual(w->early);
    const int32_t right = w->b->x[w->lane] + w->b->width[w->lane];
    msk passed = itg_set(0);
    for (int32_t left = w->b->x[w->lane]; left <= right; left += WIDE) {
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
