#include "pipeline/fast/lanes/shade/blend_sorted.h"

#include "pipeline/fast/lanes/memory/convert.h"
#include "pipeline/fast/lanes/output/blend.h"
#include "pipeline/fast/lanes/output/depth.h"
#include "pipeline/fast/lanes/output/replace.h"
#include "pipeline/units/fragment_order.h"

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

/* Past a list's end are keys that have no turn, and stay there: they come last. */
static void sort_column(const FastFragments *f, Column *column)
{
    const uint32_t *key = f->key + fast_at(column->x, column->y);
    const uint32_t *shaded = f->shaded + fast_at(column->x, column->y);
    for (int32_t layer = 0; layer < column->most; layer++) {
        const msk there = (msk)(layer < column->waiting);
        const itg keys =
            itg_select(there, load_lanes(key, false), itg_set((int32_t)GP_ORDER_KEY_MOST));
        insert(column, layer, keys, load_lanes(shaded, false));
        key += FAST_PIXELS;
        shaded += FAST_PIXELS;
    }
}

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

void fast_blend_sorted(Tile *tile)
{
    FastFragments *f = tile->fragments;
    const FastPhase before = fast_turn_to(tile, FAST_SHADING);
    Column column;
    for (column.y = 0; column.y < tile->height; column.y++)
        for (column.x = 0; column.x < tile->width; column.x += GP_LANES) {
            column.waiting = itg_load_bytes(f->waiting + fast_at(column.x, column.y));
            column.most = 0;
            for (int lane = 0; lane < GP_LANES; lane++) {
                f->sorted += (uint64_t)column.waiting[lane];
                column.most =
                    column.waiting[lane] > column.most ? column.waiting[lane] : column.most;
            }
            sort_column(f, &column);
            for (int32_t layer = 0; layer < column.most; layer++)
                blend_layer(tile, &column, layer);
        }
    fast_turn_to(tile, before);
}
