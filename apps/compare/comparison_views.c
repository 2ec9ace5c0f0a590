#include "apps/compare/comparison_views.h"

#include <math.h>
#include <string.h>

static GpResult open_view(uint32_t width, uint32_t height, int channels, Picture *view,
                          GpError *error)
{
    const size_t pixels = (size_t)width * height;
    float *values = gp_alloc(pixels, (size_t)channels * sizeof *values);
    if (!values)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    *view = (Picture){ width, height, channels, values };
    return GP_OK;
}

GpResult view_difference(const Picture pictures[2], double largest, Picture *view, double *scale,
                         GpError *error)
{
    const Picture *a = &pictures[0];
    const size_t pixels = (size_t)a->width * a->height, channels = (size_t)a->channels;
    float *differences = gp_alloc(pixels * channels, sizeof *differences);
    if (!differences || open_view(a->width, a->height, 3, view, error)) {
        gp_free(differences);
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    }
    *scale = largest > 0 && isfinite(largest) ? 1 / largest : 0;
    compare_difference(a, &pictures[1], *scale > 0 ? *scale : 1, differences);
    for (size_t i = 0; i < pixels; i++) {
        const float *from = differences + i * channels;
        for (size_t c = 0; c < 3; c++)
            view->values[3 * i + c] = from[channels > 2 ? c : 0];
    }
    if (channels % 2 == 0) /* compare_difference leaves four channels' alpha opaque */
        for (size_t i = 0; i < pixels; i++) {
            const size_t at = i * channels + channels - 1;
            const float alpha =
                fabsf(a->values[at] - pictures[1].values[at]) * (float)(*scale > 0 ? *scale : 1);
            for (size_t c = 0; c < 3; c++)
                view->values[3 * i + c] += alpha;
        }
    gp_free(differences);
    return GP_OK;
}

/* Five colours of the scale that FLIP's authors use (magma, by van der Walt and Smith, CC0). */
static void heat(float value, float color[3])
{
    static const float stops[][3] = {
        { 0, 0, 4 }, { 81, 18, 124 }, { 183, 55, 121 }, { 252, 137, 97 }, { 252, 253, 191 }
    };
    const float at = value * (GP_COUNT(stops) - 1);
    const int last = (int)GP_COUNT(stops) - 2, stop = (int)at < last ? (int)at : last;
    for (int c = 0; c < 3; c++)
        color[c] =
            (stops[stop][c] + (stops[stop + 1][c] - stops[stop][c]) * (at - (float)stop)) / 255;
}

GpResult view_flip(const Comparison *comparison, Picture *view, GpError *error)
{
    const uint32_t *size = comparison->sizes[0];
    if (open_view(size[0], size[1], 3, view, error))
        return GP_ERROR_MEMORY;
    for (size_t i = 0; i < (size_t)size[0] * size[1]; i++)
        heat(comparison->flip_map ? comparison->flip_map[i] : 0, view->values + 3 * i);
    return GP_OK;
}

GpResult view_part(const Picture *picture, uint32_t x, uint32_t y, uint32_t side, Picture *view,
                   GpError *error)
{
    const uint32_t width = picture->width - x < side ? picture->width - x : side;
    const uint32_t height = picture->height - y < side ? picture->height - y : side;
    if (open_view(width, height, picture->channels, view, error))
        return GP_ERROR_MEMORY;
    const size_t channels = (size_t)picture->channels;
    for (uint32_t row = 0; row < height; row++)
        memcpy(view->values + (size_t)row * width * channels,
               picture->values + ((size_t)(y + row) * picture->width + x) * channels,
               width * channels * sizeof(float));
    return GP_OK;
}
