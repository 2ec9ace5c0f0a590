/* The sum over all splats against mathematics. */
#include "tests/support/splat_sum.h"
#include "tests/support/groups/pool.h"
#include "tests/support/unit.h"

#include <stdlib.h>

enum { WIDTH = 12, HEIGHT = 8 };

static SplatSum make(const TruthSplat *splats, uint32_t count, double fovy, double epsilon,
                     SplatSumKind kind)
{
    const SplatSumScene scene = {
        .splats = splats,
        .count = count,
        .camera = { .at = { 0, 0, -1 }, .up = { 0, 1, 0 }, .fovy = fovy, .near = 0.1, .far = 100 },
        .width = WIDTH,
        .height = HEIGHT,
        .low_pass = 0.4,
        .epsilon = epsilon,
        .kind = kind
    };
    SplatSum sum;
    assert_int_equal(splat_sum_make(&scene, pool, &sum), GP_OK);
    return sum;
}

/* --- a plane ---------------------------------------------------------------------------------- */

enum { SIDE = 48 };

/* A lattice through (0, 0, -z), square to the normal (0, n1, n2), coloured by its own x and y. */
static void fill_plane(double z, double n1, double n2, double spacing, TruthSplat *splats)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double x = (i % SIDE - SIDE / 2) * spacing, y = (i / SIDE - SIDE / 2) * spacing;
        splats[i] = (TruthSplat){ .position = { x, n2 * y, -z - n1 * y },
                                  .normal = { 0, n1, n2 },
                                  .radius = 0.8 * spacing,
                                  .deviation = 0.7 * spacing,
                                  .area = spacing * spacing,
                                  .color = { x, y, 1 } };
    }
}

/* Sums of Gaussians on a lattice are 1 to 2 exp(-2 pi^2 0.7^2) = 1.3e-4 a direction; colours in
 * proportion to the place are those of the place. */
static void weights_on_a_plane_add_up_to_one_and_keep_slopes(void **state)
{
    (void)state;
    TruthSplat *splats = calloc(SIDE * SIDE, sizeof *splats);
    for (int kind = SPLAT_SUM_AFFINE; kind <= SPLAT_SUM_EXACT; kind++) {
        fill_plane(10, 0, 1, 0.25, splats);
        SplatSum sum = make(splats, SIDE * SIDE, 30, 100, (SplatSumKind)kind);
        const double pixel = 10 * 2 * tan(0.2617993877991494) / HEIGHT;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            assert_true(fabs(sum.weight[i] - 1) < 4e-4);
            assert_true(fabs(sum.color[3 * i] - (i % WIDTH + 0.5 - WIDTH / 2) * pixel) < 1e-3);
            assert_true(fabs(sum.color[3 * i + 1] - (HEIGHT / 2 - 0.5 - i / WIDTH) * pixel) < 1e-3);
            assert_true(fabs(sum.color[3 * i + 2] - 1) < 1e-12);
        }
        splat_sum_free(&sum);
    }
    free(splats);
}

/* A tilted plane in a wide view is still weighed as 1 by rays; by affine Gaussians, which do not
 * fit together any more, it is not. */
static void only_the_exact_sum_holds_in_a_wide_view(void **state)
{
    (void)state;
    TruthSplat *splats = calloc(SIDE * SIDE, sizeof *splats);
    fill_plane(6, 0.8, 0.6, 0.5, splats);
    SplatSum affine = make(splats, SIDE * SIDE, 75, 100, SPLAT_SUM_AFFINE);
    SplatSum exact = make(splats, SIDE * SIDE, 75, 100, SPLAT_SUM_EXACT);
    double off[2] = { 0, 0 };
    for (int i = WIDTH * HEIGHT / 2; i < WIDTH * HEIGHT; i++) { /* the half that is near */
        off[0] = fmax(off[0], fabs(affine.weight[i] - 1));
        off[1] = fmax(off[1], fabs(exact.weight[i] - 1));
    }
    splat_sum_free(&affine);
    splat_sum_free(&exact);
    free(splats);
    if (!(off[1] < 1e-3 && off[0] > 10 * off[1]))
        fail_msg("weights are off by %g, by rays by %g", off[0], off[1]);
}

/* --- one splat -------------------------------------------------------------------------------- */

/* What is parallel to the picture is seen without distortion, wherever it is. */
static void both_sums_are_one_where_the_projection_is_affine(void **state)
{
    (void)state;
    const TruthSplat splat = { .position = { 3, -2, -5 },
                               .normal = { 0, 0, 1 },
                               .radius = 1,
                               .deviation = 0.6,
                               .area = 1,
                               .color = { 1, 0, 0 } };
    SplatSum affine = make(&splat, 1, 90, 1, SPLAT_SUM_AFFINE);
    SplatSum exact = make(&splat, 1, 90, 1, SPLAT_SUM_EXACT);
    double most = 0, all = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        most = fmax(most, affine.weight[i]);
        all += affine.weight[i];
        assert_true(fabs(affine.weight[i] - exact.weight[i]) < 1e-6);
    }
    assert_true(most > 0.1);
    assert_true(fabs(all - 4 * 4 / 25.0) < 1e-3); /* its area in pixels: 4 a unit at distance 1 */
    splat_sum_free(&affine);
    splat_sum_free(&exact);
}

static void splats_face_the_eye_and_lie_before_it(void **state)
{
    (void)state;
    TruthSplat splats[] = {
        { .position = { 0, 0, -5 }, .normal = { 0, 0, -1 } },
        { .position = { 0, 0, 5 }, .normal = { 0, 0, -1 } },
        { .position = { 0, 0, -0.05 }, .normal = { 0, 0, 1 } },
    };
    for (size_t i = 0; i < GP_COUNT(splats); i++)
        splats[i].radius = splats[i].deviation = splats[i].area = 1;
    for (int kind = SPLAT_SUM_AFFINE; kind <= SPLAT_SUM_EXACT; kind++) {
        SplatSum sum = make(splats, GP_COUNT(splats), 60, 1, (SplatSumKind)kind);
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            assert_true(sum.weight[i] == 0 && sum.color[3 * i] == 0);
        splat_sum_free(&sum);
    }
}

/* Footprints are 1 and the pixel filter's, 0.4 of 6.9 pixels a unit at distance 1. */
static void what_is_behind_by_more_than_epsilon_is_hidden(void **state)
{
    (void)state;
    const TruthSplat splats[] = {
        { { 0, 0, -5 }, { 0, 0, 1 }, 1, 1, 1, { 1, 0, 0 } },
        { { 0, 0, -7.2 }, { 0, 0, 1 }, 1, 1, 1, { 0, 1, 0 } },
    };
    SplatSum apart = make(splats, 2, 60, 1.6, SPLAT_SUM_AFFINE);
    SplatSum together = make(splats, 2, 60, 1.8, SPLAT_SUM_AFFINE);
    const size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
    assert_true(apart.color[3 * middle + 1] == 0 && apart.color[3 * middle] == 1);
    assert_true(together.color[3 * middle + 1] > 0.2);
    assert_true(apart.color[3 * middle + 4] > 0.2); /* beside the discs nothing is hidden */
    splat_sum_free(&apart);
    splat_sum_free(&together);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weights_on_a_plane_add_up_to_one_and_keep_slopes),
        cmocka_unit_test(only_the_exact_sum_holds_in_a_wide_view),
        cmocka_unit_test(both_sums_are_one_where_the_projection_is_affine),
        cmocka_unit_test(splats_face_the_eye_and_lie_before_it),
        cmocka_unit_test(what_is_behind_by_more_than_epsilon_is_hidden),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
