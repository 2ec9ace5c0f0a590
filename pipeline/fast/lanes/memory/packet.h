/* Fragment packets: GP_LANES fragments on their way, and the words of a plane under them. */
#ifndef GP_FAST_PACKET_H
#define GP_FAST_PACKET_H

#include "pipeline/fast/lanes/memory/quads.h"

enum {
    ALL_LANES = (1 << GP_LANES) - 1,
    QUADS_WIDE = GP_LANES / 2,   /* pixels across a packet of quads */
    FAST_BLOCK = 512 / GP_LANES, /* packets of one call of a shader */
    FAST_MOST = 2 * FAST_BLOCK,  /* of layers, where their inputs take no room (layers.h) */
    PLACE_Y = 16,
};

/* GP_LANES pixels of one triangle or point: a row, or two rows as 2x2 quads side by side, whose
 * lanes 4q..4q+3 are top left, top right, bottom left, bottom right; or packed, the short rows of a
 * sprite's box one after the other. Pixels past the tile are never live. */
typedef struct FastPacket {
    uint32_t record;
    uint32_t live;     /* bit i: lane i; the others stand by as helpers */
    uint32_t replaced; /* of the live: by an early ternary test */
    uint8_t x, y;      /* of the first lane, in the tile */
    uint8_t wide;      /* pixels a row, up to GP_LANES; 0: quads */
    bool gathered;     /* pixels of several triangles: see the gathered packet of the same number */
} FastPacket;

/* GP_LANES pixels of one draw, each of a triangle or point of its own, from anywhere in the tile.
 * Lanes that are not live have some record of the draw too. */
typedef struct FastGathered {
    itg record;
    itg place; /* x | y << PLACE_Y, in the tile. Of points one pixel may be there several times */
    uint32_t live;
    bool is_row; /* of neighbours, which are all live */
} FastGathered;

/* Packets of one draw that are shaded together. */
typedef struct FastPacketBlock {
    const FastPacket *packets;    /* NULL: all are gathered */
    const FastGathered *gathered; /* of the same numbers */
    const float *depths; /* [packet][lane], where tests come late or fragments are sorted */
    const float *in;     /* [packet][component][lane]; NULL: where the shader block has them */
    const GpInterpolants *interpolants; /* of each layer, in place of inputs; or NULL */
    int count;
    int layers; /* packets are [layer][pixels], all layers on the same pixels; 0: no layers */
    bool whole; /* every packet is known to be a row that lives in all lanes, to the end */
} FastPacketBlock;

/* Field by field: a packet put together elsewhere would be stored in bytes and copied in words, for
 * which a processor must wait. */
GP_INLINE void set_packet(FastPacket *packet, uint32_t record, int32_t x, int32_t y, unsigned live,
                          int32_t wide)
{
    packet->record = record;
    packet->live = live;
    packet->replaced = 0;
    packet->x = (uint8_t)x;
    packet->y = (uint8_t)y;
    packet->wide = (uint8_t)wide;
    packet->gathered = false;
}

/* Row of each lane where rows are `wide` pixels: lane / wide. Times 256 / wide and a bit more is
 * the same up to lane 15. */
GP_INLINE itg lane_row(int32_t wide)
{
    static const uint16_t reciprocal[17] = { 0,  257, 129, 86, 65, 52, 43, 37, 33,
                                             29, 26,  24,  22, 20, 19, 18, 17 };
    return lane_numbers() * reciprocal[wide] >> 8;
}

/* Of each lane, from the packet's first pixel; `wide` as in FastPacket. Most are whole rows. */
GP_INLINE itg packet_columns(int32_t wide)
{
    if (!wide || wide == GP_LANES)
        return lane_columns(!wide);
    return lane_numbers() - lane_row(wide) * wide;
}

GP_INLINE itg packet_rows(int32_t wide)
{
    if (!wide || wide == GP_LANES)
        return lane_rows(!wide);
    return lane_row(wide);
}

GP_INLINE itg packet_x(const FastPacket *packet)
{
    return packet->x + packet_columns(packet->wide);
}

GP_INLINE itg packet_y(const FastPacket *packet)
{
    return packet->y + packet_rows(packet->wide);
}

/* Where the lanes of a gathered packet are: their pixels, and these in a plane. */
GP_INLINE itg gathered_x(const FastGathered *gathered)
{
    return gathered->place & ((1 << PLACE_Y) - 1);
}

GP_INLINE itg gathered_y(const FastGathered *gathered)
{
    return gathered->place >> PLACE_Y;
}

GP_INLINE itg gathered_at(const FastGathered *gathered)
{
    return itg_dot2(gathered->place, itg_set(1 | FAST_PITCH << PLACE_Y));
}

/* Where the lanes of packet p are. */
GP_INLINE itg block_x(const FastPacketBlock *block, int p)
{
    const bool placed = block->packets && !block->packets[p].gathered;
    return placed ? packet_x(&block->packets[p]) : gathered_x(&block->gathered[p]);
}

GP_INLINE itg block_y(const FastPacketBlock *block, int p)
{
    const bool placed = block->packets && !block->packets[p].gathered;
    return placed ? packet_y(&block->packets[p]) : gathered_y(&block->gathered[p]);
}

/* Whether row r of a packet of rows has pixels that live. */
GP_INLINE bool has_row(const FastPacket *packet, int r)
{
    return r * packet->wide < GP_LANES && packet->live >> r * packet->wide;
}

/* Runs of a gathered packet's lanes, whose pixels are neighbours in a row: bit i where one begins
 * at lane i. */
GP_INLINE unsigned run_starts(itg at)
{
    return msk_bits((msk)(at - itg_shift_in(at, 0) != 1)) | 1;
}

/* Takes away the first run; returns its lanes.
 * out  first: lane at which it begins */
GP_INLINE unsigned take_run(unsigned *starts, int *first)
{
    const unsigned begin = *starts & -*starts;
    *first = __builtin_ctz(*starts);
    *starts -= begin;
    return (*starts ? *starts & -*starts : 1u << GP_LANES) - begin;
}

/* The words of a plane under a packet; of its pixels that live, at least. Row r of a packet of rows
 * is found in its lanes when the load starts so many lanes further left. */
GP_INLINE itg load_packet(const void *plane, const FastPacket *packet)
{
    const uint32_t *from = (const uint32_t *)plane + fast_at(packet->x, packet->y);
    itg words = load_lanes(from, !packet->wide);
    if (!packet->wide || packet->wide == GP_LANES)
        return words;
    const itg row = lane_row(packet->wide);
    for (int r = 1; has_row(packet, r); r++) {
        from += FAST_PITCH - packet->wide;
        words = itg_select((msk)(row == r), load_lanes(from, false), words);
    }
    return words;
}

GP_INLINE void store_packet(void *plane, const FastPacket *packet, unsigned live, itg words)
{
    uint32_t *to = (uint32_t *)plane + fast_at(packet->x, packet->y);
    if (!packet->wide || packet->wide == GP_LANES) {
        if (live != ALL_LANES)
            words = itg_select(mask_of(live), words, load_lanes(to, !packet->wide));
        store_lanes(to, !packet->wide, words);
        return;
    }
    const itg row = lane_row(packet->wide), alive = mask_of(live);
    for (int r = 0; has_row(packet, r); r++, to += FAST_PITCH - packet->wide)
        store_lanes(to, false, itg_select((msk)(row == r) & alive, words, load_lanes(to, false)));
}

#endif
