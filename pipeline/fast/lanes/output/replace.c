/* Blending after the ternary depth test: as ever, but that a packet some of whose fragments replace
 * is the first of a run, before which the targets under these are cleared. Few are: a pixel is
 * replaced some times, and added to many. */
#include "pipeline/fast/lanes/output/replace.h"

#include "pipeline/fast/lanes/output/blend.h"
#include "pipeline/fast/lanes/output/quantize.h"

/* As gp_output_clear, in one plane. */
static void clear_words(void *plane, uint32_t kept, const FastPacket *packet, unsigned lanes)
{
    itg words = itg_set(0);
    if (kept)
        words = load_packet(plane, packet) & (int32_t)kept;
    store_packet(plane, packet, lanes, words);
}

static void clear_target(FastPlanes *planes, GpFormat format, const GpBlend *blend,
                         const FastPacket *packet, unsigned lanes)
{
    if (fast_is_packed(format)) {
        clear_words(planes->packed, kept_bits(blend), packet, lanes);
        return;
    }
    for (int c = 0; c < gp_format_info(format)->channels; c++)
        if (!(blend->keep >> c & 1))
            clear_words(planes->channel[c], 0, packet, lanes);
}

static void clear_replaced(Tile *tile, const FastDraw *d, const FastPacket *packet, unsigned lanes)
{
    const int written = gp_program_targets(d->draw->program);
    for (int t = 0; t < written && t < tile->targets; t++)
        clear_target(tile->planes[t], d->pass->color[t].surface->format, &d->blend[t], packet,
                     lanes);
}

void fast_replace_packets(Tile *tile, const FastDraw *d, const FastShaded *shaded)
{
    const FastPacketBlock *block = &shaded->block;
    for (int first = 0, end; first < block->count; first = end) {
        if (shaded->replaced[first])
            clear_replaced(tile, d, &block->packets[first], shaded->replaced[first]);
        for (end = first + 1; end < block->count && !shaded->replaced[end];)
            end++;
        FastShaded run = *shaded;
        run.block.packets += first;
        run.block.count = end - first;
        run.live += first;
        run.color += first * shaded->stride;
        fast_blend_packets(tile, d, &run);
    }
}
