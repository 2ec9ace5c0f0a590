/* The routes of fragments: seen, queued for the shader, or only tested. */
#include "pipeline/fast/lanes/raster/fragment_path.h"

static EarlyTest early_test(const Tile *tile, const FastDraw *d)
{
    const GpDepthState *depth = &d->draw->state.depth;
    if (!d->wants_depth)
        return EARLY_NONE;
    const bool nearer = depth->test == GP_LESS || depth->test == GP_LESS_EQUAL;
    if (!nearer || !(depth->write || d->late_depth) || d->needs.stencil || d->needs.shader_depth)
        return EARLY_ANY;
    return tile->depth_format == GP_D32F ? EARLY_NEARER_FLOAT : EARLY_NEARER_UNORM;
}

Filler FAST(filler)(Tile *tile)
{
    const FastDraw *d = tile->draw;
    return (Filler){ .tile = tile,
                     .d = d,
                     .early = early_test(tile, d),
                     .low = d->viewport.min_depth + 0.0f,
                     .high = d->viewport.max_depth + 0.0f,
                     .scale = tile->depth_format == GP_D16 ? 65535.0 : 16777215.0,
                     .allowance = d->draw->state.depth.test == GP_LESS_EQUAL };
}

void FAST(reserve_records)(Tile *tile, uint32_t count)
{
    /* an ordered draw's records are done with once its patches are shaded */
    if (tile->draw->route == FAST_ORDERED && !tile->patch_count && !tile->layer_count) {
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

void FAST(settle_backdrop)(Tile *tile)
{
    if (tile->backdrop == FAST_NO_RECORD)
        return;
    for (uint32_t y = 0; y < FAST_TILE; y++)
        for (uint32_t x = 0; x < FAST_TILE; x++) {
            uint32_t *seen = &tile->seen[y * FAST_PITCH + x];
            *seen = *seen > tile->backdrop ? *seen : tile->backdrop;
        }
    tile->backdrop = FAST_NO_RECORD;
}
