/* After the last opaque draw, every pixel that shows a record is shaded, once: rows of one triangle
 * as packets, all else as gathered packets of pixels of any triangles. */
#include "pipeline/fast/lanes/shade/visibility.h"

#include "pipeline/fast/lanes/shade/gathered.h"
#include "pipeline/fast/lanes/shade/layers.h"
#include "pipeline/fast/lanes/shade/packets.h"
#include "pipeline/fast/lanes/shade/queue.h"

#include <string.h>

enum {
    /* gathered packets: all that they go through fits into a core's first cache */
    TOGETHER = FAST_BLOCK / 2,
    SPARSE = TOGETHER * GP_LANES,

    CELL_HIGH = 2, /* cells are GP_LANES pixels wide: two rows, or two packets of quads */
    CELLS_ACROSS = FAST_TILE / GP_LANES,
};

/* --- what waits for the shader ---------------------------------------------------------------- */

/* Blocks that fill up with what is visible of one draw. */
typedef struct Collector {
    Tile *tile;
    const FastDraw *d;
    int packets;  /* of one triangle each */
    int gathered; /* of several */

    /* pixels of sparse parts, to be packed; their places, and perhaps DEAD */
    uint32_t sparse;
    _Alignas(64) uint32_t record[SPARSE + GP_LANES], place[SPARSE + GP_LANES];
} Collector;

static const int32_t DEAD = INT32_MIN;

static void shade_collected_gathered(Collector *c)
{
    if (c->gathered)
        fast_shade_gathered(c->tile, c->d, c->tile->queue->gathered, c->gathered);
    c->gathered = 0;
}

/* Field by field, as set_packet. */
static void add_gathered(Collector *c, itg record, itg place, bool is_row)
{
    if (c->gathered == TOGETHER)
        shade_collected_gathered(c);
    FastGathered *gathered = &c->tile->queue->gathered[c->gathered++];
    gathered->record = record;
    gathered->place = place & ~DEAD;
    gathered->live = msk_bits(~(place >> 31));
    gathered->is_row = is_row;
}

/* All that were packed, but those too few for one more packet. */
static void add_all_packed(Collector *c)
{
    uint32_t at = 0;
    for (; at + GP_LANES <= c->sparse; at += GP_LANES)
        add_gathered(c, load_lanes(c->record + at, false), load_lanes(c->place + at, false), false);
    c->sparse -= at;
    memcpy(c->record, c->record + at, sizeof(itg));
    memcpy(c->place, c->place + at, sizeof(itg));
}

/* The last packet too, whose lanes that stay empty repeat the first. */
static void end_packed(Collector *c)
{
    if (!c->sparse)
        return;
    store_lanes(c->record + c->sparse, false, itg_set((int32_t)c->record[0]));
    store_lanes(c->place + c->sparse, false, itg_set((int32_t)c->place[0] | DEAD));
    c->sparse += GP_LANES - 1;
    add_all_packed(c);
}

/* Many at a time become packets: whether one is full would be asked of each, and hard to
 * foresee. */
static void pack(Collector *c, unsigned lanes, itg record, itg place)
{
    itg_compress(c->record + c->sparse, lanes, record);
    itg_compress(c->place + c->sparse, lanes, place);
    c->sparse += (uint32_t)__builtin_popcount(lanes);
    if (c->sparse > SPARSE - GP_LANES)
        add_all_packed(c);
}

static void shade_collected_packets(Collector *c)
{
    if (c->packets)
        fast_shade_packets(
            c->tile, c->d,
            &(FastPacketBlock){ .packets = c->tile->queue->packets, .count = c->packets });
    c->packets = 0;
}

/* The queue of ordered draws is empty here: its room serves. */
static void add_packet(Collector *c, uint32_t record, const FastPacket *place)
{
    if (c->packets == FAST_BLOCK)
        shade_collected_packets(c);
    set_packet(&c->tile->queue->packets[c->packets++], record, place->x, place->y, ALL_LANES,
               place->wide);
}

/* --- collecting ------------------------------------------------------------------------------- */

/* Rows of several triangles go as they are: behind four targets pixels on their own take 22 %
 * more. */
static void collect_row(Collector *c, const FastPacket *row, itg shown, msk mine)
{
    const unsigned live = msk_bits(mine);
    const itg place = packet_x(row) | packet_y(row) << PLACE_Y;
    if (live != ALL_LANES)
        pack(c, live, shown, place);
    else if (msk_bits(shown == shown[0]) == ALL_LANES)
        add_packet(c, (uint32_t)shown[0], row);
    else
        add_gathered(c, shown, place, true);
}

/* In every lane the greatest of its quad. */
static itg quad_greatest(itg a)
{
    a = itg_greater(a, GP_QUAD_SHUFFLE(a, 1, 0, 3, 2));
    return itg_greater(a, GP_QUAD_SHUFFLE(a, 2, 3, 0, 1));
}

/* Quads stay together: there are whole ones only. */
static void pack_quads(Collector *c, itg record, itg place, unsigned live)
{
    unsigned any = (live | live >> 1 | live >> 2 | live >> 3) & 0x1111;
    pack(c, any * 15, record, place | (~mask_of(live) & DEAD));
}

/* Whole quads, for shaders that look at their neighbours: a quad is shaded once for every triangle
 * that is visible in it. */
static void collect_quads(Collector *c, const FastPacket *quads, itg shown, msk mine)
{
    if (msk_bits(mine & (shown == shown[0])) == ALL_LANES) {
        add_packet(c, (uint32_t)shown[0], quads);
        return;
    }
    const itg place = packet_x(quads) | packet_y(quads) << PLACE_Y;
    for (itg left = shown & mine; msk_bits(left != 0); left &= ~mine) {
        const itg record = quad_greatest(left);
        mine = (left == record) & (left != 0);
        pack_quads(c, record, place, msk_bits(mine));
    }
}

/* --- runs ------------------------------------------------------------------------------------- */

static uint32_t run_end(const Tile *tile, uint32_t run)
{
    const FastVisibility *v = tile->visibility;
    return run + 1 < v->run_count ? v->runs[run + 1].first_record : tile->records->count;
}

static void number_records(Tile *tile)
{
    FastVisibility *v = tile->visibility;
    memset(v->run_of, 0, tile->records->count * sizeof *v->run_of);
    for (uint32_t run = 1; run < v->run_count; run++)
        for (uint32_t record = v->runs[run].first_record; record < run_end(tile, run); record++)
            v->run_of[record] = (uint16_t)run;
    for (uint32_t run = 0; run < v->run_count; run++)
        v->runs[run].cells = 0;
}

/* Lanes that do not show a record from first to end. */
GP_INLINE itg without(itg shown, int32_t first, int32_t end)
{
    return shown & ((shown < first) | (shown >= end));
}

/* Adds a cell to every run that it shows. */
static uint16_t sort_cell(Tile *tile, int32_t x, int32_t y, uint16_t count)
{
    FastVisibility *v = tile->visibility;
    const uint32_t *row[CELL_HIGH] = { v->record + fast_at(x, y), v->record + fast_at(x, y + 1) };
    itg upper = load_lanes(row[0], false), lower = load_lanes(row[1], false);
    for (;;) {
        const unsigned up = msk_bits(upper != 0), down = msk_bits(lower != 0);
        if (!(up | down))
            return count;
        const uint32_t record = up ? row[0][__builtin_ctz(up)] : row[1][__builtin_ctz(down)];
        const uint32_t run = v->run_of[record];
        v->cells[++count].x = (uint8_t)x;
        v->cells[count].y = (uint8_t)y;
        v->cells[count].next = v->runs[run].cells;
        v->runs[run].cells = count;
        const int32_t first = (int32_t)v->runs[run].first_record;
        const int32_t end = (int32_t)run_end(tile, run);
        upper = without(upper, first, end);
        lower = without(lower, first, end);
    }
}

/* In one scan of the tile, however many runs there are. The last cell comes first: lists grow at
 * their front. */
static void sort_cells(Tile *tile)
{
    uint16_t count = 0;
    const int32_t rows = (tile->height + CELL_HIGH - 1) / CELL_HIGH;
    for (int32_t cell = rows * CELLS_ACROSS; cell-- > 0;)
        count =
            sort_cell(tile, cell % CELLS_ACROSS * GP_LANES, cell / CELLS_ACROSS * CELL_HIGH, count);
}

static void collect_part(Collector *c, const FastPacket *part, uint32_t run)
{
    const Tile *tile = c->tile;
    const FastVisibility *v = tile->visibility;
    itg shown = load_packet(v->record, part);
    msk mine =
        (shown >= (int32_t)v->runs[run].first_record) & (shown < (int32_t)run_end(tile, run));
    if (!msk_bits(mine))
        return;
    if (part->wide)
        collect_row(c, part, shown, mine);
    else
        collect_quads(c, part, shown, mine);
}

static void shade_run(Tile *tile, uint32_t run)
{
    const FastVisibility *v = tile->visibility;
    Collector c; /* the lists are not cleared */
    c.tile = tile;
    c.d = &tile->pass->draws[v->runs[run].draw];
    c.packets = c.gathered = 0;
    c.sparse = 0;
    const bool quads = c.d->needs.quads;
    const int across = quads ? QUADS_WIDE : 0, down = quads ? 0 : 1;
    for (uint32_t at = v->runs[run].cells; at; at = v->cells[at].next)
        for (int i = 0; i < 2; i++) {
            FastPacket part = { .x = (uint8_t)(v->cells[at].x + i * across),
                                .y = (uint8_t)(v->cells[at].y + i * down),
                                .wide = quads ? 0 : GP_LANES };
            collect_part(&c, &part, run);
        }
    end_packed(&c);
    shade_collected_gathered(&c);
    shade_collected_packets(&c);
}

static bool is_visible(const Tile *tile, uint32_t run)
{
    return tile->pass->draws[tile->visibility->runs[run].draw].path == FAST_VISIBLE;
}

/* Brings the records up to date with the full-tile occluder. */
static void settle_occluder(Tile *tile)
{
    FastVisibility *v = tile->visibility;
    if (v->occluder == FAST_NO_RECORD)
        return;
    for (int32_t y = 0; y < tile->height; y++)
        for (int32_t x = 0; x < tile->width; x++) {
            uint32_t *record = &v->record[fast_at(x, y)];
            *record = *record > v->occluder ? *record : v->occluder;
        }
    v->occluder = FAST_NO_RECORD;
}

/* The draw of a record. Later ones may have begun their runs, and left no record in them. */
static const FastDraw *draw_of(const Tile *tile, uint32_t record)
{
    const FastVisibility *v = tile->visibility;
    uint32_t run = v->run_count - 1;
    while (v->runs[run].first_record > record)
        run--;
    return &tile->pass->draws[v->runs[run].draw];
}

/* Where nothing came after the full-tile occluder, the tile is one layer of it, and nobody looks at
 * its records: textured fills take 11 % less. Shaders that look at their neighbours want quads,
 * which layers have not.
 * returns false, and nothing done, where that is not so */
static bool shade_occluder(Tile *tile)
{
    const FastVisibility *v = tile->visibility;
    if (v->occluder == FAST_NO_RECORD || v->occluder + 1 != tile->records->count)
        return false;
    const FastDraw *d = draw_of(tile, v->occluder), *before = tile->draw;
    if (d->needs.quads)
        return false;
    tile->draw = d;
    fast_shade_layers(tile,
                      &(FastLayers){ .count = 1,
                                     .box = { 0, 0, tile->width - 1, tile->height - 1 },
                                     .record = { v->occluder } },
                      tile->queue->packets);
    tile->draw = before;
    return true;
}

static void shade_runs(Tile *tile)
{
    settle_occluder(tile);
    number_records(tile);
    sort_cells(tile);
    for (uint32_t run = 0; run < tile->visibility->run_count; run++)
        if (tile->visibility->runs[run].cells)
            shade_run(tile, run);
}

void fast_flush_visibility(Tile *tile)
{
    FastVisibility *v = tile->visibility;
    FastPhase before = fast_turn_to(tile, FAST_SHADING);
    bool any = false;
    for (uint32_t run = 0; run < v->run_count; run++)
        any |= is_visible(tile, run);
    if (any) {
        if (!shade_occluder(tile))
            shade_runs(tile);
        /* no pixel has a record where the occluder was the first to come, and all: fills take 3 to
         * 7 % less */
        if (v->occluder != FAST_NO_RECORD + 1)
            memset(v->record, 0, sizeof v->record);
    }
    fast_begin_visibility(tile);
    fast_turn_to(tile, before);
}

void fast_begin_visibility(Tile *tile)
{
    fast_forget_records(tile->records);
    tile->visibility->run_count = 0;
    tile->visibility->occluder = FAST_NO_RECORD;
}

void fast_reserve_records(Tile *tile, uint32_t count)
{
    FastVisibility *v = tile->visibility;
    FastRecords *records = tile->records;
    /* an ordered draw's records are done with once its packets are shaded */
    if (tile->draw->path == FAST_ORDERED && fast_queue_is_empty(tile))
        fast_forget_records(records);
    bool new_run = !v->run_count || v->runs[v->run_count - 1].draw != tile->draw_number;
    if (records->count + count > FAST_RECORDS || records->edges64_count + count > FAST_EDGES64 ||
        (new_run && v->run_count == FAST_RUNS)) {
        fast_flush_packets(tile);
        fast_flush_visibility(tile);
        new_run = true;
    }
    if (new_run) {
        v->runs[v->run_count].first_record = records->count;
        v->runs[v->run_count++].draw = tile->draw_number;
    }
}
