/* Scissor: the pixels of a half-open rectangle, and no others. */
#include "pipeline/units/scissor.h"
#include "tests/support/unit.h"

static unsigned cut(int32_t x, int32_t y, unsigned mask, const int32_t rect[4])
{
    const GpRasterState state = { .scissor = true,
                                  .scissor_x0 = rect[0],
                                  .scissor_y0 = rect[1],
                                  .scissor_x1 = rect[2],
                                  .scissor_y1 = rect[3] };
    GpQuad quad = { .x = x, .y = y, .mask = mask };
    gp_scissor(&state, &quad);
    return quad.mask;
}

/* Every rectangle on a grid of 6 x 6 pixels, odd sides and empty ones among them: begins are
 * inside, ends are not. */
static void a_pixel_stays_if_and_only_if_it_is_inside(void **state)
{
    (void)state;
    int32_t r[4];
    for (r[0] = 0; r[0] <= 6; r[0]++)
        for (r[1] = 0; r[1] <= 6; r[1]++)
            for (r[2] = r[0]; r[2] <= 6; r[2]++)
                for (r[3] = r[1]; r[3] <= 6; r[3]++) {
                    int32_t kept = 0;
                    for (int32_t y = 0; y < 6; y += 2)
                        for (int32_t x = 0; x < 6; x += 2) {
                            unsigned mask = cut(x, y, 15, r);
                            kept += __builtin_popcount(mask);
                            for (int32_t p = 0; p < 4; p++)
                                if (mask >> p & 1)
                                    assert_true(x + p % 2 >= r[0] && x + p % 2 < r[2] &&
                                                y + p / 2 >= r[1] && y + p / 2 < r[3]);
                        }
                    assert_int_equal(kept, (r[2] - r[0]) * (r[3] - r[1]));
                }
}

static void pixels_that_are_dead_stay_dead(void **state)
{
    (void)state;
    const int32_t all[4] = { -5, -5, 100, 100 }, left[4] = { 0, 0, 11, 100 };
    for (unsigned mask = 0; mask < 16; mask++) {
        assert_int_equal(cut(10, 20, mask, all), mask);
        assert_int_equal(cut(10, 20, mask, left), mask & 5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pixel_stays_if_and_only_if_it_is_inside),
        cmocka_unit_test(pixels_that_are_dead_stay_dead),
    };
    return cmocka_run_group_tests_name("scissor", tests, NULL, NULL);
}
