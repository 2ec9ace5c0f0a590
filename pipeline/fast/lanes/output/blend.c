/* Blending and write masks of GP_LANES pixels inside the tile. */
#include "pipeline/fast/lanes/output/blend.h"

#include "pipeline/fast/lanes/output/blend_add.h"
#include "pipeline/fast/lanes/output/blend_bits.h"
#include "pipeline/fast/lanes/output/blend_lanes.h"
#include "pipeline/fast/lanes/output/quantize.h"

#include <string.h>

/* --- targets ---------------------------------------------------------------------------------- */

/* Shaded packets on their way into one target. Whole ones are rows with all lanes alive. */
typedef struct BlendBlock {
    const FastPacket *packets;
    const FastGathered *gathered; /* of the same numbers */
    const unsigned *live;         /* of each packet */
    int count;
    int layers;       /* packets are [layer][pixels]; those of all layers lie on the same pixels */
    const flt *color; /* of the first packet; `stride` vectors further the next */
    int stride;
    float constant[4]; /* as the target clamps it */
    uint32_t filled;   /* bits of a word that every store sets: X8R8G8B8's unused byte */
    FastPlanes *planes;
} BlendBlock;

/* The place of a packet's first pixel. */
GP_INLINE uint32_t place_of(const BlendBlock *m, int p)
{
    return fast_at(m->packets[p].x, m->packets[p].y);
}

/* How a packet lies in its target. */
typedef enum Shape {
    SHAPE_WHOLE, /* a row that lives in all lanes */
    SHAPE_ROW,
    SHAPE_ANY,
} Shape;

GP_INLINE bool is_row(const FastPacket *packet)
{
    return packet->wide == GP_LANES && !packet->gathered;
}

GP_INLINE itg load_pixels(const BlendBlock *m, Shape shape, int p, uint32_t at, const void *plane)
{
    if (shape != SHAPE_ANY)
        return load_lanes((const uint32_t *)plane + at, false);
    if (m->packets[p].gathered)
        return itg_gather(plane, gathered_at(&m->gathered[p]) * 4);
    return load_packet(plane, &m->packets[p]);
}

GP_INLINE void store_pixels(const BlendBlock *m, Shape shape, int p, uint32_t at, void *plane,
                            itg words)
{
    uint32_t *row = (uint32_t *)plane + at;
    if (shape == SHAPE_ROW)
        words = itg_select(mask_of(m->live[p]), words, load_lanes(row, false));
    if (shape != SHAPE_ANY) {
        store_lanes(row, false, words);
        return;
    }
    if (!m->packets[p].gathered) {
        store_packet(plane, &m->packets[p], m->live[p], words);
        return;
    }
    const itg to = gathered_at(&m->gathered[p]);
    for (unsigned live = m->live[p]; live; live &= live - 1) {
        const int lane = __builtin_ctz(live);
        ((uint32_t *)plane)[to[lane]] = (uint32_t)words[lane];
    }
}

/* Zeros that are added leave an 8-bit target's codes as they are: each is what its value is stored
 * as. */
GP_INLINE bool adds_nothing(const GpBlend *blend, const flt color[4])
{
    if (blend->op != GP_BLEND_ADD || blend->src != GP_ONE || blend->dst != GP_ONE ||
        blend->alpha_op != GP_BLEND_OFF)
        return false;
    itg bits = (itg)color[0] | (itg)color[1] | (itg)color[2] | (itg)color[3];
    return !msk_any((msk)(bits != 0));
}

GP_INLINE void blend_word(const GpBlend *blend, const BlendBlock *m, Shape shape, int p,
                          const flt color[4])
{
    const uint32_t kept = kept_bits(blend), at = place_of(m, p);
    itg before = itg_set(0), word;
    if (blend->op != GP_BLEND_OFF || kept)
        before = load_pixels(m, shape, p, at, m->planes->packed);
    if (blend->op != GP_BLEND_OFF) {
        Operands o;
        flt result[4];
        memcpy(o.constant, m->constant, sizeof o.constant);
        o.halves = false;
        GP_UNROLL
        for (int c = 0; c < 4; c++)
            o.source[c] = clamped(color[c]);
        colors_of(before, o.target);
        GP_UNROLL
        for (int c = 0; c < 4; c++)
            result[c] = blend_channel(blend, c, &o); /* from -1 to 2: needs no clamping */
        word = word_of(result);
    } else
        word = word_of_any(color);
    if (kept)
        word = (word & (int32_t)~kept) | (before & (int32_t)kept);
    store_pixels(m, shape, p, at, m->planes->packed, word | (int32_t)m->filled);
}

GP_INLINE void blend_words(const GpBlend *blend, const BlendBlock *from, bool whole)
{
    const BlendBlock copy = *from, *m = &copy; /* which no store can change */
    const flt *color = m->color;
    for (int p = 0; p < m->count; p++, color += m->stride) {
        if ((!whole && !m->live[p]) || (!m->filled && adds_nothing(blend, color)))
            continue;
        if (whole)
            blend_word(blend, m, SHAPE_WHOLE, p, color);
        else if (is_row(&m->packets[p]))
            blend_word(blend, m, SHAPE_ROW, p, color);
        else
            blend_word(blend, m, SHAPE_ANY, p, color);
    }
}

/* --- formats that are not packed -------------------------------------------------------------- */

/* Channels that the format lacks read 1. */
GP_INLINE void load_target(const BlendBlock *m, GpFormat format, Shape shape, int p, uint32_t at,
                           flt target[4])
{
    if (fast_is_packed(format)) {
        colors_of(load_pixels(m, shape, p, at, m->planes->packed), target);
        return;
    }
    GP_UNROLL
    for (int c = 0; c < 4; c++)
        target[c] = c < channels_of(format)
                        ? (flt)load_pixels(m, shape, p, at, m->planes->channel[c])
                        : flt_set(1);
}

GP_INLINE void store_target(const BlendBlock *m, const GpBlend *blend, GpFormat format, Shape shape,
                            int p, uint32_t at, const flt target[4])
{
    if (fast_is_packed(format)) {
        store_pixels(m, shape, p, at, m->planes->packed, word_of(target) | (int32_t)m->filled);
        return;
    }
    GP_UNROLL
    for (int c = 0; c < 4; c++)
        if (c < channels_of(format) && !(blend->keep >> c & 1))
            store_pixels(m, shape, p, at, m->planes->channel[c], plane_word(format, target[c]));
}

GP_INLINE void blend_packet(const GpBlend *blend, GpFormat format, const BlendBlock *m, Shape shape,
                            int p, const flt color[4])
{
    flt target[4] = { flt_set(0), flt_set(0), flt_set(0), flt_set(0) };
    const uint32_t at = place_of(m, p);
    if (blend->op != GP_BLEND_OFF)
        load_target(m, format, shape, p, at, target);
    blend_stored(blend, format, m->constant, color, target);
    store_target(m, blend, format, shape, p, at, target);
}

GP_INLINE void blend_channels(const GpBlend *blend, GpFormat format, const BlendBlock *from,
                              bool whole)
{
    const BlendBlock copy = *from, *m = &copy;
    const flt *color = m->color;
    for (int p = 0; p < m->count; p++, color += m->stride) {
        if (whole)
            blend_packet(blend, format, m, SHAPE_WHOLE, p, color);
        else if (!m->live[p])
            continue;
        else if (is_row(&m->packets[p]))
            blend_packet(blend, format, m, SHAPE_ROW, p, color);
        else
            blend_packet(blend, format, m, SHAPE_ANY, p, color);
    }
}

/* Several whole layers, of some pixels that stay in registers: one packet's blends are found while
 * another's wait for each other. Mostly colours need no clamping, which is looked for meanwhile.
 * returns false, and leaves the target, where they were not clamped but needed it */
GP_INLINE bool blend_pixels(const GpBlend *blend, GpFormat format, bool clamps, const BlendBlock *m,
                            int first, int count)
{
    const bool looks = !clamps && fast_is_unorm8(format);
    const int next_layer = m->count / m->layers * m->stride;
    const flt *color = m->color + first * m->stride;
    uint32_t at[4];
    flt target[4][4];
    utg most = (utg)itg_set(0);
    GP_UNROLL
    for (int i = 0; i < count; i++) {
        at[i] = place_of(m, first + i);
        load_target(m, format, SHAPE_WHOLE, first + i, at[i], target[i]);
    }
    for (int k = 0; k < m->layers; k++, color += next_layer) {
        GP_UNROLL
        for (int i = 0; i < count; i++) {
            const flt *of = color + i * m->stride;
            if (looks)
                most = greater_bits(most, greatest_bits(of));
            blend_clamped(blend, format, clamps, m->constant, of, target[i]);
        }
    }
    if (looks && msk_any((msk)(most > ONE_BITS)))
        return false;
    GP_UNROLL
    for (int i = 0; i < count; i++)
        store_target(m, blend, format, SHAPE_WHOLE, first + i, at[i], target[i]);
    return true;
}

GP_INLINE void blend_layers(const GpBlend *blend, GpFormat format, const BlendBlock *from)
{
    const BlendBlock copy = *from, *m = &copy;
    const bool tries =
        blend == &over && GP_LANES > 4; /* four lanes have no instruction that looks */
    const int pixels = m->count / m->layers;
    enum { TOGETHER = 4 }; /* by twos halves take 2 to 4 % more */
    int p = 0;
    while (tries && p + TOGETHER <= pixels && blend_pixels(blend, format, false, m, p, TOGETHER))
        p += TOGETHER;
    for (; p + TOGETHER <= pixels; p += TOGETHER)
        blend_pixels(blend, format, fast_is_unorm8(format), m, p, TOGETHER);
    for (; p < pixels; p++)
        blend_pixels(blend, format, fast_is_unorm8(format), m, p, 1);
}

/* --- targets of any format -------------------------------------------------------------------- */

/* The blends of nearly all draws, beside those of blend_lanes.h. */
static const GpBlend replace = { .op = GP_BLEND_OFF };
static const GpBlend add = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
static const GpBlend under = { .op = GP_BLEND_ADD, .src = GP_INV_DEST_ALPHA, .dst = GP_ONE };
static const GpBlend most = { .op = GP_BLEND_MAX };
static const GpBlend through = { .op = GP_BLEND_ADD,
                                 .src = GP_DEST_ALPHA,
                                 .dst = GP_ONE,
                                 .alpha_op = GP_BLEND_ADD,
                                 .alpha_src = GP_ZERO,
                                 .alpha_dst = GP_SRC_ALPHA };

/* The same code for any blend, and for each of those that are common. */
GP_INLINE void blend_words_by(const GpBlend *blend, const BlendBlock *m, bool whole)
{
    const bool layers = whole && m->layers > 1 && fast_blends_layers(blend);
    if (layers && is_blend(blend, &over))
        blend_layers(&over, GP_A8R8G8B8, m);
    else if (layers)
        blend_layers(blend, GP_A8R8G8B8, m);
    else if (is_blend(blend, &replace))
        blend_words(&replace, m, whole);
    else if (is_blend(blend, &add))
        blend_words(&add, m, whole);
    else if (is_blend(blend, &over))
        blend_words(&over, m, whole);
    else if (is_blend(blend, &under))
        blend_words(&under, m, whole);
    else
        blend_words(blend, m, whole);
}

GP_INLINE void blend_channels_of(const GpBlend *blend, GpFormat format, const BlendBlock *m,
                                 bool whole)
{
    if (whole && m->layers > 1 && fast_blends_layers(blend))
        blend_layers(blend, format, m);
    else
        blend_channels(blend, format, m, whole);
}

/* What peeled layers are drawn and put together by, one layer at a time: an eighth of the time of
 * peeling and of dual peeling, and a fifth of that of convex pieces with AVX2.
 * returns whether it was one of these */
GP_INLINE bool blend_peeled_of(const GpBlend *blend, GpFormat format, const BlendBlock *m,
                               bool whole)
{
    if (is_blend(blend, &replace))
        blend_channels(&replace, format, m, whole);
    else if (is_blend(blend, &through))
        blend_channels(&through, format, m, whole);
    else if (is_blend(blend, &in_front))
        blend_channels(&in_front, format, m, whole);
    else if (is_blend(blend, &most))
        blend_channels(&most, format, m, whole);
    else if (is_blend(blend, &over_multiplied))
        blend_channels(&over_multiplied, format, m, whole);
    else
        return false;
    return true;
}

/* The same of the formats that layers have. */
GP_INLINE bool blend_peeled(const GpBlend *blend, GpFormat format, const BlendBlock *m, bool whole)
{
    if (format == GP_A16B16G16R16F)
        return blend_peeled_of(blend, GP_A16B16G16R16F, m, whole);
    if (format == GP_A32B32G32R32F)
        return blend_peeled_of(blend, GP_A32B32G32R32F, m, whole);
    return format == GP_R32F && blend_peeled_of(blend, GP_R32F, m, whole);
}

GP_INLINE void blend_channels_by(const GpBlend *blend, GpFormat format, const BlendBlock *m,
                                 bool whole)
{
    if (m->layers <= 1 && blend_peeled(blend, format, m, whole))
        return;
    if (format == GP_A16B16G16R16F && is_blend(blend, &add))
        blend_channels_of(&add, GP_A16B16G16R16F, m, whole);
    else if (format == GP_A16B16G16R16F && is_blend(blend, &under))
        blend_channels_of(&under, GP_A16B16G16R16F, m, whole);
    else if (format == GP_A32B32G32R32F && is_blend(blend, &add))
        blend_channels_of(&add, GP_A32B32G32R32F, m, whole);
    else
        blend_channels_of(blend, format, m, whole);
}

GP_INLINE void blend_by(const GpBlend *blend, GpFormat format, const BlendBlock *m, bool whole)
{
    if (fast_is_packed(format))
        blend_words_by(blend, m, whole);
    else
        blend_channels_by(blend, format, m, whole);
}

/* The same code for any packets, and for whole ones, which need neither masks nor shapes. */
static void blend_target(const GpBlend *blend, GpFormat format, const BlendBlock *m, bool whole)
{
    if (whole)
        blend_by(blend, format, m, true);
    else
        blend_by(blend, format, m, false);
}

static bool are_whole(const FastPacket *packets, const unsigned *live, int count)
{
    unsigned other = 0; /* without branches: mostly all are, or the first is not */
    for (int p = 0; p < count; p++)
        other |= (live[p] ^ ALL_LANES) | (packets[p].wide ^ GP_LANES) | packets[p].gathered;
    return !other;
}

void fast_blend_packets(Tile *tile, const FastDraw *d, const FastShaded *shaded)
{
    const FastPacketBlock *block = &shaded->block;
    const int written = gp_program_targets(d->draw->program);
    if (d->only_adds && d->packs_points) {
        fast_add_packets(tile, d, shaded);
        return;
    }
    const bool whole = block->whole || are_whole(block->packets, shaded->live, block->count);
    BlendBlock m = { .packets = block->packets,
                     .gathered = block->gathered,
                     .live = shaded->live,
                     .count = block->count,
                     .layers = block->layers,
                     .stride = shaded->stride };
    for (int t = 0; t < written && t < tile->targets; t++) {
        GpFormat format = d->pass->color[t].surface->format;
        m.color = shaded->color + 4 * t;
        m.planes = tile->planes[t];
        const GpBlend *blend = &d->blend[t];
        m.filled = (blend->keep & 15) != 15 ? fast_filled_bits(format) : 0;
        if (fast_is_bitwise(blend, format)) {
            fast_blend_bits(blend, m.planes, shaded, m.color);
            continue;
        }
        set_constant(&d->draw->state, format, m.constant);
        blend_target(blend, format, &m, whole);
    }
}
