#include "pipeline/fast/lanes/shade/queue.h"

#include "pipeline/fast/lanes/shade/one_color.h"
#include "pipeline/fast/lanes/shade/packets.h"
#include "pipeline/fast/lanes/shade/repeated.h"

FastPacket *fast_new_packet(Tile *tile)
{
    FastQueue *q = tile->queue;
    if (q->count == FAST_BLOCK || q->layers.count)
        fast_flush_packets(tile);
    return &q->packets[q->count++];
}

static FastPacket *queue(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live,
                         int32_t wide, flt depth)
{
    FastPacket *packet = fast_new_packet(tile);
    set_packet(packet, record, x, y, live, wide);
    if (tile->draw->late_depth || tile->draw->sorted)
        flt_store(tile->queue->depths + (packet - tile->queue->packets) * GP_LANES, depth);
    return packet;
}

FastPacket *fast_queue_row(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live,
                           flt depth)
{
    return queue(tile, record, x, y, live, GP_LANES, depth);
}

FastPacket *fast_queue_quads(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live,
                             flt depth)
{
    return queue(tile, record, x, y, live, 0, depth);
}

static bool is_same_box(const FastBox *a, const FastBox *b)
{
    return a->x0 == b->x0 && a->y0 == b->y0 && a->x1 == b->x1 && a->y1 == b->y1;
}

void fast_queue_box(Tile *tile, uint32_t record, const FastBox *box)
{
    FastLayers *layers = &tile->queue->layers;
    const bool fits = layers->count < FAST_LAYERS && is_same_box(&layers->box, box);
    if (tile->queue->count || (layers->count && !fits))
        fast_flush_packets(tile);
    layers->box = *box;
    layers->record[layers->count++] = record;
}

void fast_flush_packets(Tile *tile)
{
    FastQueue *q = tile->queue;
    if (fast_queue_is_empty(tile))
        return;
    const FastPacketBlock block = {
        .packets = q->packets, .gathered = q->gathered, .depths = q->depths, .count = (int)q->count
    };
    if (q->colors) {
        fast_find_colors(tile);
        return;
    }
    FastPhase before = fast_turn_to(tile, FAST_SHADING);
    if (q->layers.count)
        fast_shade_layers(tile, &q->layers, q->packets);
    else if (tile->draw->draw->geometry.primitive == GP_POINTS) /* come with their inputs */
        fast_shade_inputs(tile, tile->draw, &block);
    else if (tile->repeated->finds)
        fast_keep_repeated(tile, &block);
    else
        fast_shade_packets(tile, tile->draw, &block);
    q->count = q->layers.count = 0;
    fast_turn_to(tile, before);
}
