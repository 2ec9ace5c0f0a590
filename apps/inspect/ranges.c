#include "apps/inspect/ranges.h"

#include "apps/base/json.h"

#include <math.h>

typedef struct Range {
    double low, high;
    uint32_t odd, finite, bins[RANGE_BINS];
} Range;

static int channels_of(const GpFormatInfo *info)
{
    return info->is_depth ? 1 + info->has_stencil : info->channels;
}

static void load(GpFormat format, const uint8_t *texel, float value[4])
{
    const GpFormatInfo *info = gp_format_info(format);
    if (!info->is_depth) {
        gp_texel_load(format, texel, value);
        return;
    }
    uint32_t code;
    uint8_t stencil;
    gp_depth_load(format, texel, &code, &stencil);
    value[0] = gp_depth_from_code(format, code);
    value[1] = stencil;
}

static void widen(Range *range, double value)
{
    if (!isfinite(value)) {
        range->odd++;
        return;
    }
    range->low = range->finite == 0 || value < range->low ? value : range->low;
    range->high = range->finite == 0 || value > range->high ? value : range->high;
    range->finite++;
}

static int bin_of(const Range *range, double value)
{
    const double wide = range->high - range->low;
    return wide > 0 ? (int)((value - range->low) / wide * (RANGE_BINS - 0.001)) : 0;
}

static json_t *tell(const Range *range)
{
    json_t *bins = json_array();
    for (int i = 0; i < RANGE_BINS; i++)
        json_array_append_new(bins, json_integer(range->bins[i]));
    return json_pack("{s:o, s:o, s:I, s:o}", "low", json_number(range->low), "high",
                     json_number(range->high), "odd", (json_int_t)range->odd, "bins", bins);
}

/* Channels of bytes: each of the 256 codes is counted, then put where its value belongs. */
static void find_of_bytes(const GpFormatInfo *info, GpFormat format, const uint8_t *texels,
                          size_t pixels, Range range[4])
{
    for (int c = 0; c < info->channels; c++) {
        uint32_t counts[256] = { 0 };
        for (size_t i = 0; i < pixels; i++)
            counts[texels[i * info->bytes + info->first_byte[c]]]++;
        double values[256];
        for (int code = 0; code < 256; code++) {
            uint8_t texel[4] = { 0 };
            float value[4];
            texel[info->first_byte[c]] = (uint8_t)code;
            load(format, texel, value);
            values[code] = (double)value[c];
            if (counts[code])
                widen(&range[c], values[code]);
        }
        for (int code = 0; code < 256; code++)
            if (counts[code])
                range[c].bins[bin_of(&range[c], values[code])] += counts[code];
    }
}

static void find(const GpFormatInfo *info, GpFormat format, const uint8_t *texels, size_t pixels,
                 Range range[4])
{
    for (int turn = 0; turn < 2; turn++)
        for (size_t i = 0; i < pixels; i++) {
            float value[4];
            load(format, texels + i * info->bytes, value);
            for (int c = 0; c < channels_of(info); c++)
                if (turn == 0)
                    widen(&range[c], (double)value[c]);
                else if (isfinite(value[c]))
                    range[c].bins[bin_of(&range[c], (double)value[c])]++;
        }
}

json_t *ranges_tell(const GpSurface *surface, const uint8_t *texels)
{
    const GpFormatInfo *info = gp_format_info(surface->format);
    const size_t pixels = (size_t)surface->width * surface->height;
    Range range[4] = { { .low = 0 } };
    if (info->is_unorm8 && info->bytes <= 4)
        find_of_bytes(info, surface->format, texels, pixels, range);
    else
        find(info, surface->format, texels, pixels, range);
    json_t *list = json_array();
    for (int c = 0; c < channels_of(info); c++)
        json_array_append_new(list, tell(&range[c]));
    return list;
}
