/* Points whose values are the same all over them, and whose fragments combine bits with what was
 * there: those on one pixel may share a packet, since words are blended one by one. The values of
 * GP_LANES points are laid side by side, so that an input of a packet of their fragments is one
 * shuffle.
 *
 * Where a vertex shader makes much of little, its varyings are not kept between the stages:
 * vertices are shaded for their positions first, and once more, for the rest, when their points are
 * drawn.
 * source index-driven vertex shading, as of Arm's Bifrost (2016) */
#include "pipeline/fast/lanes/raster/pack_points.h"

#include "pipeline/fast/lanes/geometry/vertices.h"
#include "pipeline/fast/lanes/shade/queue.h"
#include "pipeline/fast/lanes/shade/shader_block.h"
#include "pipeline/fast/lanes/shade/visibility.h"

#include <string.h>

enum {
    PACKETS = 8, /* of one call of the shader: their inputs stay in the first cache */
    ROOM = 16 * GP_LANES,
    SMALL_BOX = 2 * GP_LANES, /* pixels */
    Y_SHIFT = 8,
    POINT_SHIFT = 16,
    BYTE = 255,
};

/* Fragments of a batch of points: where they are in the tile, and their point's lane. The first
 * follow those that the last packet of the queue has already. */
typedef struct Fragments {
    uint32_t taken, count;
    uint32_t word[ROOM + GP_LANES]; /* x | y << Y_SHIFT | lane << POINT_SHIFT */
} Fragments;

/* --- packets ---------------------------------------------------------------------------------- */

static void begin_fragments(const Tile *tile, Fragments *f)
{
    const uint32_t last =
        tile->queue->count ? tile->queue->packets[tile->queue->count - 1].live : 0;
    f->taken = f->count = (uint32_t)__builtin_popcount(last) % GP_LANES;
    store_lanes(f->word, false, itg_set(0));
}

/* A new packet at the end of the queue. One record serves a block of them: it only tells that
 * points face the eye. */
static void begin_packet(Tile *tile)
{
    if (tile->queue->count == PACKETS)
        fast_flush_packets(tile);
    uint32_t number = tile->queue->packets[0].record;
    if (tile->queue->count == 0) {
        fast_reserve_records(tile, 1);
        number = tile->records->count++;
        tile->records->record[number] = (FastTriangleRecord){ .face = 1.0f, .kind = FAST_SPRITE };
    }
    FastPacket *packet = &tile->queue->packets[tile->queue->count++];
    set_packet(packet, number, 0, FAST_TILE, 0, GP_LANES);
    packet->gathered = true;
}

/* Puts fragments into the lanes of the queue's last packet that `fresh` tells. */
GP_INLINE void fill_packet(Tile *tile, const itg *varying, itg word, msk fresh, bool whole)
{
    const uint32_t at = tile->queue->count - 1;
    const int components = tile->draw->modes.components;
    FastGathered *gathered = &tile->queue->gathered[at];
    const itg x = word & BYTE, y = word >> Y_SHIFT & BYTE, point = word >> POINT_SHIFT;
    gathered->x = whole ? x : itg_select(fresh, x, gathered->x);
    gathered->y = whole ? y : itg_select(fresh, y, gathered->y);
    gathered->at = gathered->y * FAST_PITCH + gathered->x;
    flt *in = fast_inputs(tile) + at * (uint32_t)components;
    for (int c = 0; c < components; c++) {
        const flt value = (flt)itg_permute(varying[c], point);
        in[c] = whole ? value : flt_select(fresh, value, in[c]);
    }
}

/* Moves the fragments into the queue. Lanes that are left over repeat the last of them. */
static void queue_fragments(Tile *tile, const itg *varying, Fragments *f)
{
    if (f->count == f->taken)
        return;
    store_lanes(f->word + f->count, false, itg_set((int32_t)f->word[f->count - 1]));
    for (uint32_t first = 0; first < f->count; first += GP_LANES) {
        const itg word = load_lanes(f->word + first, false);
        if (first || !f->taken) {
            begin_packet(tile);
            fill_packet(tile, varying, word, word, true);
        } else
            fill_packet(tile, varying, word, (msk)(lane_numbers() >= (int32_t)f->taken), false);
        const uint32_t left = f->count - first;
        tile->queue->packets[tile->queue->count - 1].live =
            left < GP_LANES ? (1u << left) - 1 : ALL_LANES;
    }
    begin_fragments(tile, f);
}

/* --- boxes ------------------------------------------------------------------------------------ */

/* Room for a packet's fragments. */
GP_INLINE void make_room(Tile *tile, const itg *varying, Fragments *f)
{
    if (f->count > ROOM - GP_LANES)
        queue_fragments(tile, varying, f);
}

/* Boxes of few pixels, all at once, a fragment of each at a time: combined bits have no order. */
GP_INLINE void add_small(Tile *tile, const itg *varying, Fragments *f, const Sprites *s,
                         unsigned small)
{
    const itg lane = lane_numbers() << POINT_SHIFT, first = s->x0 | lane, last = s->x1 | lane;
    itg x = first, y = s->y0;
    for (; small; small &= msk_bits((msk)(y <= s->y1))) {
        make_room(tile, varying, f);
        itg_compress(f->word + f->count, small, x | y << Y_SHIFT);
        f->count += (uint32_t)__builtin_popcount(small);
        const msk ends = (msk)(x == last);
        x = itg_select(ends, first, x + 1);
        y -= (itg)ends;
    }
}

/* One box, by rows. */
GP_INLINE void add_large(Tile *tile, const itg *varying, Fragments *f, const Sprites *s,
                         int32_t point)
{
    for (int32_t y = s->y0[point]; y <= s->y1[point]; y++)
        for (int32_t x = s->x0[point]; x <= s->x1[point]; x += GP_LANES) {
            const int32_t right = s->x1[point] - x + 1;
            make_room(tile, varying, f);
            store_lanes(f->word + f->count, false,
                        lane_numbers() + (x | y << Y_SHIFT | point << POINT_SHIFT));
            f->count += (uint32_t)(right < GP_LANES ? right : GP_LANES);
        }
}

static void add_boxes(Tile *tile, const itg *varying, const Sprites *s)
{
    const utg pixels = (utg)(s->x1 - s->x0 + 1) * (utg)(s->y1 - s->y0 + 1); /* of those drawn */
    const unsigned small = msk_bits((msk)(pixels <= SMALL_BOX)) & s->drawn;
    Fragments fragments;
    begin_fragments(tile, &fragments);
    add_small(tile, varying, &fragments, s, small);
    for (unsigned large = s->drawn & ~small; large; large &= large - 1)
        add_large(tile, varying, &fragments, s, __builtin_ctz(large));
    queue_fragments(tile, varying, &fragments);
}

/* Component after component of GP_LANES points, side by side. */
static void load_varyings(const FastDraw *d, const uint32_t vertex[GP_LANES], itg *varying)
{
    for (int c = 0; c < d->modes.components; c += 4) {
        const void *record[GP_LANES];
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++)
            record[lane] = d->varyings + (size_t)vertex[lane] * d->stride + c;
        lanes_load4(record, varying + c);
    }
}

void fast_pack_points(Tile *tile, const SpriteBatch *batches, uint32_t count)
{
    const FastDraw *d = tile->draw;
    const uint32_t components = (uint32_t)d->modes.components;
    itg varying[FAST_SPRITE_BATCHES * GP_MAX_VARYINGS];
    uint32_t vertex[FAST_SPRITE_BATCHES][GP_LANES];
    for (uint32_t i = 0; i < count; i++)
        if (d->shades_again)
            memcpy(vertex[i], batches[i].vertex, sizeof vertex[i]);
        else
            load_varyings(d, batches[i].vertex, varying + i * components);
    if (d->shades_again)
        fast_shade_varyings(d, vertex, count, (float *)(void *)varying);
    for (uint32_t i = 0; i < count; i++)
        add_boxes(tile, varying + i * components, &batches[i].at);
}
