/* The routes of fragments: seen, queued for the shader, or only tested. */
#include "pipeline/fast/lanes/route.h"

static void see(Tile *tile, uint32_t at, unsigned live, uint32_t record)
{
    itg before; /* anywhere in a row: not aligned to a vector */
    __builtin_memcpy(&before, tile->seen + at, sizeof before);
    before = itg_select(mask_of(live), itg_set((int32_t)record), before);
    __builtin_memcpy(tile->seen + at, &before, sizeof before);
}

void FAST(reserve_records)(Tile *tile, uint32_t count)
{
    /* an ordered draw's records are done with once its patches are shaded */
    if (tile->draw->route == FAST_ORDERED && !tile->patch_count) {
        tile->record_count = FAST_NO_RECORD + 1;
        tile->wide_count = 0;
    }
    bool new_run = !tile->run_count || tile->runs[tile->run_count - 1].draw != tile->draw_number;
    if (tile->record_count + count > FAST_RECORDS || tile->wide_count + count > FAST_WIDES ||
        (new_run && tile->run_count == FAST_RUNS)) {
        FAST(flush_patches)(tile);
        FAST(flush_seen)(tile);
        new_run = true;
    }
    if (new_run) {
        tile->runs[tile->run_count].first_record = tile->record_count;
        tile->runs[tile->run_count++].draw = tile->draw_number;
    }
}

unsigned FAST(route_lanes)(const Filler *f, int32_t x, int32_t y, unsigned live, flt z)
{
    Tile *tile = f->tile;
    const FastDraw *d = f->d;
    if (d->wants_depth && !d->late_depth)
        live = FAST(depth_stencil)(tile, d, fast_at(x, y), live, z, f->front);
    if (live && d->route == FAST_VISIBLE)
        see(tile, fast_at(x, y), live, f->number);
    else if (live && d->route == FAST_ORDERED && !d->needs.quads)
        FAST(queue_row)(tile, f->number, x, y, live, z);
    return live;
}
