/* Texture addressing: coordinates become numbers of texels and shares of 256ths, levels of detail
 * become mip levels. Rules R40 to R44. */
#include "pipeline/units/texture_address.h"

#include <math.h>

static float clamp(float value, float low, float high)
{
    return value < low ? low : value > high ? high : value;
}

/* To 256ths, to nearest even. The sum has no bits below 1 left, so the addition does the rounding;
 * |value| stays below 2^22. */
static int32_t to_fixed(float value)
{
    return (int32_t)((double)value * 256.0 + 0x1.8p52 - 0x1.8p52);
}

/* --- texels ----------------------------------------------------------------------------------- */

/* R42. The subtractions are exact for every coordinate of 1 and more, so that a large coordinate
 * keeps all the fraction it has. */
static float reduce(GpAddress mode, float coordinate)
{
    float reduced;
    switch (mode) {
    case GP_WRAP:
        reduced = coordinate - floorf(coordinate);
        break;
    case GP_MIRROR:
        reduced = coordinate - 2.0f * floorf(0.5f * coordinate);
        break;
    default:
        reduced = clamp(coordinate, -10.0f, 10.0f);
        break;
    }
    return reduced == reduced ? reduced : 0.0f;
}

GpTexelPair gp_texel_pair(GpAddress mode, GpFilter filter, float coordinate, uint32_t size)
{
    float position = reduce(mode, coordinate) * (float)size;
    if (filter == GP_POINT) {
        int32_t fixed = to_fixed(position);
        return (GpTexelPair){ .first = fixed >> 8, .share = 0 };
    }
    int32_t fixed = to_fixed(position - 0.5f);
    return (GpTexelPair){ .first = fixed >> 8, .share = (uint32_t)fixed & 255u };
}

int32_t gp_texel_address(GpAddress mode, int32_t index, uint32_t size)
{
    const int32_t n = (int32_t)size;
    switch (mode) {
    case GP_WRAP:
        index %= n;
        return index < 0 ? index + n : index;
    case GP_MIRROR:
        if (index < 0)
            index = -index - 1;
        index %= 2 * n;
        return index < n ? index : 2 * n - 1 - index;
    case GP_BORDER:
        return index >= 0 && index < n ? index : -1;
    case GP_MIRROR_ONCE:
        if (index < 0)
            index = -index - 1;
        return index < n ? index : n - 1;
    case GP_CLAMP:
    default:
        return index < 0 ? 0 : index < n ? index : n - 1;
    }
}

/* --- levels ----------------------------------------------------------------------------------- */

/* A level of detail as 8.8 fixed point; NaN, which a sampler's bounds may hold, is 0. */
static int32_t lod_to_fixed(float lod)
{
    return to_fixed(lod == lod ? clamp(lod, -128.0f, 128.0f - 1.0f / 256.0f) : 0.0f);
}

GpLevelPair gp_level_pair(const GpSampler *sampler, uint32_t levels, float lod)
{
    float biased = lod + sampler->lod_bias;
    if (biased != biased)
        biased = 0.0f;
    if (biased > gp_sampler_max_lod(sampler))
        biased = sampler->max_lod;
    if (biased < sampler->min_lod)
        biased = sampler->min_lod;

    int32_t fixed = lod_to_fixed(biased);
    int32_t detail = sampler->mip == GP_MIP_NONE ? lod_to_fixed(sampler->min_lod) : fixed;
    int32_t last = (int32_t)(levels - 1) * 256;
    detail = detail < 0 ? 0 : detail < last ? detail : last;

    bool blend = sampler->mip == GP_MIP_LINEAR;
    return (GpLevelPair){
        .first = (uint32_t)(blend ? detail : detail + 128) >> 8,
        .share = blend ? (uint32_t)detail & 255u : 0,
        .magnified = !(biased > 0.0f),
        .lod = (float)fixed * (1.0f / 256.0f),
    };
}
