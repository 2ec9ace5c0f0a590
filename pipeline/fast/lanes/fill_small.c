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
    double base, step[2]; /* of depth */
} Column;

/* The column that begins `left` pixels from the box's first. */
GP_INLINE Column column_at(const Batch *b, uint32_t lane, int32_t left)
{
    const itg column = lane_columns(true) + left, row = lane_rows(true);
    Column c = { .beyond = b->width[lane] - column,
                 .below = b->height[lane] - row,
                 .base = b->base[lane],
                 .step = { b->step[0][lane], b->step[1][lane] } };
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

GP_INLINE flt depth_of(const Column *c)
{
    Doubles z;
    GP_UNROLL
    for (int i = 0; i < 2; i++)
        z.part[i] = c->base + (c->edge[0].part[i] * c->step[0] + c->edge[1].part[i] * c->step[1]);
    return flt_from_doubles(z);
}

/* Returns the lanes that passed. */
GP_INLINE msk fill_triangle(const Filler *f, EarlyTest early, const Batch *b, uint32_t lane)
{
    const int32_t x = b->x[lane], right = x + b->width[lane];
    const int32_t top = b->y[lane], bottom = top + b->height[lane];
    msk passed = itg_set(0);
    for (int32_t left = x; left <= right; left += QUADS_WIDE) {
        Column c = column_at(b, lane, left - x);
        for (int32_t y = top; y <= bottom; y += 2) {
            itg out = c.inside[0] | c.inside[1] | c.inside[2] | c.beyond | c.below;
            flt z = early == EARLY_NONE ? flt_set(0) : depth_of(&c);
            passed |= route_lanes(f, early, true, left, y, (msk)(out >= 0), z);
            go_down(&c);
        }
    }
    return passed;
}

GP_INLINE void fill(Filler f, EarlyTest early, const Batch *b, unsigned lanes)
{
    Tile *tile = f.tile;
    for (; lanes; lanes &= lanes - 1) {
        uint32_t lane = (uint32_t)__builtin_ctz(lanes);
        FastRecord *record = &tile->records[tile->record_count];
        f.number = tile->record_count;
        f.front = b->front >> lane & 1;
        if (f.d->route == FAST_ORDERED)
            FAST(write_record)(f.d, b, lane, record);
        msk passed = fill_triangle(&f, early, b, lane);
        if (f.d->route == FAST_DEPTH_ONLY || !msk_bits(passed))
            continue;
        if (f.d->route == FAST_VISIBLE)
            FAST(write_record)(f.d, b, lane, record);
        tile->record_count++;
    }
}

void FAST(fill_small)(const Filler *f, const Batch *b, unsigned lanes)
{
    if (f->early == EARLY_NEARER_FLOAT)
        fill(*f, EARLY_NEARER_FLOAT, b, lanes);
    else if (f->early == EARLY_NEARER_UNORM)
        fill(*f, EARLY_NEARER_UNORM, b, lanes);
    else if (f->early == EARLY_NONE)
        fill(*f, EARLY_NONE, b, lanes);
    else
        fill(*f, EARLY_ANY, b, lanes);
}
