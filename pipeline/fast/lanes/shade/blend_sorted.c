#include "pipeline/fast/lanes/shade/blend_sorted.h"

#include "pipeline/fast/lanes/memory/convert.h"
#include "pipeline/fast/lanes/output/blend.h"
#include "pipeline/fast/lanes/output/blend_lanes.h"
#include "pipeline/fast/lanes/output/depth.h"
#include "pipeline/fast/lanes/output/replace.h"
#include "pipeline/units/fragment_order.h"

/* Layers from which on a network may pay. */
enum { LEAST_OF_NETWORK = 24 };

/* The lists of GP_LANES pixels of a row, side by side. */
typedef struct Column {
    int32_t x, y; /* of the first pixel */
    itg waiting;  /* of each */
    int32_t most; /* of any of them */
    itg key[UINT8_MAX], shaded[UINT8_MAX];
} Column;

/* Inserts what comes into each list, behind what has its turn before, and behind its equals. */
GP_INLINE void insert(Column *column, int32_t layer, itg key, itg shaded)
{
    int32_t to = layer;
    for (; to > 0; to--) {
        const itg before = column->key[to - 1];
        const msk later = (msk)(before > key);
        if (!msk_any(later))
            break;
        const itg number = column->shaded[to - 1];
        column->key[to] = itg_select(later, before, key);
        column->shaded[to] = itg_select(later, number, shaded);
        key = itg_select(later, key, before);
        shaded = itg_select(later, shaded, number);
    }
    column->key[to] = key;
    column->shaded[to] = shaded;
}

/* Past a list's end are keys that have no turn, and numbers behind all others: they come last. */
static void load_column(const FastFragments *f, Column *column)
{
    const uint32_t *key = f->key + fast_at(column->x, column->y);
    const uint32_t *shaded = f->shaded + fast_at(column->x, column->y);
    for (int32_t layer = 0; layer < column->most; layer++) {
        const msk there = (msk)(layer < column->waiting);
        column->key[layer] =
            itg_select(there, load_lanes(key, false), itg_set((int32_t)GP_ORDER_KEY_MOST));
        column->shaded[layer] = itg_select(there, load_lanes(shaded, false), itg_set(INT32_MAX));
        key += FAST_PIXELS;
        shaded += FAST_PIXELS;
    }
}

/* Puts two layers in order: by keys, and of one key as they came, by their numbers. */
GP_INLINE void exchange(Column *column, int32_t first, int32_t second)
{
    const itg key[2] = { column->key[first], column->key[second] };
    const itg number[2] = { column->shaded[first], column->shaded[second] };
    const msk turned =
        (msk)(key[0] > key[1]) | ((msk)(key[0] == key[1]) & (msk)(number[0] > number[1]));
    column->key[first] = itg_select(turned, key[1], key[0]);
    column->key[second] = itg_select(turned, key[0], key[1]);
    column->shaded[first] = itg_select(turned, number[1], number[0]);
    column->shaded[second] = itg_select(turned, number[0], number[1]);
}

/* By a network of n log^2 n / 4 exchanges: Batcher, "Sorting networks and their applications",
 * 1968, for any n as Knuth has it (algorithm 5.2.2 M). */
static void sort_by_network(Column *column)
{
    int32_t most = 1;
    while (most < column->most)
        most *= 2;
    for (int32_t p = most / 2; p > 0; p /= 2)
        for (int32_t q = most / 2, r = 0, d = p;; d = q - p, q /= 2, r = p) {
            for (int32_t i = 0; i < column->most - d; i++)
                if ((i & p) == r)
                    exchange(column, i, i + d);
            if (q == p)
                break;
        }
}

/* Whether so many layers come before those before them that inserting takes its square. */
static bool is_far_from_sorted(const Column *column)
{
    int32_t count = 0;
    for (int32_t layer = 1; layer < column->most; layer++)
        count += msk_any((msk)(column->key[layer] < column->key[layer - 1]));
    return column->most >= LEAST_OF_NETWORK && 3 * count > column->most;
}

static void sort_column(const FastFragments *f, Column *column)
{
    load_column(f, column);
    if (is_far_from_sorted(column))
        sort_by_network(column);
    else
        for (int32_t layer = 1; layer < column->most; layer++)
            insert(column, layer, column->key[layer], column->shaded[layer]);
}

/* --- all of one blend ------------------------------------------------------------------------- */

/* Numbers of what was shaded in a layer; 0 where there is none. */
GP_INLINE void load_layer(const FastFragments *f, const Column *column, int32_t layer, int target,
                          flt color[4])
{
    const itg number = column->shaded[layer] & (itg)(layer < column->waiting);
    itg_gather4((const uint8_t *)(f->color + 4 * target),
                number * (int32_t)(4 * f->targets * sizeof(float)), (itg *)color);
}

/* What a target holds of a column, blended with all layers, in registers. */
GP_INLINE void blend_column(const Tile *tile, const Column *column, int t, const GpBlend *blend,
                            GpFormat format, const float constant[4])
{
    const uint32_t at = fast_at(column->x, column->y);
    const bool packed = fast_is_packed(format);
    const uint32_t filled = fast_filled_bits(tile->pass->pass->color[t].surface->format);
    FastPlanes *planes = tile->planes[t];
    flt target[4];
    if (packed)
        colors_of(load_lanes(planes->packed + at, false), target);
    GP_UNROLL
    for (int c = 0; c < 4 && !packed; c++)
        target[c] = c < channels_of(format) ? flt_load(planes->channel[c] + at) : flt_set(1);
    for (int32_t layer = 0; layer < column->most; layer++) {
        const msk there = (msk)(layer < column->waiting);
        flt color[4], result[4] = { target[0], target[1], target[2], target[3] };
        load_layer(tile->fragments, column, layer, t, color);
        blend_stored(blend, format, constant, color, result);
        GP_UNROLL
        for (int c = 0; c < 4; c++)
            target[c] = flt_select(there, result[c], target[c]);
        if (packed && filled) /* the next layer finds the unused byte as it is stored */
            target[3] = flt_select(there, flt_set(1), target[3]);
    }
    if (packed && (blend->keep & 15) != 15)
        store_lanes(planes->packed + at, false,
                    word_of(target) | ((int32_t)filled & (itg)(column->waiting > 0)));
    const msk written = (msk)(column->waiting > 0);
    GP_UNROLL
    for (int c = 0; c < 4 && !packed; c++)
        if (c < channels_of(format))
            flt_store(planes->channel[c] + at,
                      (flt)itg_select(written, plane_word(format, target[c]), (itg)target[c]));
}

/* Of known formats, the loop has no more than they ask for. */
GP_INLINE void blend_column_of(const Tile *tile, const Column *column, int t, const GpBlend *blend,
                               const float constant[4])
{
    const GpFormat format = tile->pass->pass->color[t].surface->format;
    if (fast_is_packed(format)) /* what fills a word is its own affair */
        blend_column(tile, column, t, blend, GP_A8R8G8B8, constant);
    else if (format == GP_A16B16G16R16F)
        blend_column(tile, column, t, blend, GP_A16B16G16R16F, constant);
    else if (format == GP_A32B32G32R32F)
        blend_column(tile, column, t, blend, GP_A32B32G32R32F, constant);
    else
        blend_column(tile, column, t, blend, format, constant);
}

static void blend_layers(const Tile *tile, const Column *column)
{
    const FastDraw *d = &tile->pass->draws[0];
    const int written = gp_program_targets(d->draw->program);
    for (int t = 0; t < written && t < tile->targets; t++) {
        const GpBlend *blend = &d->blend[t];
        float constant[4];
        set_constant(&d->draw->state, d->pass->color[t].surface->format, constant);
        if (is_blend(blend, &over))
            blend_column_of(tile, column, t, &over, constant);
        else if (is_blend(blend, &over_multiplied))
            blend_column_of(tile, column, t, &over_multiplied, constant);
        else if (is_blend(blend, &in_front))
            blend_column_of(tile, column, t, &in_front, constant);
        else
            blend_column_of(tile, column, t, blend, constant);
    }
}

/* --- of any ----------------------------------------------------------------------------------- */

/* Fragments of one place in their lists and of one source: as a packet. */
static void blend_fragments(Tile *tile, const Column *column, int32_t layer, uint32_t source,
                            unsigned live)
{
    const FastFragments *f = tile->fragments;
    const FastDraw *d = &tile->pass->draws[source / 2];
    const bool tests = d->needs.depth_test || d->needs.depth_write || d->needs.stencil;
    FastPacket packet;
    unsigned replaced = 0;
    set_packet(&packet, 0, column->x, column->y, live, GP_LANES);
    if (d->tests_last && tests) {
        const itg codes = d->pass->order == GP_ORDER_DEPTH_NEAR_FIRST
                              ? column->key[layer]
                              : (int32_t)GP_ORDER_KEY_MOST - column->key[layer];
        live = fast_test_packet(tile, d, &packet, source & 1, live, (flt)codes, &replaced);
    }
    if (!live || !d->needs.color)
        return;
    flt color[GP_MAX_TARGETS * 4];
    const int words = 4 * (int)f->targets;
    const itg number = column->shaded[layer] & mask_of(live);
    for (int t = 0; t < (int)f->targets; t++)
        itg_gather4((const uint8_t *)(f->color + 4 * t), number * (words * (int)sizeof(float)),
                    (itg *)&color[4 * t]);
    const FastShaded shaded = { .block = { .packets = &packet, .count = 1 },
                                .live = &live,
                                .replaced = &replaced,
                                .color = color,
                                .stride = words };
    if (d->needs.ternary)
        fast_replace_packets(tile, d, &shaded);
    else
        fast_blend_packets(tile, d, &shaded);
}

static void blend_layer(Tile *tile, const Column *column, int32_t layer)
{
    const uint32_t *sources = tile->fragments->source;
    const msk there = (msk)(layer < column->waiting);
    const itg number = column->shaded[layer] & there;
    const itg source = itg_gather((const uint8_t *)sources, number * (int)sizeof *sources);
    for (unsigned left = msk_bits(there); left;) {
        const int32_t one = source[__builtin_ctz(left)];
        const unsigned same = left & msk_bits((msk)(source == one));
        blend_fragments(tile, column, layer, (uint32_t)one, same);
        left &= ~same;
    }
}

static bool find_column(const FastFragments *f, Column *column)
{
    column->waiting = load_lanes(f->waiting + fast_at(column->x, column->y), false);
    column->most = 0;
    while (msk_any((msk)(column->waiting > column->most)))
        column->most++;
    return column->most > 0;
}

void fast_blend_sorted(Tile *tile)
{
    FastFragments *f = tile->fragments;
    const FastPhase before_this = fast_turn_to(tile, FAST_SHADING);
    itg sorted = itg_set(0);
    Column column;
    for (column.y = 0; column.y < tile->height; column.y++)
        for (column.x = 0; column.x < tile->width; column.x += GP_LANES) {
            if (!find_column(f, &column))
                continue;
            sorted += column.waiting;
            sort_column(f, &column);
            if (tile->pass->one_blend)
                blend_layers(tile, &column);
            for (int32_t layer = 0; layer < column.most && !tile->pass->one_blend; layer++)
                blend_layer(tile, &column, layer);
        }
    for (int lane = 0; lane < GP_LANES; lane++)
        f->sorted += (uint64_t)sorted[lane];
    fast_turn_to(tile, before_this);
}
