/* Small triangles: two rows of quads at a time, down the columns of their boxes. */
#include "pipeline/fast/lanes/batch.h"
#include "pipeline/fast/lanes/patch.h"

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
    dbl wide;
    __builtin_memcpy(&wide, &a, sizeof wide);
    return __builtin_convertvector(wide, flt);
}

/* Edges at the pixels of a patch. They go down the column two rows at a time: integers, which stay
 * below 2^53 in binary64 too, so that adding is exact. */
typedef struct Column {
    itg inside[3], inside_gain[3];
    itg beyond, below; /* negative right of, and below the box */
    Doubles edge[2];   /* 1 and 2 */
    double edge_gain[2];
} Column;

/* The column that begins `left` pixels from the box's first. */
GP_INLINE Column column_at(const Batch *b, uint32_t lane, int32_t left)
{
    const itg column = lane_columns(true) + left, row = lane_rows(true);
    Column c = { .beyond = b->width[lane] - column, .below = b->height[lane] - row };
    GP_UNROLL
    for (int i = 0; i < 3; i++) {
        itg gained = itg_dot2(itg_set(b->gain[i][lane]), column | row << 16);
        c.inside[i] = b->inside[i][lane] + gained;
        c.inside_gain[i] = itg_set(2 * b->down[i][lane]);
        if (i == 0)
            continue;
        c.edge[i - 1] = doubles_from_itg(b->edge[i][lane] + (gained << GP_SUBPIXEL_BITS));
        c.edge_gain[i - 1] = (double)(2 * GP_SUBPIXELS * b->down[i][lane]);
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
        c->inside[i] += c->inside_gain[i];
    GP_UNROLL
    for (int i = 0; i < 4; i++)
        c->edge[i / 2].part[i % 2] += c->edge_gain[i / 2];
    c->below -= 2;
}

GP_INLINE flt depth_of(const Batch *b, uint32_t lane, const Column *c)
{
    const double base = b->base[lane], step[2] = { b->step[0][lane], b->step[1][lane] };
    Doubles z;
    GP_UNROLL
    for (int i = 0; i < 2; i++)
        z.part[i] = base + (c->edge[0].part[i] * step[0] + c->edge[1].part[i] * step[1]);
    return flt_from_doubles(z);
}

/* Returns the lanes that passed. Steps of which none can, by the triangle's nearest `code`, go no
 * further; but where depth is all, going on is cheaper than a branch that is hard to foresee. */
GP_INLINE msk fill_triangle(const Filler *f, EarlyTest early, FastRoute route, const Batch *b,
                            uint32_t lane, int32_t code)
{
    const bool nearer = early == EARLY_NEARER_FLOAT || early == EARLY_NEARER_UNORM;
    const int32_t x = b->x[lane], right = x + b->width[lane];
    const int32_t top = b->y[lane], bottom = top + b->height[lane];
    msk passed = itg_set(0);
    for (int32_t left = x; left <= right; left += QUADS_WIDE) {
        Column c = column_at(b, lane, left - x);
        for (int32_t y = top; y <= bottom; y += 2, go_down(&c)) {
            msk live = covered(&c);
            if (nearer && route != FAST_DEPTH_ONLY)
                live &= (msk)(code - f->allowance <
                              load_lanes(f->tile->depth + fast_at(left, y), true));
            if (route != FAST_DEPTH_ONLY && !msk_any(live))
                continue;
            flt z = early == EARLY_NONE ? flt_set(0) : depth_of(b, lane, &c);
            passed |= route_lanes(f, early, route, true, left, y, live, z);
        }
    }
    return passed;
}

GP_INLINE void fill(Filler f, EarlyTest early, FastRoute route, const Batch *b, unsigned lanes)
{
    Tile *tile = f.tile;
    const bool nearer = early == EARLY_NEARER_FLOAT || early == EARLY_NEARER_UNORM;
    const itg codes = nearer ? nearer_codes(&f, early, b->nearest) : itg_set(0);
    for (; lanes; lanes &= lanes - 1) {
        uint32_t lane = (uint32_t)__builtin_ctz(lanes);
        FastRecord *record = &tile->records[tile->record_count];
        f.number = tile->record_count;
        f.front = b->front >> lane & 1;
        if (route == FAST_ORDERED)
            FAST(write_record)(f.d, b, lane, record);
        msk passed = fill_triangle(&f, early, route, b, lane, codes[lane]);
        if (route == FAST_DEPTH_ONLY || !msk_any(passed))
            continue;
        if (route == FAST_VISIBLE)
            FAST(write_record)(f.d, b, lane, record);
        tile->record_count++;
    }
}

void FAST(fill_small)(const Filler *f, const Batch *b, unsigned lanes)
{
    const FastRoute route = f->d->route;
    if (f->early == EARLY_NEARER_FLOAT && route == FAST_DEPTH_ONLY)
        fill(*f, EARLY_NEARER_FLOAT, FAST_DEPTH_ONLY, b, lanes);
    else if (f->early == EARLY_NEARER_FLOAT && route == FAST_VISIBLE)
        fill(*f, EARLY_NEARER_FLOAT, FAST_VISIBLE, b, lanes);
    else if (f->early == EARLY_NEARER_FLOAT)
        fill(*f, EARLY_NEARER_FLOAT, route, b, lanes);
    else if (f->early == EARLY_NEARER_UNORM)
        fill(*f, EARLY_NEARER_UNORM, route, b, lanes);
    else if (f->early == EARLY_NONE)
        fill(*f, EARLY_NONE, route, b, lanes);
    else
        fill(*f, EARLY_ANY, route, b, lanes);
}
