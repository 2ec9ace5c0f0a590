/* Textures of depth images: what shows something is as it was; what does not has the mean of the
 * smallest square of the pyramid about it in which something shows. */
#include "apps/depth_images/drawing/textures.h"

#include "tests/support/random.h"
#include "tests/support/surfaces/texels.h"

#include <math.h>

enum { MOST_PIXELS = 64 * 64 };

static float depth[MOST_PIXELS], value[3 * MOST_PIXELS];

/* holes: so many of 100 pixels show nothing */
static DepthPixels make_pixels(uint32_t width, uint32_t height, int holes)
{
    Random random = { width * 100 + height };
    for (uint32_t i = 0; i < width * height; i++) {
        depth[i] = random_int(&random, 0, 99) < holes ? DEPTH_NOTHING : 1;
        for (int c = 0; c < 3; c++)
            value[3 * i + (uint32_t)c] = random_float(&random, 0, 1);
    }
    return (DepthPixels){ .width = width, .height = height, .depth = depth, .color = value };
}

/* Channel c over the square of 2^level pixels a side that has a pixel; false: nothing shows
 * there. */
static bool mean_of_square(const DepthPixels *pixels, uint32_t x, uint32_t y, int level, int c,
                           double *mean)
{
    const uint32_t x0 = x >> level << level, y0 = y >> level << level;
    double sum = 0;
    int count = 0;
    for (uint32_t v = y0; v < y0 + (1u << level) && v < pixels->height; v++)
        for (uint32_t u = x0; u < x0 + (1u << level) && u < pixels->width; u++)
            if (pixels->depth[v * pixels->width + u] < DEPTH_NOTHING) {
                sum += (double)pixels->color[3 * (v * pixels->width + u) + (uint32_t)c];
                count++;
            }
    *mean = sum / count;
    return count > 0;
}

static void compare(const DepthPixels *pixels, double scale, double offset,
                    const GpSurface *texture)
{
    for (uint32_t y = 0; y < pixels->height; y++)
        for (uint32_t x = 0; x < pixels->width; x++)
            for (int c = 0; c < 3; c++) {
                double mean;
                int level = 0;
                while (!mean_of_square(pixels, x, y, level, c, &mean))
                    level++;
                const uint8_t *texel = texel_at(texture, 0, x, y);
                const double off = texel[2 - c] - 255 * (mean * scale + offset);
                if (fabs(off) > 0.501 || texel[3] != 255)
                    fail_msg("%u x %u, texel %u %u, channel %d: off by %.3f, alpha %d",
                             pixels->width, pixels->height, x, y, c, off, texel[3]);
            }
}

static void holes_have_the_mean_of_what_is_around_them(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = { { 64, 64 }, { 37, 21 }, { 1, 9 }, { 50, 1 } };
    for (int i = 0; i < 4; i++)
        for (int holes = 0; holes < 100; holes += 33) {
            GpError error = { "" };
            DepthTextures textures;
            const DepthPixels pixels = make_pixels(sizes[i][0], sizes[i][1], holes);
            depth[0] = 1;
            if (depth_textures_open(&pixels, value, &textures, &error))
                fail_msg("%s", error.text);
            compare(&pixels, 1, 0, textures.color);
            compare(&pixels, 0.5, 0.5, textures.normal);
            depth_textures_close(&textures);
        }
}

static void what_shows_nothing_at_all_is_black(void **state)
{
    (void)state;
    GpSurface *color;
    const DepthPixels pixels = make_pixels(8, 8, 100);
    assert_int_equal(depth_color_texture(&pixels, 1, &color, NULL), GP_OK);
    for (uint32_t i = 0; i < 64; i++)
        assert_memory_equal(texel_at(color, 0, i % 8, i / 8), "\0\0\0\xff", 4);
    gp_surface_destroy(&color);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(holes_have_the_mean_of_what_is_around_them),
        cmocka_unit_test(what_shows_nothing_at_all_is_black),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
