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
    uint32_t code;
    uint8_t stencil;
    gp_texel_load(format, texel, value);
    if (gp_format_info(format)->has_stencil) {
        gp_depth_load(format, texel, &code, &stencil);
        value[1] = stencil;
    }
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

static void count(Range *range, double value)
{
    const double wide = range->high - range->low;
    if (isfinite(value))
        range->bins[wide > 0 ? (int)((value - range->low) / wide * (RANGE_BINS - 0.001)) : 0]++;
}

static json_t *tell(const Range *range)
{
    json_t *bins = json_array();
    for (int i = 0; i < RANGE_BINS; i++)
        json_array_append_new(bins, json_integer(range->bins[i]));
    return json_pack("{s:o, s:o, s:I, s:o}", "low", json_number(range->low), "high",
                     json_number(range->high), "odd", (json_int_t)range->odd, "bins", bins);
}

json_t *ranges_tell(const GpSurface *surface, const uint8_t *texels)
{
    const GpFormatInfo *info = gp_format_info(surface->format);
    const size_t count_of_texels = (size_t)surface->width * surface->height;
    const int channels = channels_of(info);
    Range range[4] = { { .low = 0 } };
    for (int turn = 0; turn < 2; turn++)
        for (size_t i = 0; i < count_of_texels; i++) {
            float value[4];
            load(surface->format, texels + i * info->bytes, value);
            for (int c = 0; c < channels; c++)
                (turn ? count : widen)(&range[c], (double)value[c]);
        }
    json_t *list = json_array();
    for (int c = 0; c < channels; c++)
        json_array_append_new(list, tell(&range[c]));
    return list;
}
