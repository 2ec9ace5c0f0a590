/* One tile: its primitives in submission order, from clear to store. */
#include "pipeline/base/prefetch.h"
#include "pipeline/fast/draws/clear.h"
#include "pipeline/fast/draws/find.h"
#include "pipeline/fast/lanes/geometry/cull.h"
#include "pipeline/fast/lanes/geometry/sprites.h"
#include "pipeline/fast/lanes/geometry/vertices.h"
#include "pipeline/fast/lanes/memory/slots.h"
#include "pipeline/fast/lanes/memory/sums.h"
#include "pipeline/fast/lanes/raster/even_tile.h"
#include "pipeline/fast/lanes/raster/fill_triangles.h"
#include "pipeline/fast/lanes/raster/hierarchical_depth.h"
#include "pipeline/fast/lanes/raster/sorted_triangles.h"
#include "pipeline/fast/lanes/raster/sprite.h"
#include "pipeline/fast/lanes/shade/fragments.h"
#include "pipeline/fast/lanes/shade/interpolate_gathered.h"
#include "pipeline/fast/lanes/shade/queue.h"
#include "pipeline/fast/lanes/shade/repeated.h"
#include "pipeline/fast/lanes/shade/shader_block.h"
#include "pipeline/fast/lanes/shade/visibility.h"
#include "pipeline/fast/lanes/stages.h"
#include "pipeline/list/read_indices.h"

#include <string.h>

static void draw_polygon(Tile *tile, const FastRange *range, uint32_t primitive)
{
    const FastClipPolygon *fan = fast_find_polygon(range, primitive);
    const GpScreenVertex *corners = range->corners + fan->first;
    for (uint32_t i = 2; i < fan->corners; i++) {
        GpScreenVertex corner[3] = { corners[0], corners[i - 1], corners[i] };
        for (int k = 0; k < 3; k++) { /* found by number: the arrays may have moved */
            uint32_t at = fan->first + (k == 0 ? 0 : i - 2 + (uint32_t)k);
            corner[k].varying = range->corner_varyings + (size_t)at * GP_MAX_VARYINGS;
        }
        fast_fill_corners(tile, corner);
    }
}

static void flush_draw(Tile *tile)
{
    fast_fill_sorted(tile);
    fast_flush_packets(tile);
    fast_end_repeated(tile);
}

/* Those that the draw writes, as it wants them. */
static void hold_targets(Tile *tile, const FastDraw *d)
{
    const int written = gp_program_targets(d->draw->program);
    fast_hold_targets(tile, written < tile->targets ? written : tile->targets,
                      d->only_adds && d->packs_points);
}

/* Between draws: packets wait for one draw only, and what is visible must be shaded before a draw
 * that looks at the targets. */
static void begin_draw(Tile *tile, uint32_t number)
{
    flush_draw(tile);
    tile->draw = &tile->pass->draws[number];
    tile->is_drawn = false;
    fast_keep_hierarchical_depth(tile, tile->draw);
    tile->draw_number = number;
    if (tile->draw->path == FAST_ORDERED)
        fast_flush_visibility(tile);
    hold_targets(tile, tile->draw);
    if (tile->draw->repeated && tile->is_group_whole)
        tile->is_drawn = !fast_find_repeated_fragments(tile);
}

/* Primitives that wait for their draw to have enough of them. */
enum { WAITING = 256 };
typedef struct Waiting {
    uint32_t primitive[WAITING + GP_LANES];
    uint32_t count;
} Waiting;

static void draw_waiting(Tile *tile, Waiting *waiting)
{
    if (waiting->count && tile->draw->draw->geometry.primitive == GP_POINTS)
        fast_fill_sprites(tile, waiting->primitive, waiting->count);
    else if (waiting->count)
        fast_fill_triangles(tile, waiting->primitive, waiting->count);
    waiting->count = 0;
}

/* Points are drawn as soon as there are batches of them, and another whose vertices are on their
 * way: so memory brings vertices, and the next groups, while there is work. */
static void let_points_wait(Tile *tile, const FastPrimitiveMask *mask, Waiting *waiting)
{
    fast_prefetch_points(tile->draw, mask);
    const uint32_t now = (tile->draw->packs_points ? FAST_SPRITE_BATCHES : 1) * GP_LANES;
    if (waiting->count < now + GP_LANES)
        return;
    fast_fill_sprites(tile, waiting->primitive, now);
    waiting->count -= now;
    for (uint32_t i = 0; i < waiting->count; i += GP_LANES)
        memcpy(waiting->primitive + i, waiting->primitive + i + now,
               GP_LANES * sizeof *waiting->primitive);
}

/* Those of the first and the last triangle, and of one between them. */
GP_INLINE void prefetch_indices(const uint32_t *indices, uint32_t lanes)
{
    const int first = __builtin_ctz(lanes), last = 31 - __builtin_clz(lanes);
    __builtin_prefetch(indices + 3 * first);
    __builtin_prefetch(indices + 3 * (first + last) / 2);
    __builtin_prefetch(indices + 3 * last);
}

/* Primitives of the present draw: their indices are wanted soon. */
static void let_wait(Tile *tile, const FastPrimitiveMask *mask, Waiting *waiting)
{
    const FastDraw *d = tile->draw;
    itg_compress(waiting->primitive + waiting->count, mask->lanes,
                 lane_numbers() + (int32_t)mask->first);
    waiting->count += (uint32_t)__builtin_popcount(mask->lanes);
    if (d->draw->geometry.primitive == GP_POINTS) {
        let_points_wait(tile, mask, waiting);
        return;
    }
    if (d->indices)
        prefetch_indices(d->indices + 3 * (mask->first - d->first_primitive), mask->lanes);
    if (waiting->count >= WAITING)
        draw_waiting(tile, waiting);
}

/* Of another draw, or cut: whatever waits comes before. */
static void draw_other(Tile *tile, const FastRange *range, const FastPrimitiveMask *mask,
                       Waiting *waiting)
{
    const uint32_t primitive = mask->first & ~FAST_CLIPPED_FLAG;
    draw_waiting(tile, waiting);
    if (!tile->draw || primitive - tile->draw->first_primitive >= tile->draw->primitive_count)
        begin_draw(tile, fast_find_draw(tile->pass, primitive));
    if (tile->is_drawn)
        return;
    if (mask->first & FAST_CLIPPED_FLAG)
        draw_polygon(tile, range, primitive);
    else
        let_wait(tile, mask, waiting);
}

static bool is_of(const FastDraw *d, const FastPrimitiveMask *mask)
{
    return d && mask->first - d->first_primitive < d->primitive_count; /* cuts have a high flag */
}

static void draw_range(Tile *tile, const FastRange *range, uint32_t number, Waiting *waiting)
{
    for (uint32_t at = range->head[number]; at; at = range->chunks[at].next) {
        const FastChunk *chunk = &range->chunks[at];
        if (chunk->next) /* that one has been asked for: now the one after it */
            gp_prefetch(&range->chunks[range->chunks[chunk->next].next], sizeof(FastChunk));
        for (uint32_t i = 0; i < chunk->count; i++) {
            if (!is_of(tile->draw, &chunk->group[i]))
                draw_other(tile, range, &chunk->group[i], waiting);
            else if (!tile->is_drawn)
                let_wait(tile, &chunk->group[i], waiting);
        }
    }
}

/* --- passes ----------------------------------------------------------------------------------- */

/* Whether any primitive of the pass touches the tile. */
static bool is_touched(const FastPass *pass, uint32_t number)
{
    for (uint32_t r = 0; r < pass->ready_count; r++)
        if (pass->ranges[r].head[number])
            return true;
    return false;
}

/* The bins of passes to come are wanted soon: the heads of one, the first chunk of the one before
 * it, the second of the next. Many a pass has no more in a tile. */
GP_INLINE void prefetch_bins(const FastGroup *group, uint32_t next, uint32_t number)
{
    const FastRange *range[3];
    for (uint32_t i = 0; i < 3; i++) {
        if (next + i >= group->pass_count || !group->passes[next + i].ready_count)
            return;
        range[i] = &group->passes[next + i].ranges[0];
    }
    __builtin_prefetch(&range[2]->head[number]);
    __builtin_prefetch(&range[1]->chunks[range[1]->head[number]]);
    const uint32_t first = range[0]->head[number];
    if (first)
        __builtin_prefetch(&range[0]->chunks[range[0]->chunks[first].next]);
}

/* Ranges of a large pass have little in a tile: the first chunk of the next is wanted soon, and the
 * heads of those that follow. */
GP_INLINE void prefetch_ranges(const FastPass *pass, uint32_t next, uint32_t number)
{
    enum { AHEAD = 4 };
    if (next + AHEAD < pass->ready_count)
        __builtin_prefetch(&pass->ranges[next + AHEAD].head[number]);
    if (next < pass->ready_count)
        gp_prefetch(&pass->ranges[next].chunks[pass->ranges[next].head[number]], sizeof(FastChunk));
}

static void draw_bins(Tile *tile, const FastPass *pass, uint32_t number)
{
    Waiting waiting;
    waiting.count = 0;
    for (uint32_t r = 0; r < pass->ready_count; r++) {
        prefetch_ranges(pass, r + 1, number);
        draw_range(tile, &pass->ranges[r], number, &waiting);
    }
    draw_waiting(tile, &waiting);
}

/* All draws of a pass; of one that sorts those fragments which have their turn in the present
 * slice. */
static void draw_slice(Tile *tile, const FastPass *pass, uint32_t number)
{
    tile->draw = NULL;
    tile->is_drawn = false;
    fast_keep_hierarchical_depth(tile, NULL);
    tile->queue->count = tile->queue->layers.count = tile->queue->colors = 0;
    tile->sorted->count = 0;
    fast_begin_visibility(tile);
    fast_turn_to(tile, FAST_RASTER);
    draw_bins(tile, pass, number);
    flush_draw(tile);
    fast_flush_visibility(tile);
}

static void draw_pass(Tile *tile, const FastPass *pass, uint32_t number)
{
    const bool touched = is_touched(pass, number);
    const bool sorts = pass->pass->order != GP_ORDER_SUBMITTED;
    const bool may_be_even = touched && pass->draw_count == 1 && pass->draws[0].is_even;
    fast_begin_pass(tile, pass, touched && !may_be_even);
    if (!touched || (may_be_even && fast_draw_even(tile, pass)))
        return;
    if (may_be_even)
        fast_begin_pass(tile, pass, true);
    if (sorts)
        fast_begin_fragments(tile);
    do
        draw_slice(tile, pass, number);
    while (sorts && fast_end_slice(tile));
    fast_turn_to(tile, FAST_TRANSFER);
}

/* Where nothing is drawn, the surfaces are cleared in place. */
static void clear_tile(const Tile *tile, const FastGroup *group)
{
    const FastBox box = { tile->x0, tile->y0, tile->x0 + tile->width - 1,
                          tile->y0 + tile->height - 1 };
    for (uint32_t p = 0; p < group->pass_count; p++)
        if (group->passes[p].clears)
            fast_clear_box(group->passes[p].pass, &box, true);
}

/* What one worker needs: the tile, and the memory of its stages. What most draws use comes first:
 * of four targets no more than a large page of it is touched, by the worker itself. */
struct FastTileMemory {
    Tile tile;
    FastShaderBlock block;
    FastQueue queue;
    FastVisibility visibility;
    FastHierarchicalDepth hierarchical_depth;
    FastSortedTriangles sorted;
    FastFragments fragments;
    FastRepeated repeated;
    FastRecords records;
    FastTileSlots slots;
    FastLaneRuns lane_runs;
    FastSums sums;
};

static void begin_tile(FastTileMemory *memory, const FastGroup *group, uint32_t number)
{
    const FastPass *pass = &group->passes[0];
    Tile *tile = &memory->tile;
    tile->x0 = pass->window.x0 + (int32_t)(number % pass->tiles_x) * FAST_TILE;
    tile->y0 = pass->window.y0 + (int32_t)(number / pass->tiles_x) * FAST_TILE;
    int32_t width = pass->window.x1 - tile->x0, height = pass->window.y1 - tile->y0;
    tile->width = width < FAST_TILE ? width : FAST_TILE;
    tile->height = height < FAST_TILE ? height : FAST_TILE;
    tile->slots = &memory->slots;
    tile->records = &memory->records;
    tile->block = &memory->block;
    tile->lane_runs = &memory->lane_runs;
    tile->sums = &memory->sums;
    tile->queue = &memory->queue;
    tile->visibility = &memory->visibility;
    tile->hierarchical_depth = &memory->hierarchical_depth;
    tile->sorted = &memory->sorted;
    tile->fragments = &memory->fragments;
    tile->repeated = &memory->repeated;
    tile->timed = group->timed;
    if (tile->timed)
        tile->mark = fast_clock_ms();
    tile->phase = FAST_TRANSFER;
}

static void draw_tile(const FastGroup *group, uint32_t number, FastTileMemory *memory)
{
    Tile *tile = &memory->tile;
    begin_tile(memory, group, number);
    bool touched = false;
    for (uint32_t p = 0; p < group->pass_count && !touched; p++)
        touched = is_touched(&group->passes[p], number);
    if (!touched) {
        clear_tile(tile, group);
        return;
    }
    fast_begin_slots(tile, &group->slots);
    fast_begin_repeated(tile);
    tile->is_group_whole = group->is_whole;
    for (uint32_t p = 0; p < group->pass_count; p++) {
        prefetch_bins(group, p + 1, number);
        draw_pass(tile, &group->passes[p], number);
    }
    fast_store_slots(tile);
    fast_turn_to(tile, FAST_TRANSFER);
}

static size_t tile_bytes(void)
{
    return sizeof(FastTileMemory);
}

static size_t least_fragment_bytes(void)
{
    const size_t sorted = fast_least_fragment_bytes(), repeated = fast_least_repeated_bytes();
    return sorted > repeated ? sorted : repeated;
}

static void give_fragments(FastTileMemory *memory, void *room, size_t bytes)
{
    memory->fragments.memory = memory->repeated.memory = room;
    memory->fragments.bytes = memory->repeated.bytes = bytes;
}

static void start_counting(FastTileMemory *memory)
{
    memory->fragments.sorted = memory->fragments.slices = 0;
    memory->tile.fragments_shaded = 0;
    memset(memory->tile.times, 0, sizeof memory->tile.times);
}

static void add_counts(const FastTileMemory *memory, GpCounters *counters, GpPhases *phases)
{
    counters->fragments_shaded += memory->tile.fragments_shaded;
    counters->fragments_sorted += memory->fragments.sorted;
    counters->sorted_slices += memory->fragments.slices;
    phases->raster += memory->tile.times[FAST_RASTER];
    phases->shading += memory->tile.times[FAST_SHADING];
    phases->transfer += memory->tile.times[FAST_TRANSFER];
}

#define STAGES_PASTE_(lanes) fast_stages##lanes
#define STAGES_PASTE(lanes)  STAGES_PASTE_(lanes)

const FastStages STAGES_PASTE(GP_LANES) = {
    .lanes = GP_LANES,
    .read_indices = gp_read_indices,
    .shade_vertices = fast_shade_vertices,
    .bin_range = fast_bin_range,
    .draw_tile = draw_tile,
    .tile_bytes = tile_bytes,
    .least_fragment_bytes = least_fragment_bytes,
    .give_fragments = give_fragments,
    .start_counting = start_counting,
    .add_counts = add_counts,
};
