/* FLIP: differences worked out by hand, and those that the authors' own program finds.
 *
 * Uniform pictures stay what they are under every filter, so that their FLIP is the colour
 * difference alone, which the paper's formulas give. */
#include "apps/compare/flip.h"
#include "apps/compare/flip_color.h"
#include "tests/support/groups/pool.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

enum { WIDTH = 96, HEIGHT = 70 };

static float values[2][HEIGHT * WIDTH * 4], map[HEIGHT * WIDTH];

static FlipReport flip(uint32_t width, uint32_t height, int channels, double ppd)
{
    FlipReport report;
    const Picture a = { width, height, channels, values[0] };
    const Picture b = { width, height, channels, values[1] };
    assert_int_equal(flip_compare(&a, &b, ppd, pool, map, &report, NULL), GP_OK);
    return report;
}

/* FLIP of two uniform pictures of these codes. */
static FlipReport flip_uniform(const int a[3], const int b[3])
{
    for (size_t i = 0; i < 30 * 20; i++)
        for (size_t c = 0; c < 3; c++) {
            values[0][3 * i + c] = (float)a[c] / 255;
            values[1][3 * i + c] = (float)b[c] / 255;
        }
    return flip(30, 20, 3, FLIP_PIXELS_PER_DEGREE);
}

static void uniform_pictures_have_the_differences_of_the_formulas(void **state)
{
    (void)state;
    /* Black, white and grey have no chroma: HyAB is the difference of L*, 100, and 53.585 of code
     * 128; the largest distance is 41.2761; 0.95 + 0.05 (100^0.7 / 41.2761 - 0.4) / 0.6, and of
     * grey 53.585^0.7 / 41.2761 / 0.4 * 0.95. The others by the authors' Python program, version
     * 1.2. */
    static const struct {
        int a[3], b[3];
        double flip;
    } rows[] = {
        { { 0, 0, 0 }, { 255, 255, 255 }, 0.967380 }, { { 0, 0, 0 }, { 128, 128, 128 }, 0.933889 },
        { { 0, 255, 0 }, { 0, 0, 255 }, 1 },          { { 255, 0, 0 }, { 0, 255, 0 }, 0.986662 },
        { { 255, 0, 0 }, { 0, 0, 255 }, 0.965079 },   { { 0, 0, 0 }, { 255, 0, 0 }, 0.970497 },
        { { 7, 99, 200 }, { 7, 99, 200 }, 0 },
    };
    const double black_and_white = 0.95 + 0.05 * (pow(100, 0.7) / 41.276098414595445 - 0.4) / 0.6;
    assert_true(fabs(black_and_white - rows[0].flip) < 1e-6);
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const FlipReport report = flip_uniform(rows[i].a, rows[i].b);
        if (!(fabs(report.mean - rows[i].flip) < 2e-6 && fabs(report.max - rows[i].flip) < 2e-6))
            fail_msg("row %zu: %.7f instead of %.7f", i, report.mean, rows[i].flip);
    }
}

static void green_against_blue_is_the_largest_difference(void **state)
{
    (void)state;
    StablePair green[3], blue[3];
    flip_opponent((const StablePair[]){ { 0, 0 }, { 1, 1 }, { 0, 0 } }, green);
    flip_opponent((const StablePair[]){ { 0, 0 }, { 0, 0 }, { 1, 1 } }, blue);
    assert_true(fabs(flip_color_difference(green, blue)[1] - 1) < 1e-13);
    Random random = { 3 };
    for (int i = 0; i < 20000; i++) {
        StablePair srgb[2][3], opponent[2][3];
        for (int k = 0; k < 2; k++) {
            for (int c = 0; c < 6; c++) /* corners of the cube as often as its inside */
                srgb[k][c / 2][c % 2] = random_int(&random, 0, 1)
                                            ? random_int(&random, 0, 1)
                                            : (double)random_float(&random, 0, 1);
            flip_opponent(srgb[k], opponent[k]);
        }
        const StablePair difference = flip_color_difference(opponent[0], opponent[1]);
        for (int k = 0; k < 2; k++)
            assert_true(difference[k] >= 0 && difference[k] <= 1 + 1e-13);
    }
}

/* Patterns by whole numbers, so that any program can draw them. */
static void draw_pattern(int number)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            for (int c = 0; c < 3; c++) {
                int a = (x * (c + 3) + y * 5) % 256, b = a;
                if (number == 0) /* shifted by a pixel */
                    b = ((x + 1) * (c + 3) + y * 5) % 256;
                else if (number == 1) /* points */
                    b = x % 16 == 7 && y % 16 == 9 ? 255 - a : a;
                else if (number == 2) /* a checkerboard against its inverse */
                    a = (x / 8 + y / 8) % 2 ? 230 : 20, b = 250 - a;
                else /* one colour darker */
                    b = c == 1 ? a * 3 / 4 : a;
                const size_t index = (size_t)((y * WIDTH + x) * 3 + c);
                values[0][index] = (float)a / 255;
                values[1][index] = (float)b / 255;
            }
}

/* The authors' program on these patterns: NVlabs/flip 1.2, python/flip_api.py, its filters by SciPy
 * instead of OpenCV; mean and largest. */
static void patterns_have_the_differences_that_the_authors_program_finds(void **state)
{
    (void)state;
    static const struct {
        int pattern;
        double ppd, mean, max;
    } rows[] = {
        { 0, FLIP_PIXELS_PER_DEGREE, 0.207046, 0.789485 },
        { 0, 20, 0.199296, 0.986202 },
        { 1, FLIP_PIXELS_PER_DEGREE, 0.020695, 0.620842 },
        { 1, 150, 0.024183, 0.258648 },
        { 2, FLIP_PIXELS_PER_DEGREE, 0.749839, 0.961917 },
        { 2, 20, 0.961292, 0.961917 },
        { 2, 150, 0.445848, 0.961614 },
        { 3, FLIP_PIXELS_PER_DEGREE, 0.536377, 0.933744 },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        draw_pattern(rows[i].pattern);
        const FlipReport report = flip(WIDTH, HEIGHT, 3, rows[i].ppd);
        if (!(fabs(report.mean - rows[i].mean) < 5e-6 && fabs(report.max - rows[i].max) < 5e-5))
            fail_msg("pattern %d at %g: %.6f, %.6f instead of %.6f, %.6f", rows[i].pattern,
                     rows[i].ppd, report.mean, report.max, rows[i].mean, rows[i].max);
    }
}

static void threads_change_no_bit_and_order_of_pictures_none_of_the_map(void **state)
{
    (void)state;
    static float first[HEIGHT * WIDTH], swapped[2][sizeof values[0] / sizeof(float)];
    draw_pattern(0);
    const FlipReport report = flip(WIDTH, HEIGHT, 3, FLIP_PIXELS_PER_DEGREE);
    memcpy(first, map, sizeof map);
    GpPool *all = pool;
    assert_int_equal(gp_pool_create(3, &pool, NULL), GP_OK);
    assert_true(flip(WIDTH, HEIGHT, 3, FLIP_PIXELS_PER_DEGREE).mean == report.mean);
    assert_memory_equal(first, map, sizeof map);
    gp_pool_destroy(&pool);
    pool = all;
    memcpy(swapped, values, sizeof values);
    memcpy(values[0], swapped[1], sizeof values[0]);
    memcpy(values[1], swapped[0], sizeof values[1]);
    flip(WIDTH, HEIGHT, 3, FLIP_PIXELS_PER_DEGREE);
    assert_memory_equal(first, map, sizeof map);
}

/* In rows of any width the last pixel is the first one of a mirror. Sums go the other way round: a
 * last bit may differ. */
static void mirrored_pictures_have_mirrored_maps(void **state)
{
    (void)state;
    static float mirrored[40 * 9];
    Random random = { 21 };
    for (uint32_t width = 1; width <= 40; width++) {
        const uint32_t height = 1 + width % 9;
        for (uint32_t turn = 0; turn < 2; turn++) {
            for (uint32_t i = 0; i < 3 * width * height; i++)
                for (int k = 0; k < 2; k++) {
                    const uint32_t x = i / 3 % width, across = 3 * (width - 1 - x);
                    float *at = values[k] + i, *other = values[k] + (i - 3 * x + across);
                    if (!turn)
                        *at = random_float(&random, 0, 1);
                    else if (other > at) {
                        const float kept = *at;
                        *at = *other;
                        *other = kept;
                    }
                }
            memcpy(mirrored, map, sizeof mirrored);
            assert_true(flip(width, height, 3, FLIP_PIXELS_PER_DEGREE).max > 0);
        }
        for (uint32_t y = 0; y < height; y++)
            for (uint32_t x = 0; x < width; x++)
                assert_true(fabsf(map[y * width + x] - mirrored[y * width + width - 1 - x]) <
                            1e-6f);
    }
}

static void grey_alpha_and_values_beyond_codes_are_taken_as_stated(void **state)
{
    (void)state;
    static const float wild[] = { -3, 7, NAN, INFINITY }, tame[] = { 0, 1, 0, 1 };
    for (size_t i = 0; i < 12 * 12; i++) { /* grey and alpha */
        values[0][2 * i] = wild[i % 4];
        values[1][2 * i] = tame[i % 4];
        values[0][2 * i + 1] = 0.25f;
        values[1][2 * i + 1] = 0.75f;
    }
    assert_true(flip(12, 12, 2, FLIP_PIXELS_PER_DEGREE).max == 0);
    values[1][7] = 0.5f;
    assert_true(flip(12, 12, 2, FLIP_PIXELS_PER_DEGREE).max == 0);
    values[1][8] = 0.5f;
    assert_true(flip(12, 12, 2, FLIP_PIXELS_PER_DEGREE).max > 0);
    values[0][0] = 1, values[1][0] = 0.5f; /* a picture of one pixel is uniform */
    assert_true(flip(1, 1, 1, 500).max > 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(uniform_pictures_have_the_differences_of_the_formulas),
        cmocka_unit_test(green_against_blue_is_the_largest_difference),
        cmocka_unit_test(patterns_have_the_differences_that_the_authors_program_finds),
        cmocka_unit_test(threads_change_no_bit_and_order_of_pictures_none_of_the_map),
        cmocka_unit_test(mirrored_pictures_have_mirrored_maps),
        cmocka_unit_test(grey_alpha_and_values_beyond_codes_are_taken_as_stated),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
