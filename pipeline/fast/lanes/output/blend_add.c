#include "pipeline/fast/lanes/output/blend_add.h"

#include <string.h>

/* --- targets ---------------------------------------------------------------------------------- */

/* Pixels of a row from x on. Channels that the format lacks are 0, and go nowhere. */
GP_INLINE void interleave(const FastPlanes *planes, int channels, uint32_t at, float (*pixel)[4])
{
    itg channel[4];
    for (int c = 0; c < 4; c++)
        channel[c] = c < channels ? (itg)flt_load(planes->channel[c] + at) : itg_set(0);
    lanes_store4(pixel[at], sizeof pixel[at], channel);
}

GP_INLINE void separate(const float (*pixel)[4], int channels, uint32_t at, FastPlanes *planes)
{
    const void *place[GP_LANES];
    itg channel[4];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        place[lane] = pixel[at + (uint32_t)lane];
    lanes_load4(place, channel);
    for (int c = 0; c < channels; c++)
        flt_store(planes->channel[c] + at, (flt)channel[c]);
}

static int channels_of(const Tile *tile, int target)
{
    return gp_format_info(tile->pass->pass->color[target].surface->format)->channels;
}

void fast_begin_sums(Tile *tile, const FastDraw *d)
{
    const int written = gp_program_targets(d->draw->program);
    tile->sums->targets = written < tile->targets ? written : tile->targets;
    for (int t = 0; t < tile->sums->targets; t++)
        for (int32_t y = 0; y < tile->height; y++)
            for (int32_t x = 0; x < tile->width; x += GP_LANES)
                interleave(tile->planes[t], channels_of(tile, t), fast_at(x, y),
                           tile->sums->pixel[t]);
}

void fast_end_sums(Tile *tile)
{
    for (int t = 0; t < tile->sums->targets; t++)
        for (int32_t y = 0; y < tile->height; y++)
            for (int32_t x = 0; x < tile->width; x += GP_LANES)
                separate(tile->sums->pixel[t], channels_of(tile, t), fast_at(x, y),
                         tile->planes[t]);
    tile->sums->targets = 0;
}

/* --- fragments -------------------------------------------------------------------------------- */

/* Where the lanes of a block's packets go: dead ones past the tile, each to a pixel of its own, so that
 * none waits for another. */
static void find_places(const FastShaded *shaded, uint32_t (*place)[GP_LANES])
{
    const itg nowhere = lane_numbers() + (int32_t)fast_at(0, FAST_TILE);
    for (int p = 0; p < shaded->block.count; p++)
        store_lanes(place[p], false,
                    itg_select(mask_of(shaded->live[p]), shaded->block.gathered[p].at, nowhere));
}

/* Of which some replace what there was. */
static void replace_or_add(float (*pixel)[4], bool halves, const uint32_t place[GP_LANES],
                           const float (*more)[4], unsigned replaced)
{
    for (int lane = 0; lane < GP_LANES; lane++) {
        if (replaced >> lane & 1)
            memset(pixel[place[lane]], 0, sizeof pixel[0]);
        fours_add(pixel[place[lane]], more[lane], halves);
    }
}

GP_INLINE void add_all(float (*pixel)[4], bool halves, const FastShaded *shaded,
                       const uint32_t (*place)[GP_LANES], const flt *color)
{
    const int count = shaded->block.count, stride = shaded->stride;
    const unsigned *replaced = shaded->replaced;
    for (int p = 0; p < count; p++, color += stride) {
        _Alignas(64) float more[GP_LANES][4];
        itg channel[4];
        GP_UNROLL
        for (int c = 0; c < 4; c++)
            channel[c] = (itg)color[c];
        lanes_store4(more, sizeof more[0], channel);
        if (replaced[p]) {
            replace_or_add(pixel, halves, place[p], more, replaced[p]);
            continue;
        }
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++)
            fours_add(pixel[place[p][lane]], more[lane], halves);
    }
}

void fast_add_packets(Tile *tile, const FastDraw *d, const FastShaded *shaded)
{
    uint32_t place[FAST_BLOCK][GP_LANES];
    find_places(shaded, place);
    for (int t = 0; t < tile->sums->targets; t++) {
        const GpFormat format = d->pass->color[t].surface->format;
        const flt *color = shaded->color + 4 * t;
        if (format == GP_G16R16F || format == GP_A16B16G16R16F)
            add_all(tile->sums->pixel[t], true, shaded, place, color);
        else
            add_all(tile->sums->pixel[t], false, shaded, place, color);
    }
}
