/* Textures of depth images: what shows something is as it was; what does not has the mean of the smallest
 * square of the pyramid about it in which something shows. */
#include "apps/depth_images/drawing/textures.h"

#include "pipeline/resources/surface.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

enum { MOST_PIXELS = 64 * 64 };

typedef struct Picture {
    uint32_t width, height;
    float depth[MOST_PIXELS], value[3 * MOST_PIXELS];
} Picture;

/* holes: so many of 100 pixels show nothing */
static void make_picture(uint32_t width, uint32_t height, int holes, Picture *picture)
{
    Random random = { width * 100 + height };
    picture->width = width;
    picture->height = height;
    for (uint32_t i = 0; i < width * height; i++) {
        picture->depth[i] = random_int(&random, 0, 99) < holes ? DEPTH_NOTHING : 1;
        for (int c = 0; c < 3; c++)
            picture->value[3 * i + (uint32_t)c] = random_float(&random, 0, 1);
    }
}

/* Channel c over the square of 2^level pixels a side that has a pixel; false: nothing shows there. */
static bool mean_of_square(const Picture *picture, uint32_t x, uint32_t y, int level, int c,
                           double *mean)
{
    const uint32_t x0 = x >> level << level, y0 = y >> level << level;
    double sum = 0;
    int count = 0;
    for (uint32_t v = y0; v < y0 + (1u << level) && v < picture->height; v++)
        for (uint32_t u = x0; u < x0 + (1u << level) && u < picture->width; u++)
            if (picture->depth[v * picture->width + u] < DEPTH_NOTHING) {
                sum += (double)picture->value[3 * (v * picture->width + u) + (uint32_t)c];
                count++;
            }
    *mean = sum / count;
    return count > 0;
}

static void compare(const Picture *picture, double scale, double offset, const GpSurface *texture)
{
    for (uint32_t y = 0; y < picture->height; y++)
        for (uint32_t x = 0; x < picture->width; x++)
            for (int c = 0; c < 3; c++) {
                double mean;
                int level = 0;
                while (!mean_of_square(picture, x, y, level, c, &mean))
                    level++;
                const uint8_t *texel = gp_surface_texel(&texture->level[0], 4, x, y);
                const double off = texel[2 - c] - 255 * (mean * scale + offset);
                if (fabs(off) > 0.501 || texel[3] != 255)
                    fail_msg("%u x %u, texel %u %u, channel %d: off by %.3f, alpha %d",
                             picture->width, picture->height, x, y, c, off, texel[3]);
            }
}

static void holes_have_the_mean_of_what_is_around_them(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = { { 64, 64 }, { 37, 21 }, { 1, 9 }, { 50, 1 } };
    static Picture picture;
    for (int i = 0; i < 4; i++)
        for (int holes = 0; holes < 100; holes += 33) {
            GpError error = { "" };
            DepthTextures textures;
            DepthPixels pixels = { .width = sizes[i][0],
                                   .height = sizes[i][1],
                                   .depth = picture.depth,
                                   .color = picture.value };
            make_picture(sizes[i][0], sizes[i][1], holes, &picture);
            picture.depth[0] = 1;
            if (depth_textures_open(&pixels, picture.value, &textures, &error))
                fail_msg("%s", error.text);
            compare(&picture, 1, 0, textures.color);
            compare(&picture, 0.5, 0.5, textures.normal);
            depth_textures_close(&textures);
        }
}

static void what_shows_nothing_at_all_is_black(void **state)
{
    (void)state;
    static Picture picture;
    GpSurface *color;
    const DepthPixels pixels = {
        .width = 8, .height = 8, .depth = picture.depth, .color = picture.value
    };
    make_picture(8, 8, 100, &picture);
    assert_int_equal(depth_color_texture(&pixels, 1, &color, NULL), GP_OK);
    for (uint32_t i = 0; i < 64; i++)
        assert_memory_equal(gp_surface_texel(&color->level[0], 4, i % 8, i / 8), "\0\0\0\xff", 4);
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
