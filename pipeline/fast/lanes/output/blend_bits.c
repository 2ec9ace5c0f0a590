/* Logical blends of A8R8G8B8: a colour becomes a word once, and words are combined. Bits that change
 * nothing stand where a lane is dead or a channel is kept, so that none of it needs a mask. */
#include "pipeline/fast/lanes/memory/packet.h"
#include "pipeline/fast/lanes/output/quantize.h"

#include <string.h>

/* Packets on their way into one target. */
typedef struct Bits {
    uint32_t *plane;
    const FastPacket *packets;
    const FastGathered *gathered;
    const unsigned *live;
    int count;
    const flt *color;
    int stride;
    uint32_t written; /* bits of the word that are not kept */
} Bits;

GP_INLINE uint32_t combine(GpBlendOp op, uint32_t a, uint32_t b)
{
    return op == GP_BLEND_LOGIC_AND ? a & b : op == GP_BLEND_LOGIC_OR ? a | b : a ^ b;
}

GP_INLINE itg combine_lanes(GpBlendOp op, itg a, itg b)
{
    return op == GP_BLEND_LOGIC_AND ? a & b : op == GP_BLEND_LOGIC_OR ? a | b : a ^ b;
}

/* One word after the other: a pixel may come again. */
GP_INLINE void blend_gathered(GpBlendOp op, uint32_t *plane, itg at, itg words)
{
    uint32_t place[GP_LANES], word[GP_LANES];
    memcpy(place, &at, sizeof place);
    memcpy(word, &words, sizeof word);
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        plane[place[lane]] = combine(op, plane[place[lane]], word[lane]);
}

GP_INLINE void blend_all(GpBlendOp op, const Bits *bits)
{
    const Bits copy = *bits, *b = &copy; /* which no store can change */
    const itg neutral = itg_set(op == GP_BLEND_LOGIC_AND ? -1 : 0);
    const flt *color = b->color;
    for (int p = 0; p < b->count; p++, color += b->stride) {
        const msk changed = mask_of(b->live[p]) & (int32_t)b->written;
        const itg words = itg_select(changed, word_of_any(color), neutral);
        if (!msk_any((msk)(words != neutral)))
            continue;
        const FastPacket *packet = &b->packets[p];
        if (packet->gathered)
            blend_gathered(op, b->plane, b->gathered[p].at, words);
        else
            store_packet(b->plane, packet, ALL_LANES,
                         combine_lanes(op, load_packet(b->plane, packet), words));
    }
}

/* Bits of a word in channels that are not kept. */
static uint32_t written_bits(const GpBlend *blend)
{
    static const uint32_t bytes[4] = { 0xff0000, 0xff00, 0xff, 0xff000000 };
    uint32_t written = 0;
    for (int c = 0; c < 4; c++)
        written |= blend->keep >> c & 1 ? 0 : bytes[c];
    return written;
}

void fast_blend_bits(const Tile *tile, const GpBlend *blend, FastPlanes *planes,
                     const FastPacket *packets, const unsigned *live, int count, const flt *color,
                     int stride)
{
    const Bits bits = { planes->packed, packets, tile->gathered, live,
                        count,          color,   stride,         written_bits(blend) };
    if (blend->op == GP_BLEND_LOGIC_AND)
        blend_all(GP_BLEND_LOGIC_AND, &bits);
    else if (blend->op == GP_BLEND_LOGIC_OR)
        blend_all(GP_BLEND_LOGIC_OR, &bits);
    else
        blend_all(GP_BLEND_LOGIC_XOR, &bits);
}

/* --- words as they are ---------------------------------------------------------------------------- */

GP_INLINE void copy_box(GpBlendOp op, const FastBox *box, const uint32_t *from, uint32_t written,
                        uint32_t *to)
{
    const itg neutral = itg_set(op == GP_BLEND_LOGIC_AND ? -1 : 0);
    for (int32_t y = box->y0; y <= box->y1; y++)
        for (int32_t x = box->x0; x <= box->x1; x += GP_LANES) {
            const uint32_t at = fast_at(x, y);
            const msk changed = (msk)(lane_numbers() <= box->x1 - x) & (int32_t)written;
            const itg words = itg_select(changed, load_lanes(from + at, false), neutral);
            store_lanes(to + at, false, combine_lanes(op, load_lanes(to + at, false), words));
        }
}

bool fast_copy_layers(Tile *tile, const FastDraw *draw)
{
    const int slot = draw->copied_slot - 1;
    const GpBlend *blend = &draw->draw->state.blend[0];
    const FastBox *box = &tile->layer_box;
    const uint32_t written = written_bits(blend);
    uint32_t *to = tile->planes[0]->packed;
    fast_begin_fetch(tile, draw->draw->textures, slot);
    const uint32_t *from = tile->fetch[slot].plane[0];
    if (tile->fetch[slot].format == GP_FORMAT_NONE || !from)
        return false;
    for (uint32_t layer = 0; layer < tile->layer_count; layer++)
        if (blend->op == GP_BLEND_LOGIC_AND)
            copy_box(GP_BLEND_LOGIC_AND, box, from, written, to);
        else if (blend->op == GP_BLEND_LOGIC_OR)
            copy_box(GP_BLEND_LOGIC_OR, box, from, written, to);
        else
            copy_box(GP_BLEND_LOGIC_XOR, box, from, written, to);
    tile->fragments_shaded +=
        (uint64_t)(box->x1 - box->x0 + 1) * (uint64_t)(box->y1 - box->y0 + 1) * tile->layer_count;
    return true;
}
