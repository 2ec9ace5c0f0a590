/* Columns: how a small triangle's box is walked, some rows at a time. */
#ifndef GP_FAST_RASTER_COLUMN_H
#define GP_FAST_RASTER_COLUMN_H

#include "pipeline/fast/lanes/raster/batch.h"

/* Pixels across a column of rows: of most small boxes all, of many no more than four. */
enum { WIDE = GP_LANES < 8 ? GP_LANES : 8, NARROW = 4 };

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
    return (flt)itg_join_halves((itg_half)low, (itg_half)high);
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

/* Negative outside. */
GP_INLINE itg outside(const Column *c)
{
    const itg out = c->inside[0] | c->inside[1] | c->inside[2] | c->beyond;
    return c->rows == 1 ? out : out | c->below; /* single rows end with the box */
}

/* By the sign, which stays in a register for vectors where a comparison might not. */
GP_INLINE msk covered(const Column *c)
{
    return ~(outside(c) >> 31);
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

#endif
