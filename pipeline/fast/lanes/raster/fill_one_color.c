/* Small triangles of one colour, whose fragments go into the lists of their pixels: some rows at a
 * time. */
#include "pipeline/fast/lanes/raster/column.h"
#include "pipeline/fast/lanes/raster/fill.h"

/* Tests that come early, of lanes of some rows; nothing is written. */
GP_INLINE msk test_rows(const Filler *f, uint32_t at, int32_t wide, msk live, flt z)
{
    const FastDraw *d = f->d;
    if (f->early == EARLY_NONE || d->tests_last)
        return live;
    const itg stored = load_rows(f->tile->depth + at, wide);
    if (is_usual(f->early))
        return live & ((nearer_codes(f, f->early, z) - f->allowance - stored) >> 31);
    z = flt_lesser(flt_greater(z, flt_set(f->low)), flt_set(f->high));
    return live &
           compare_codes(d->draw->state.depth.test, depth_codes(f->tile->depth_format, z), stored);
}

/* Returns the lanes that were kept. */
GP_INLINE msk fill_column(const Filler *f, const TriangleBatch *b, uint32_t lane, int32_t left,
                          int32_t wide)
{
    const int32_t top = b->y[lane], bottom = top + b->height[lane];
    msk kept = itg_set(0);
    Column c = column_at(b, lane, left - b->x[lane], wide);
    for (int32_t y = top; y <= bottom; y += c.rows, go_down(&c)) {
        const msk live = covered(&c);
        if (!msk_any(live))
            continue;
        const flt z = depth_of(b, lane, &c);
        const uint32_t at = fast_at(left, y);
        kept |= list_rows(f, at, wide, test_rows(f, at, wide, live, z), z);
    }
    return kept;
}

static bool fill_triangle(const Filler *f, const TriangleBatch *b, uint32_t lane)
{
    const int32_t right = b->x[lane] + b->width[lane];
    msk kept = itg_set(0);
    for (int32_t left = b->x[lane]; left <= right; left += WIDE)
        if (NARROW < WIDE && right - left < NARROW)
            kept |= fill_column(f, b, lane, left, NARROW);
        else
            kept |= fill_column(f, b, lane, left, WIDE);
    return msk_any(kept);
}

void fast_fill_one_color(const Filler *filler, const TriangleBatch *b, unsigned lanes)
{
    Filler f = *filler;
    FastRecords *records = f.tile->records;
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t lane = (uint32_t)__builtin_ctz(lanes);
        f.color = fast_begin_color(f.tile, records->count, b->front >> lane & 1);
        if (fill_triangle(&f, b, lane))
            fast_write_record(f.d, b, lane, &records->record[records->count++]);
        else
            fast_undo_color(f.tile);
    }
}
