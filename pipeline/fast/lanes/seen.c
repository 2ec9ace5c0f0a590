/* What is seen: after the last opaque draw, every pixel that shows a record is shaded, once. */
#include "pipeline/fast/lanes/mix.h"
#include "pipeline/fast/lanes/patch.h"

#include <string.h>

/* A part of the tile in which most pixels are the draw's goes through the shader as it is. */
enum { DENSE = GP_LANES * 5 / 8 };

/* --- what waits for the shader ------------------------------------------------------------------ */

/* Blocks that fill up with what is seen of one draw. */
typedef struct Collector {
    Tile *tile;
    const FastDraw *d;
    int patches;    /* of one triangle each */
    int mixes;      /* of several */
    FastMix packed; /* one that fills up with what is sparse, and how far it has */
    int lanes;
} Collector;

static void shade_collected_mixes(Collector *c)
{
    if (c->mixes)
        FAST(shade_mixes)(c->tile, c->d, c->tile->mixes, c->mixes);
    c->mixes = 0;
}

static void add_mix(Collector *c, FastMix mix)
{
    c->tile->mixes[c->mixes] = mix;
    if (++c->mixes == FAST_BLOCK)
        shade_collected_mixes(c);
}

static void add_packed(Collector *c)
{
    if (c->lanes)
        add_mix(c, c->packed);
    c->lanes = 0;
}

static void pack_pixel(Collector *c, uint32_t record, int32_t x, int32_t y, bool live)
{
    if (c->lanes == 0) /* lanes that stay empty repeat the first */
        c->packed = (FastMix){
            .record = itg_set((int32_t)record), .x = itg_set(x), .y = itg_set(y), .packed = true
        };
    c->packed.record[c->lanes] = (int32_t)record;
    c->packed.x[c->lanes] = x;
    c->packed.y[c->lanes] = y;
    c->packed.live |= (unsigned)live << c->lanes;
    if (++c->lanes == GP_LANES)
        add_packed(c);
}

static void shade_collected_patches(Collector *c)
{
    if (c->patches)
        FAST(shade_patches)(c->tile, c->d, c->tile->patches, c->patches, NULL);
    c->patches = 0;
}

/* The queue of ordered draws is empty here: its room serves. */
static void add_patch(Collector *c, FastPatch patch)
{
    c->tile->patches[c->patches++] = patch;
    if (c->patches == FAST_BLOCK)
        shade_collected_patches(c);
}

/* --- collecting --------------------------------------------------------------------------------- */

static void collect_row(Collector *c, const FastPatch *row, itg seen, msk mine)
{
    unsigned live = msk_bits(mine);
    uint32_t some = c->tile->seen[fast_at(row->x + __builtin_ctz(live), row->y)];
    if (msk_bits(seen == (int32_t)some) == ALL_LANES)
        add_patch(c, (FastPatch){ some, ALL_LANES, row->x, row->y, .wide = GP_LANES });
    else if (__builtin_popcount(live) >= DENSE)
        add_mix(c, (FastMix){ .record = itg_select(mine, seen, itg_set((int32_t)some)),
                              .x = patch_x(row),
                              .y = patch_y(row),
                              .live = live });
    else
        for (; live; live &= live - 1) {
            int32_t x = row->x + __builtin_ctz(live);
            pack_pixel(c, c->tile->seen[fast_at(x, row->y)], x, row->y, true);
        }
}

/* In every lane the greatest of its quad. */
static itg quad_greatest(itg a)
{
    a = itg_greater(a, GP_QUAD_SHUFFLE(a, 1, 0, 3, 2));
    return itg_greater(a, GP_QUAD_SHUFFLE(a, 2, 3, 0, 1));
}

static void pack_quads(Collector *c, const FastMix *mix)
{
    for (int quad = 0; quad < GP_LANES; quad += 4)
        for (int lane = quad; lane < quad + 4 && (mix->live >> quad & 15); lane++)
            pack_pixel(c, (uint32_t)mix->record[lane], mix->x[lane], mix->y[lane],
                       mix->live >> lane & 1);
}

/* Whole quads, for shaders that look at their neighbours: a quad is shaded once for every triangle
 * that is seen in it. */
static void collect_quads(Collector *c, const FastPatch *quads, itg seen, msk mine)
{
    if (msk_bits(mine & (seen == seen[0])) == ALL_LANES) {
        add_patch(c, (FastPatch){ (uint32_t)seen[0], ALL_LANES, quads->x, quads->y, .wide = 0 });
        return;
    }
    const itg some = itg_set(seen[__builtin_ctz(msk_bits(mine))]);
    FastMix mix = { .x = patch_x(quads), .y = patch_y(quads), .quads = true };
    for (itg left = seen & mine; msk_bits(left != 0); left &= ~mine) {
        itg record = quad_greatest(left);
        mine = (left == record) & (left != 0);
        mix.live = msk_bits(mine);
        mix.record = itg_select(record != 0, record, some);
        if (__builtin_popcount(msk_bits(record != 0)) >= DENSE)
            add_mix(c, mix);
        else
            pack_quads(c, &mix);
    }
}

static void collect_seen(Collector *c, uint32_t first, uint32_t end)
{
    const Tile *tile = c->tile;
    const bool quads = c->d->needs.quads;
    const int wide = quads ? QUADS_WIDE : GP_LANES, high = quads ? 2 : 1;
    for (int32_t y = 0; y < tile->height; y += high)
        for (int32_t x = 0; x < tile->width; x += wide) {
            const FastPatch part = { .x = (uint8_t)x,
                                     .y = (uint8_t)y,
                                     .wide = quads ? 0 : GP_LANES };
            itg seen = load_patch(tile->seen, &part);
            msk mine = (seen >= (int32_t)first) & (seen < (int32_t)end);
            if (!msk_bits(mine))
                continue;
            if (quads)
                collect_quads(c, &part, seen, mine);
            else
                collect_row(c, &part, seen, mine);
        }
}

void FAST(flush_seen)(Tile *tile)
{
    bool shown = false;
    FastPhase before = fast_turn_to(tile, FAST_SHADING);
    FAST(settle_backdrop)(tile);
    for (uint32_t i = 0; i < tile->run_count; i++) {
        uint32_t first = tile->runs[i].first_record;
        uint32_t end =
            i + 1 < tile->run_count ? tile->runs[i + 1].first_record : tile->record_count;
        Collector collector = { .tile = tile, .d = &tile->pass->draws[tile->runs[i].draw] };
        if (first == end || collector.d->route != FAST_VISIBLE)
            continue;
        shown = true;
        collect_seen(&collector, first, end);
        add_packed(&collector);
        shade_collected_mixes(&collector);
        shade_collected_patches(&collector);
    }
    if (shown)
        memset(tile->seen, 0, sizeof tile->seen);
    tile->record_count = FAST_NO_RECORD + 1;
    tile->run_count = tile->wide_count = 0;
    fast_turn_to(tile, before);
}
