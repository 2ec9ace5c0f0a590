/* Packets through the shader, the tests that had to wait for it, and into the targets. */
#include "pipeline/fast/lanes/shade/packets.h"

#include "pipeline/fast/lanes/output/blend.h"
#include "pipeline/fast/lanes/output/depth.h"
#include "pipeline/fast/lanes/output/replace.h"
#include "pipeline/fast/lanes/shade/fragments.h"
#include "pipeline/fast/lanes/shade/interpolate_packets.h"
#include "pipeline/fast/lanes/shade/pixel_shader.h"
#include "pipeline/fast/lanes/shade/records.h"

#include <string.h>

static msk compare_lanes(GpCompare test, flt a, float b)
{
    msk less = (msk)(a < b), equal = (msk)(a == b), greater = (msk)(a > b);
    msk accepted = accepted_lanes(test, less, equal, greater);
    if (gp_compare_accepts(test, GP_IS_UNORDERED))
        accepted |= ~(less | equal | greater);
    return accepted;
}

/* The nearer depth is stored. */
static bool stores_nearer(const FastDraw *d)
{
    const GpCompare test = d->draw->state.depth.test;
    return (test == GP_LESS || test == GP_LESS_EQUAL) && d->draw->state.depth.write &&
           !d->needs.stencil;
}

/* The usual test of a packet that is a row: fast_test_packet, with less to ask.
 * returns those that pass */
GP_INLINE unsigned test_row(Tile *tile, const FastDraw *d, const FastPacket *packet, unsigned live,
                            flt z)
{
    uint32_t *row = tile->depth + fast_at(packet->x, packet->y);
    const itg stored = load_lanes(row, false), coming = coming_codes(tile, d, z);
    const itg reach = stored + (d->draw->state.depth.test == GP_LESS_EQUAL);
    const msk passed = mask_of(live) & (msk)(coming < reach);
    store_lanes(row, false, itg_select(passed, coming, stored));
    return msk_bits(passed);
}

/* The usual test, or the ternary one, of a run of a packet's lanes, from `at` on.
 * returns those that pass */
GP_INLINE msk test_run(const Tile *tile, const FastDraw *d, uint32_t *at, msk alive, itg coming,
                       msk *replaced)
{
    const int32_t allowance = d->draw->state.depth.test == GP_LESS_EQUAL;
    const itg stored = load_lanes(at, false);
    itg reach = stored;
    *replaced = itg_set(0);
    if (d->needs.ternary) {
        reach = put_back(tile, d, stored);
        *replaced = (msk)(put_back(tile, d, coming) < stored) & alive;
    }
    alive &= (coming - allowance - reach) >> 31;
    store_lanes(at, false, itg_select(alive, itg_lesser(coming, stored), stored));
    return alive;
}

/* Points' fragments, of which several may be on one pixel: run by run; but all at once where no
 * depth comes nearer by the ternary test, as is usual once the nearest have come. */
static unsigned test_gathered(Tile *tile, const FastDraw *d, const FastGathered *gathered,
                              unsigned live, flt z, unsigned *replaced)
{
    const bool usual =
        stores_nearer(d) && !d->needs.shader_depth; /* of the rasterizer, and clamped */
    const itg codes = usual ? depth_codes(tile->depth_format, z) : (itg)z;
    const itg at = gathered_at(gathered);
    uint32_t place[GP_LANES], depth[2 * GP_LANES]; /* codes, or still floats */
    unsigned passed = 0;
    *replaced = 0;
    if (usual && d->needs.ternary) {
        const itg stored = itg_gather((const uint8_t *)tile->depth, at * 4);
        if (!(live & msk_bits((msk)(codes < stored))))
            return live & msk_bits((msk)(codes <= put_back(tile, d, stored)));
    }
    store_lanes(place, false, at);
    store_lanes(depth, false, codes);
    store_lanes(depth + GP_LANES, false, (itg)z);
    for (unsigned starts = run_starts(at); starts;) {
        int first;
        const unsigned lanes = live & take_run(&starts, &first);
        const unsigned run = lanes >> first; /* `first` is known by now */
        if (!run)
            continue;
        const itg coming = load_lanes(depth + first, false);
        msk nearer, alive = mask_of(run);
        if (usual)
            alive = test_run(tile, d, tile->depth + place[first], alive, coming, &nearer);
        else
            alive = fast_test_depth_stencil(tile, d, place[first], false, alive, (flt)coming, true,
                                            &nearer);
        *replaced |= msk_bits(nearer) << first;
        passed |= msk_bits(alive) << first;
    }
    return passed;
}

GP_INLINE const msk *killed_lanes(const Tile *tile)
{
    return (const msk *)(const void *)tile->block->killed;
}

/* Lanes of shaded packet p that pass the tests which had to wait, of those that live; those of them
 * that replace. */
static unsigned late_tests(Tile *tile, const FastDraw *d, const FastPacketBlock *block, int p,
                           unsigned live, unsigned *replaced)
{
    const FastPacket *packet = &block->packets[p];
    const GpAlphaTest *alpha = &d->draw->state.alpha_test;
    const int targets = gp_program_targets(d->draw->program);
    if (d->needs.alpha_test)
        live &= msk_bits(compare_lanes(
            alpha->test, flt_load(tile->block->color + (p * targets * 4 + 3) * GP_LANES),
            gp_float_from_unorm(alpha->reference, 8)));
    if (d->late_depth && !d->tests_last && live) {
        const bool by_shader = d->draw->program->writes_depth;
        flt z = flt_load((by_shader ? tile->block->shader_depth : block->depths) + p * GP_LANES);
        if (d->packs_points)
            return test_gathered(tile, d, &block->gathered[p], live, z, replaced);
        if (packet->wide == GP_LANES && !packet->gathered && stores_nearer(d) && !d->needs.ternary)
            return test_row(tile, d, packet, live, z);
        live = fast_test_packet(tile, d, packet, tile->records->record[packet->record].face > 0,
                                live, z, replaced);
    }
    return live;
}

/* Lanes of a block's shaded packets that pass all tests; those of them that replace. */
static void find_live(Tile *tile, const FastDraw *d, const FastPacketBlock *block,
                      unsigned live[FAST_MOST], unsigned replaced[FAST_MOST])
{
    const bool late = d->needs.alpha_test || d->late_depth;
    const itg *killed = d->draw->program->may_discard ? killed_lanes(tile) : NULL;
    uint32_t fragments = 0;
    for (int p = 0; p < block->count; p++) {
        live[p] = block->packets[p].live;
        replaced[p] = block->packets[p].replaced;
        fragments += (uint32_t)__builtin_popcount(live[p]);
    }
    for (int p = 0; killed && p < block->count; p++)
        live[p] &= ~msk_bits(killed[p]);
    for (int p = 0; late && p < block->count; p++)
        live[p] = late_tests(tile, d, block, p, live[p], &replaced[p]);
    tile->fragments_shaded += fragments;
}

/* The same of whole packets, none of which replaces. */
static const unsigned all_live[FAST_MOST] = { [0 ... FAST_MOST - 1] = ALL_LANES };

void fast_shade_inputs(Tile *tile, const FastDraw *d, const FastPacketBlock *block)
{
    unsigned live[FAST_MOST], replaced[FAST_MOST];
    if (d->needs.pixel_shader)
        fast_run_pixel_shader(tile, d, block);
    if (block->whole)
        tile->fragments_shaded += (uint32_t)block->count * GP_LANES;
    else
        find_live(tile, d, block, live, replaced);
    const FastShaded shaded = { .block = *block,
                                .live = block->whole ? all_live : live,
                                .replaced = replaced,
                                .color = fast_colors(tile),
                                .stride = 4 * gp_program_targets(d->draw->program) };
    if (d->sorted)
        fast_keep_packets(tile, d, &shaded);
    else if (d->needs.color && d->needs.ternary && !d->packs_points)
        fast_replace_packets(tile, d, &shaded);
    else if (d->needs.color)
        fast_blend_packets(tile, d, &shaded);
}

void fast_shade_packets(Tile *tile, const FastDraw *d, const FastPacketBlock *block)
{
    fast_interpolate_packets(tile, d, block, fast_inputs(tile));
    fast_shade_inputs(tile, d, block);
}
