#include "apps/charts/chart_difference.h"

#include <math.h>

enum { LARGER = 4, BLOCKS = 16, SPAN = BLOCKS / LARGER }; /* a part is SPAN blocks wide and high */

/* What both halves are drawn from. */
typedef struct Seen {
    const GpSurface *picture;
    const float *off;
    uint32_t width, height;
    float most;
} Seen;

/* Begin of a block. */
static uint32_t edge(uint32_t length, uint32_t block)
{
    return (uint32_t)((uint64_t)length * block / BLOCKS);
}

static float amount(const Seen *seen, uint32_t x, uint32_t y)
{
    return seen->off[(size_t)seen->width * y + x];
}

static void add_blocks(const Seen *seen, double sums[BLOCKS][BLOCKS])
{
    for (uint32_t j = 0; j < BLOCKS; j++)
        for (uint32_t i = 0; i < BLOCKS; i++)
            for (uint32_t y = edge(seen->height, j); y < edge(seen->height, j + 1); y++)
                for (uint32_t x = edge(seen->width, i); x < edge(seen->width, i + 1); x++)
                    sums[j][i] += fabs((double)amount(seen, x, y));
}

/* The part with most of the difference; of equal ones the nearest to the centre. */
static void find_part(const Seen *seen, uint32_t part[2])
{
    enum { CENTRE = (BLOCKS - SPAN) / 2 };
    double sums[BLOCKS][BLOCKS] = { { 0 } }, most = -1;
    int nearest = 0;
    add_blocks(seen, sums);
    for (int j = 0; j <= BLOCKS - SPAN; j++)
        for (int i = 0; i <= BLOCKS - SPAN; i++) {
            const int far = (i - CENTRE) * (i - CENTRE) + (j - CENTRE) * (j - CENTRE);
            double sum = 0;
            for (int k = 0; k < SPAN * SPAN; k++)
                sum += sums[j + k / SPAN][i + k % SPAN];
            if (sum > most || (sum == most && far < nearest)) {
                most = sum;
                nearest = far;
                part[0] = (uint32_t)i;
                part[1] = (uint32_t)j;
            }
        }
}

/* Pale grey of the picture, and over it the colour of the difference. */
static void paint(const Seen *seen, uint32_t x, uint32_t y, float off, float color[3])
{
    static const float over[3] = { 0.86f, 0.33f, 0.0f }, under[3] = { 0.0f, 0.3f, 0.85f };
    const size_t bytes = gp_format_info(seen->picture->format)->bytes;
    float rgba[4], sum = 0;
    gp_texel_load(seen->picture->format, gp_surface_texel(&seen->picture->level[0], bytes, x, y),
                  rgba);
    for (int k = 0; k < 3; k++)
        sum += rgba[k] > 1 ? 1 : rgba[k] > 0 ? rgba[k] : 0;
    const float grey = 0.55f + 0.4f * sum / 3;
    const float share = seen->most > 0 ? fabsf(off) / seen->most : 0;
    for (int k = 0; k < 3; k++)
        color[k] = grey + share * ((off > 0 ? over : under)[k] - grey);
}

/* The most within a pixel or two, so that a single one can be seen in a small picture. */
static float spread(const Seen *seen, uint32_t x, uint32_t y)
{
    const uint32_t reach = seen->width / 400;
    float most = 0;
    for (uint32_t j = y < reach ? 0 : y - reach; j <= y + reach && j < seen->height; j++)
        for (uint32_t i = x < reach ? 0 : x - reach; i <= x + reach && i < seen->width; i++)
            if (fabsf(amount(seen, i, j)) > fabsf(most))
                most = amount(seen, i, j);
    return most;
}

/* Round the part, so that it hides nothing of it. */
static bool is_frame(const Seen *seen, const uint32_t part[2], uint32_t x, uint32_t y)
{
    const uint32_t left = edge(seen->width, part[0]), right = edge(seen->width, part[0] + SPAN);
    const uint32_t top = edge(seen->height, part[1]), bottom = edge(seen->height, part[1] + SPAN);
    const uint32_t wide = 1 + seen->width / 500;
    const bool inside = x >= left && x < right && y >= top && y < bottom;
    return !inside && x + wide >= left && x < right + wide && y + wide >= top && y < bottom + wide;
}

GpResult chart_difference(const GpSurface *picture, const float *off, Picture *made, GpError *error)
{
    Seen seen = { picture, off, picture->width, picture->height, 0 };
    const uint32_t width = seen.width, height = seen.height;
    uint32_t part[2] = { 0 };
    float *values = gp_alloc((size_t)width * height, 2 * 3 * sizeof *values), *to = values;
    if (!values)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (size_t i = 0; i < (size_t)width * height; i++)
        seen.most = fmaxf(seen.most, fabsf(off[i]));
    find_part(&seen, part);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++, to += 3) {
            paint(&seen, x, y, spread(&seen, x, y), to);
            for (int k = 0; k < 3 && is_frame(&seen, part, x, y); k++)
                to[k] = 0;
        }
        for (uint32_t x = 0; x < width; x++, to += 3) {
            const uint32_t from_x = edge(width, part[0]) + x / LARGER;
            const uint32_t from_y = edge(height, part[1]) + y / LARGER;
            paint(&seen, from_x, from_y, amount(&seen, from_x, from_y), to);
        }
    }
    *made = (Picture){ .width = 2 * width, .height = height, .channels = 3, .values = values };
    return GP_OK;
}
