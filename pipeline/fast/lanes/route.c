/* The routes of fragments: seen, queued for the shader, or only tested. */
#include "pipeline/fast/lanes/route.h"

static void add_packet(Tile *tile, const FastRecord *record, int32_t x, int32_t y, unsigned live,
                       flt depth)
{
    uint64_t pixels = (uint64_t)live << x; /* bits past the tile are never live */
    if (tile->packet_count == FAST_BLOCK || (tile->pending[y] & pixels))
        FAST(flush_packets)(tile);
    tile->pending[y] |= pixels;
    FastPacket *packet = &tile->packets[tile->packet_count++];
    packet->record[0] = record;
    packet->uniform = packet->row = true;
    packet->live = live;
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++) {
        packet->x[lane] = (uint8_t)(x + lane);
        packet->y[lane] = (uint8_t)y;
        packet->depth[lane] = depth[lane];
    }
}

/* The same for the quads of two rows: the lower bits of `live` are the upper row's. Lanes are quads
 * side by side, from an even x on. */
void FAST(queue_quads)(Tile *tile, const FastRecord *record, int32_t x, int32_t y,
                       const unsigned live[2], const flt depth[2])
{
    enum { WIDE = GP_LANES / 2 }; /* pixels across a packet of quads */
    for (int part = 0; part < 2; part++) {
        int32_t left = x + part * WIDE;
        unsigned row[2];
        for (int i = 0; i < 2; i++)
            row[i] = live[i] >> (part * WIDE) & ((1u << WIDE) - 1);
        if (!(row[0] | row[1]))
            continue;
        if (tile->packet_count == FAST_BLOCK || (tile->pending[y] & (uint64_t)row[0] << left) ||
            (tile->pending[y + 1] & (uint64_t)row[1] << left))
            FAST(flush_packets)(tile);
        tile->pending[y] |= (uint64_t)row[0] << left;
        tile->pending[y + 1] |= (uint64_t)row[1] << left;
        FastPacket *packet = &tile->packets[tile->packet_count++];
        packet->record[0] = record;
        packet->uniform = true;
        packet->row = false;
        packet->live = 0;
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++) {
            int column = lane / 4 * 2 + lane % 2, lower = lane % 4 / 2;
            packet->x[lane] = (uint8_t)(left + column);
            packet->y[lane] = (uint8_t)(y + lower);
            packet->live |= (row[lower] >> column & 1) << lane;
            packet->depth[lane] = depth[lower][part * WIDE + column];
        }
    }
}

static void see(Tile *tile, uint32_t at, unsigned live, uint32_t record)
{
    itg before; /* anywhere in a row: not aligned to a vector */
    __builtin_memcpy(&before, tile->seen + at, sizeof before);
    before = itg_select(mask_of(live), itg_set((int32_t)record), before);
    __builtin_memcpy(tile->seen + at, &before, sizeof before);
}

void FAST(reserve_records)(Tile *tile, uint32_t count)
{
    bool new_run = !tile->run_count || tile->runs[tile->run_count - 1].draw != tile->draw_number;
    if (tile->record_count + count > FAST_RECORDS || tile->wide_count + count > FAST_WIDES ||
        (new_run && tile->run_count == FAST_RUNS)) {
        FAST(flush_packets)(tile);
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
        add_packet(tile, &tile->records[f->number], x, y, live, z);
    return live;
}
