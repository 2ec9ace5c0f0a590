/* Packets through the shader, the tests that had to wait for it, and into the targets. */
#include "pipeline/fast/lanes/shade/packets.h"

#include "pipeline/fast/lanes/output/blend.h"
#include "pipeline/fast/lanes/output/depth.h"
#include "pipeline/fast/lanes/output/replace.h"
#include "pipeline/fast/lanes/shade/interpolate_packets.h"
#include "pipeline/fast/lanes/shade/pixel_shader.h"
#include "pipeline/fast/lanes/shade/records.h"

static msk compare_lanes(GpCompare test, flt a, float b)
{
    msk less = (msk)(a < b), equal = (msk)(a == b), greater = (msk)(a > b);
    msk accepted = accepted_lanes(test, less, equal, greater);
    if (gp_compare_accepts(test, GP_IS_UNORDERED))
        accepted |= ~(less | equal | greater);
    return accepted;
}

/* Lanes of shaded packet p that pass the tests which had to wait; those of them that replace. */
static unsigned late_tests(Tile *tile, const FastDraw *d, const FastPacket *packet, int p,
                           const float *depth, unsigned *replaced)
{
    const GpAlphaTest *alpha = &d->draw->state.alpha_test;
    const int targets = gp_program_targets(d->draw->program);
    unsigned live = packet->live;
    if (d->draw->program->may_discard)
        live &= ~msk_bits(
            (msk)flt_load((const float *)(const void *)tile->block->killed + p * GP_LANES));
    if (d->needs.alpha_test)
        live &= msk_bits(compare_lanes(
            alpha->test, flt_load(tile->block->color + (p * targets * 4 + 3) * GP_LANES),
            gp_float_from_unorm(alpha->reference, 8)));
    if (d->late_depth && live) {
        const bool by_shader = d->draw->program->writes_depth;
        flt z = flt_load((by_shader ? tile->block->shader_depth : depth) + p * GP_LANES);
        live = fast_test_packet(tile, d, packet, tile->records->record[packet->record].face > 0,
                                live, z, replaced);
    }
    return live;
}

void fast_shade_inputs(Tile *tile, const FastDraw *d, const FastPacketBlock *block)
{
    unsigned live[FAST_BLOCK], replaced[FAST_BLOCK];
    fast_run_pixel_shader(tile, d, block);
    const bool late = d->draw->program->may_discard || d->needs.alpha_test || d->late_depth;
    uint32_t fragments = 0;
    for (int p = 0; p < block->count; p++) {
        fragments += (uint32_t)__builtin_popcount(block->packets[p].live);
        replaced[p] = block->packets[p].replaced;
        live[p] = late ? late_tests(tile, d, &block->packets[p], p, block->depths, &replaced[p])
                       : block->packets[p].live;
    }
    tile->fragments_shaded += fragments;
    const FastShaded shaded = { .block = *block,
                                .live = live,
                                .replaced = replaced,
                                .color = fast_colors(tile),
                                .stride = 4 * gp_program_targets(d->draw->program) };
    if (d->needs.color && d->needs.ternary)
        fast_replace_packets(tile, d, &shaded);
    else if (d->needs.color)
        fast_blend_packets(tile, d, &shaded);
}

void fast_shade_packets(Tile *tile, const FastDraw *d, const FastPacketBlock *block)
{
    fast_interpolate_packets(tile, d, block, fast_inputs(tile));
    fast_shade_inputs(tile, d, block);
}
