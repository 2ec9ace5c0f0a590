/* The queue: packets of the present draw that wait for its shader, in order. */
#ifndef GP_FAST_QUEUE_H
#define GP_FAST_QUEUE_H

#include "pipeline/fast/lanes/shade/layers.h"

enum { FAST_COLORS = FAST_BLOCK * GP_LANES };

typedef struct FastQueue {
    uint32_t count;
    /* triangles that wait for their one colour (one_color.h); then no packets do */
    uint32_t colors;
    uint32_t color_record[FAST_COLORS];
    uint32_t taken;    /* lanes of the last packet that points have filled, while any wait */
    FastLayers layers; /* while any wait, no packets do */
    _Alignas(64) FastPacket packets[FAST_MOST];
    _Alignas(64) float depths[FAST_BLOCK * GP_LANES]; /* of packets whose tests come late */
    _Alignas(64) FastGathered gathered[FAST_BLOCK];
} FastQueue;

/* Room at the end of the queue. */
FastPacket *fast_new_packet(Tile *tile);

/* Queues pixels of an ordered draw for its shader; `live` is not 0, depth matters where tests come
 * late. Records stay in place until their packets are shaded.
 * returns the packet */
FastPacket *fast_queue_row(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live,
                           flt depth);
FastPacket *fast_queue_quads(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live,
                             flt depth);

/* Queues every pixel of a box in the tile, by rows, of an ordered draw without depth. */
void fast_queue_box(Tile *tile, uint32_t record, const FastBox *box);

GP_INLINE bool fast_queue_is_empty(const Tile *tile)
{
    const FastQueue *q = tile->queue;
    return !(q->count | q->layers.count | q->colors);
}

/* Shades what is queued, and blends it in its order. */
void fast_flush_packets(Tile *tile);

#endif
