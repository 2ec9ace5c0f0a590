/* Logical blends of A8R8G8B8: a colour becomes a word once, and words are combined. Bits that
 * change nothing stand where a lane is dead or a channel is kept, so that none of it needs a
 * mask. */
#include "pipeline/fast/lanes/output/blend_bits.h"

#include "pipeline/fast/lanes/output/quantize.h"

#include <string.h>

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

GP_INLINE void blend_all(GpBlendOp op, uint32_t *plane, const FastShaded *shaded, const flt *color,
                         uint32_t written)
{
    const FastShaded copy = *shaded, *s = &copy; /* which no store can change */
    const itg neutral = itg_set(op == GP_BLEND_LOGIC_AND ? -1 : 0);
    for (int p = 0; p < s->block.count; p++, color += s->stride) {
        const msk changed = mask_of(s->live[p]) & (int32_t)written;
        const itg words = itg_select(changed, word_of_any(color), neutral);
        if (!msk_any((msk)(words != neutral)))
            continue;
        const FastPacket *packet = &s->block.packets[p];
        if (packet->gathered)
            blend_gathered(op, plane, gathered_at(&s->block.gathered[p]), words);
        else
            store_packet(plane, packet, ALL_LANES,
                         combine_lanes(op, load_packet(plane, packet), words));
    }
}

void fast_blend_bits(const GpBlend *blend, FastPlanes *planes, const FastShaded *shaded,
                     const flt *color)
{
    const uint32_t written = ~kept_bits(blend);
    if (blend->op == GP_BLEND_LOGIC_AND)
        blend_all(GP_BLEND_LOGIC_AND, planes->packed, shaded, color, written);
    else if (blend->op == GP_BLEND_LOGIC_OR)
        blend_all(GP_BLEND_LOGIC_OR, planes->packed, shaded, color, written);
    else
        blend_all(GP_BLEND_LOGIC_XOR, planes->packed, shaded, color, written);
}

/* --- words as they are ------------------------------------------------------------------------ */

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

void fast_copy_words(const GpBlend *blend, const FastBox *box, const uint32_t *from, uint32_t *to)
{
    const uint32_t written = ~kept_bits(blend);
    if (blend->op == GP_BLEND_LOGIC_AND)
        copy_box(GP_BLEND_LOGIC_AND, box, from, written, to);
    else if (blend->op == GP_BLEND_LOGIC_OR)
        copy_box(GP_BLEND_LOGIC_OR, box, from, written, to);
    else
        copy_box(GP_BLEND_LOGIC_XOR, box, from, written, to);
}
