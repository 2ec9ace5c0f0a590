/* Fragment paths: to the visibility buffer, queued for the shader, or only tested. */
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

Filler fast_filler(Tile *tile)
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

void fast_reserve_records(Tile *tile, uint32_t count)
{
    /* an ordered draw's records are done with once its packets are shaded */
    if (tile->draw->path == FAST_ORDERED && !tile->packet_count && !tile->layer_count) {
        tile->record_count = FAST_NO_RECORD + 1;
        tile->edges64_count = 0;
    }
    bool new_run = !tile->run_count || tile->runs[tile->run_count - 1].draw != tile->draw_number;
    if (tile->record_count + count > FAST_RECORDS || tile->edges64_count + count > FAST_EDGES64 ||
        (new_run && tile->run_count == FAST_RUNS)) {
        fast_flush_packets(tile);
        fast_flush_visibility(tile);
        new_run = true;
    }
    if (new_run) {
        tile->runs[tile->run_count].first_record = tile->record_count;
        tile->runs[tile->run_count++].draw = tile->draw_number;
    }
}

void fast_settle_occluder(Tile *tile)
{
    if (tile->occluder == FAST_NO_RECORD)
        return;
    for (uint32_t y = 0; y < FAST_TILE; y++)
        for (uint32_t x = 0; x < FAST_TILE; x++) {
            uint32_t *shown = &tile->visibility[y * FAST_PITCH + x];
            *shown = *shown > tile->occluder ? *shown : tile->occluder;
        }
    tile->occluder = FAST_NO_RECORD;
}
