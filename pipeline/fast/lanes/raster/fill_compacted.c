/* Triangles of a few pixels that are shaded in order, without depth: their pixels, compacted, side
 * by side in gathered packets. A pixel is at most once in a packet, so that what blends with it
 * comes
 * in a later one. */
#include "pipeline/fast/lanes/raster/fill.h"

/* The gathered packet at the end of the queue. */
typedef struct Compaction {
    Tile *tile;
    FastPacket *packet; /* NULL: none yet */
    FastGathered *gathered;
    int count;
    itg place; /* as the gathered packet's own, which is written lane by lane */
} Compaction;

/* The last gathered packet may have room; the triangles of a gathered packet face one way. */
static Compaction last_gathered(Tile *tile)
{
    Compaction compaction = { .tile = tile };
    FastPacket *last = tile->queue->count ? &tile->queue->packets[tile->queue->count - 1] : NULL;
    if (!last || !last->gathered)
        return compaction;
    compaction.packet = last;
    compaction.gathered = &tile->queue->gathered[tile->queue->count - 1];
    compaction.count = __builtin_popcount(last->live);
    compaction.place = compaction.gathered->place;
    return compaction;
}

/* What is left over at the end repeats a live triangle, outside the tile. */
static void begin_gathered(Compaction *compaction, uint32_t record)
{
    Tile *tile = compaction->tile;
    compaction->packet = fast_new_packet(tile);
    *compaction->packet =
        (FastPacket){ .record = record, .y = FAST_TILE, .wide = GP_LANES, .gathered = true };
    compaction->gathered = &tile->queue->gathered[compaction->packet - tile->queue->packets];
    compaction->count = 0;
    compaction->place = itg_set(FAST_TILE << PLACE_Y);
    *compaction->gathered =
        (FastGathered){ .record = itg_set((int32_t)record), .place = compaction->place };
}

GP_INLINE void add_pixel(Compaction *compaction, uint32_t record, int32_t place)
{
    if (!compaction->packet || compaction->count == GP_LANES || msk_any(compaction->place == place))
        begin_gathered(compaction, record);
    FastGathered *gathered = compaction->gathered;
    const int lane = compaction->count++;
    compaction->place =
        itg_select((msk)(lane_numbers() == lane), itg_set(place), compaction->place);
    ((int32_t *)&gathered->record)[lane] = (int32_t)record;
    ((int32_t *)&gathered->place)[lane] = place;
    gathered->live = compaction->packet->live = (1u << compaction->count) - 1;
}

void fast_fill_compacted(const Filler *f, const TriangleBatch *b, unsigned lanes)
{
    Tile *tile = f->tile;
    Compaction compaction = last_gathered(tile);
    for (unsigned left = lanes & msk_bits((msk)(b->covered != 0)); left; left &= left - 1) {
        const uint32_t lane = (uint32_t)__builtin_ctz(left), number = tile->records->count++;
        fast_write_record(f->d, b, lane, &tile->records->record[number]);
        if (compaction.packet && tile->records->record[compaction.packet->record].face !=
                                     tile->records->record[number].face)
            compaction.packet = NULL;
        const int32_t first = b->x[lane] | b->y[lane] << PLACE_Y;
        for (uint32_t pixels = (uint32_t)b->covered[lane]; pixels; pixels &= pixels - 1) {
            const int32_t bit = __builtin_ctz(pixels);
            add_pixel(&compaction, number, first + (bit & 3) + (bit >> 2 << PLACE_Y));
        }
    }
}
