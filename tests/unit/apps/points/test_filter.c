/* Bounds on what a left out filter does to a picture, against numeric integration, over random
 * surfels as a camera sees them. */
#include "apps/points/filter.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <float.h>

static double random_in(Random *random, double low, double high)
{
    return low + (high - low) * ((double)(random_bits(random) >> 11) * 0x1p-53);
}

/* Evenly over all directions. */
static void random_direction(Random *random, double v[3])
{
    double length2;
    do {
        for (int k = 0; k < 3; k++)
            v[k] = random_in(random, -1, 1);
        length2 = vector_dot(v, v);
    } while (length2 > 1 || length2 < 0.01);
    vector_normalize(v);
}

/* Eigenvalues of the projected disc's variance, the larger first: by tangents and the Jacobian as
 * they are printed (Zwicker et al. 2001), eye space with z forward. */
static void project(const double o[3], const double n[3], double deviation, double focal,
                    double eigen[2])
{
    double s[3], t[3];
    vector_set(s, fabs(n[0]) < 0.6, fabs(n[0]) >= 0.6, 0);
    vector_cross(n, s, t);
    vector_normalize(t);
    vector_cross(t, n, s);
    const double f = deviation * focal / o[2];
    const double a = f * (s[0] - s[2] * o[0] / o[2]), b = f * (t[0] - t[2] * o[0] / o[2]);
    const double c = f * (s[1] - s[2] * o[1] / o[2]), d = f * (t[1] - t[2] * o[1] / o[2]);
    const double xx = a * a + b * b, yy = c * c + d * d, xy = a * c + b * d;
    const double mean = (xx + yy) / 2, det = (a * d - b * c) * (a * d - b * c);
    eigen[0] = mean + sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
    eigen[1] = det / eigen[0];
}

/* --- the bounds ------------------------------------------------------------------------------- */

/* Integral of |G - G'|, both Gaussians about 0 with these variances along the same axes: a
 * quadrant, by the midpoint rule in u = x / (x + scale). */
static double distance(const double v[2], const double w[2])
{
    enum { STEPS = 160 };
    double x[2][STEPS], dx[2][STEPS], sum = 0;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < STEPS; i++) {
            const double u = (i + 0.5) / STEPS, scale = sqrt(sqrt(v[k] * w[k]));
            x[k][i] = scale * u / (1 - u);
            dx[k][i] = scale / ((1 - u) * (1 - u)) / STEPS;
        }
    for (int i = 0; i < STEPS; i++)
        for (int j = 0; j < STEPS; j++) {
            const double a = x[0][i] * x[0][i], b = x[1][j] * x[1][j];
            const double g = exp(-(a / v[0] + b / v[1]) / 2) / sqrt(v[0] * v[1]);
            const double h = exp(-(a / w[0] + b / w[1]) / 2) / sqrt(w[0] * w[1]);
            sum += fabs(g - h) * dx[0][i] * dx[1][j];
        }
    return 4 * sum / 6.283185307179586;
}

static void a_gaussian_is_as_far_from_itself_and_others_as_known(void **state)
{
    (void)state;
    const double v[2] = { 1, 4 }, w[2] = { 2, 8 };
    assert_true(distance(v, v) < 1e-12);
    /* where one is twice as wide as the other: r^2 / 2 = 2 ln 2, and 2 (1/2 - 1/4) there */
    assert_true(fabs(distance(v, w) - 0.5) < 1e-3);
}

/* Over random surfels: tilt, depth, place in a wide picture, size and filter. */
static void bounds_hold_over_random_surfels_and_are_sharp(void **state)
{
    (void)state;
    Random random = { 71 };
    int sharp = 0;
    for (int i = 0; i < 150; i++) {
        double n[3], eigen[2];
        const double z = random_in(&random, 0.5, 50), focal = 400;
        const double o[3] = { z * random_in(&random, -1.2, 1.2), z * random_in(&random, -1, 1), z };
        const double h = pow(random_in(&random, 0.2, 1), 2);
        random_direction(&random, n);
        project(o, n, pow(10, random_in(&random, -4, -0.5)), focal, eigen);
        if (eigen[1] < 1e-5 * h)
            continue;
        const double both[2] = { eigen[0] + h, eigen[1] + h }, pixel[2] = { h, h };
        const double bounds[2] = { filter_bound_reconstruction(eigen[0], eigen[1], h),
                                   filter_bound_low_pass(eigen[0], eigen[1], h) };
        const double true_ones[2] = { distance(both, eigen), distance(both, pixel) };
        for (int k = 0; k < 2; k++) {
            if (!(true_ones[k] <= bounds[k] + 1e-3))
                fail_msg("l1 %g l2 %g h %g, filter %d: %g, bound %g", eigen[0], eigen[1], h, k,
                         true_ones[k], bounds[k]);
            if (bounds[k] > 0.5 || bounds[k] < 0.02)
                continue;
            sharp++;
            if (!(bounds[k] <= 1.6 * true_ones[k]))
                fail_msg("l1 %g l2 %g h %g, filter %d: %g, bound %g is not sharp", eigen[0],
                         eigen[1], h, k, true_ones[k], bounds[k]);
        }
    }
    assert_true(sharp > 20);
}

/* A long thin splat has the determinant of a round one of which nothing is lost. */
static void the_bound_sees_what_the_determinant_hides(void **state)
{
    (void)state;
    const double h = 0.16, round = filter_bound_reconstruction(4, 4, h);
    assert_true(round < 0.06);
    assert_true(filter_bound_reconstruction(4 * 40, 4 / 40.0, h) > 10 * round);
}

static void without_one_of_the_two_nothing_is_lost_by_the_other(void **state)
{
    (void)state;
    assert_true(filter_bound_reconstruction(3, 2, 0) == 0);
    assert_true(filter_bound_low_pass(0, 0, 1) == 0);
    assert_true(filter_bound_reconstruction(1, 0, 1) > DBL_MAX);
}

/* --- what a patch's surfels have in common ---------------------------------------------------- */

static void an_extent_holds_every_surfel_of_a_patch(void **state)
{
    (void)state;
    Random random = { 3 };
    const Camera camera = {
        .at = { 0, 0, -1 }, .up = { 0, 1, 0 }, .fovy = 70, .near = 0.1, .far = 99
    };
    const PointView view = point_view(&camera, 640, 480, 1.6, 0.8);
    const double tangents[2] = { view.axes.half_width, view.axes.half_height };
    int narrow = 0;
    for (int round = 0; round < 300; round++) {
        const double z = random_in(&random, 1, 20), size = z * random_in(&random, 0.001, 0.2);
        const double cosine = random_in(&random, 0.7, 1), sine = sqrt(1 - cosine * cosine);
        const double least = 0.001, most = least * random_in(&random, 1, 2);
        double axis[3];
        random_direction(&random, axis);
        PatchBox box = { .axes = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
                         .centre = { (float)(z * tangents[0] * random_in(&random, -0.8, 0.8)),
                                     (float)(z * tangents[1] * random_in(&random, -0.8, 0.8)),
                                     (float)-z },
                         .half = { (float)size, (float)size, (float)size } };
        const float about[3] = { (float)axis[0], (float)axis[1], (float)axis[2] };
        const BoxPlace place = box_place(&view, &box);
        const EyeWay way = eye_way(&view, &box, about);
        const Facing facing = way_facing(&way, (float)cosine, (float)sine);
        if (place.nearest < view.near)
            continue;
        const SplatExtent extent =
            splat_extent(&view, place.nearest, place.farthest, least, most, &facing);
        for (int i = 0; i < 50; i++) {
            double o[3], n[3], eigen[2];
            for (int k = 0; k < 3; k++)
                o[k] = (double)box.centre[k] + size * random_in(&random, -1, 1);
            o[1] = -o[1]; /* y down, z forward */
            o[2] = -o[2];
            random_direction(&random, n);
            for (int k = 0; k < 3; k++)
                n[k] = axis[k] + 0.9 * n[k];
            vector_normalize(n);
            const bool is_in_cone = vector_dot(n, axis) >= cosine;
            n[1] = -n[1];
            n[2] = -n[2];
            if (!is_in_cone || fabs(o[0]) > tangents[0] * o[2] || fabs(o[1]) > tangents[1] * o[2] ||
                vector_dot(n, o) >= 0)
                continue;
            project(o, n, random_in(&random, least, most), view.pixels, eigen);
            if (!(eigen[0] <= extent.high * (1 + 1e-12) && eigen[1] >= extent.low * (1 - 1e-12)))
                fail_msg("round %d: %g to %g, the extent is %g to %g", round, eigen[1], eigen[0],
                         extent.low, extent.high);
            narrow += extent.low > 0 && extent.high < 40 * extent.low;
        }
    }
    assert_true(narrow > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gaussian_is_as_far_from_itself_and_others_as_known),
        cmocka_unit_test(bounds_hold_over_random_surfels_and_are_sharp),
        cmocka_unit_test(the_bound_sees_what_the_determinant_hides),
        cmocka_unit_test(without_one_of_the_two_nothing_is_lost_by_the_other),
        cmocka_unit_test(an_extent_holds_every_surfel_of_a_patch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
