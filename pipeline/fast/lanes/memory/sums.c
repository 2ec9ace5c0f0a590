#include "pipeline/fast/lanes/memory/sums.h"

#include "pipeline/fast/lanes/memory/convert.h"

GP_INLINE bool to_sums(const Tile *tile, const FastPlanes *planes, int channels, float (*pixel)[4])
{
    msk odd = itg_set(0);
    for (int32_t y = 0; y < tile->height; y++)
        for (int32_t x = 0; x < tile->width; x += GP_LANES) {
            const uint32_t at = fast_at(x, y);
            itg channel[4] = { itg_set(0), itg_set(0), itg_set(0), itg_set(0) };
            GP_UNROLL
            for (int c = 0; c < channels; c++) {
                const itg held = (itg)flt_load(planes->channel[c] + at);
                const msk is_odd = is_odd_nan(held);
                channel[c] = itg_select(is_odd, itg_set(ODD_NAN), held);
                odd |= is_odd;
            }
            lanes_store4_row(pixel[at], channel);
        }
    return msk_any(odd);
}

GP_INLINE void to_planes(const Tile *tile, const float (*pixel)[4], int channels,
                         FastPlanes *planes)
{
    for (int32_t y = 0; y < tile->height; y++)
        for (int32_t x = 0; x < tile->width; x += GP_LANES) {
            const uint32_t at = fast_at(x, y);
            itg channel[4];
            lanes_load4_row(pixel[at], channel);
            GP_UNROLL
            for (int c = 0; c < channels; c++) {
                const itg held = (itg)flt_load(planes->channel[c] + at);
                const msk stays = (msk)(channel[c] == ODD_NAN);
                flt_store(planes->channel[c] + at,
                          (flt)itg_select(stays, held, canonical(channel[c])));
            }
        }
}

bool fast_planes_to_sums(const Tile *tile, const FastPlanes *planes, int channels,
                         float (*pixel)[4])
{
    return channels == 4 ? to_sums(tile, planes, 4, pixel) : to_sums(tile, planes, channels, pixel);
}

void fast_sums_to_planes(const Tile *tile, const float (*pixel)[4], int channels,
                         FastPlanes *planes)
{
    if (channels == 4)
        to_planes(tile, pixel, 4, planes);
    else
        to_planes(tile, pixel, channels, planes);
}

void fast_fill_sums(const Tile *tile, const float value[4], float (*pixel)[4])
{
    flt fours;
    for (int lane = 0; lane < GP_LANES; lane++)
        fours[lane] = value[lane % 4];
    for (int32_t y = 0; y < tile->height; y++)
        for (int32_t x = 0; x < FAST_TILE; x += GP_LANES / 4)
            flt_store(pixel[fast_at(x, y)], fours);
}
