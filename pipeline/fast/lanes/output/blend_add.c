#include "pipeline/fast/lanes/output/blend_add.h"

#include <string.h>

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

GP_INLINE void add_fours(float (*pixel)[4], bool halves, const uint32_t place[GP_LANES],
                         const itg channel[4], unsigned replaced)
{
    _Alignas(64) float more[GP_LANES][4];
    lanes_store4(more, sizeof more[0], channel);
    if (replaced) {
        replace_or_add(pixel, halves, place, more, replaced);
        return;
    }
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        fours_add(pixel[place[lane]], more[lane], halves);
}

/* Transposed, a pixel's channels have their neighbour's behind them. */
GP_INLINE void add_pairs(float (*pixel)[4], bool halves, const uint32_t place[GP_LANES],
                         const itg channel[4])
{
#if GP_LANES >= 8
    itg row[4];
    itg8 pair[4][GP_LANES / 8];
    lanes_transpose4(channel, row);
    GP_UNROLL
    for (int k = 0; k < 4; k++)
        itg_split_eights(row[k], pair[k]);
    GP_UNROLL
    for (int i = 0; i < GP_LANES / 2; i++)
        eights_add(pixel[place[i / 4 * 8 + i % 4]], pair[i % 4][i / 4], halves);
#else
    (void)pixel, (void)halves, (void)place, (void)channel;
#endif
}

/* Dead lanes add -0, which changes no number. */
GP_INLINE void add_all(float (*pixel)[4], bool halves, bool pairs, const FastShaded *shaded,
                       const flt *color)
{
    const FastShaded copy = *shaded, *s = &copy; /* which no store can change */
    for (int p = 0; p < s->block.count; p++, color += s->stride) {
        const msk alive = mask_of(s->live[p]);
        uint32_t place[GP_LANES];
        itg channel[4];
        store_lanes(place, false, gathered_at(&s->block.gathered[p]));
        GP_UNROLL
        for (int c = 0; c < 4; c++)
            channel[c] = itg_select(alive, (itg)color[c], itg_set(INT32_MIN));
        if (pairs)
            add_pairs(pixel, halves, place, channel);
        else
            add_fours(pixel, halves, place, channel, s->replaced[p]);
    }
}

GP_INLINE void add_as(float (*pixel)[4], bool halves, bool pairs, const FastShaded *shaded,
                      const flt *color)
{
    if (pairs)
        add_all(pixel, halves, true, shaded, color);
    else
        add_all(pixel, halves, false, shaded, color);
}

/* The lane that is added as the i-th: one after the other, or with its neighbour four lanes on. */
static int lane_in_turn(int i, bool pairs)
{
    return pairs ? i / 8 * 8 + i % 2 * 4 + i / 2 % 4 : i;
}

/* Only what lives: dead lanes would make other NaNs of those that stay. */
static void add_live(float (*pixel)[4], GpFormat format, const FastDraw *d, const FastShaded *s,
                     const flt *color)
{
    const bool pairs = fast_adds_pairs(d);
    for (int p = 0; p < s->block.count; p++, color += s->stride) {
        const itg place = gathered_at(&s->block.gathered[p]);
        for (int i = 0; i < GP_LANES; i++) {
            const int lane = lane_in_turn(i, pairs);
            const float more[4] = { color[0][lane], color[1][lane], color[2][lane],
                                    color[3][lane] };
            if (!(s->live[p] >> lane & 1))
                continue;
            if (d->needs.ternary && (s->replaced[p] >> lane & 1))
                memset(pixel[place[lane]], 0, sizeof pixel[0]);
            fours_add(pixel[place[lane]], more, fast_is_half(format));
        }
    }
}

void fast_add_packets(Tile *tile, const FastDraw *d, const FastShaded *shaded)
{
    const bool pairs = fast_adds_pairs(d);
    const int written = gp_program_targets(d->draw->program);
    for (int t = 0; t < written && t < tile->targets; t++) {
        const GpFormat format = d->pass->color[t].surface->format;
        const flt *color = shaded->color + 4 * t;
        if (tile->sums->odd[t])
            add_live(tile->sums->pixel[t], format, d, shaded, color);
        else if (fast_is_half(format))
            add_as(tile->sums->pixel[t], true, pairs, shaded, color);
        else
            add_as(tile->sums->pixel[t], false, pairs, shaded, color);
    }
}
