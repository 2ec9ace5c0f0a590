/* Interpolation: depth, barycentrics, interpolants, clip distances, against exact arithmetic. */
#include "pipeline/units/interpolate.h"
#include "pipeline/units/raster.h"
#include "pipeline/units/setup.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

static const double d24_step = 1.0 / 16777215.0;

static GpScreenVertex random_corner(Random *random, int32_t reach, const float *varying)
{
    return (GpScreenVertex){ .x = random_int(random, -reach, reach),
                             .y = random_int(random, -reach, reach),
                             .z = random_float(random, 0, 1),
                             .rw = 1 / random_float(random, 0.1f, 50),
                             .varying = varying };
}

/* Exact depth at a centre: the weights are integers, the sum is in long double. */
static long double exact_depth(const GpTriangle *t, const GpQuad *quad, int pixel)
{
    long double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += (long double)quad->edge[k][pixel] * (long double)t->corner[k].z;
    return sum / (long double)t->area2;
}

/* Largest depth error, in steps of D24, over pixels that a triangle covers in a window. */
static double worst_depth_error(const GpScreenVertex corner[3], const GpRect *rect, long *pixels)
{
    GpTriangle t;
    double worst = 0;
    if (gp_setup_triangle(corner, &(GpRasterState){ 0 }, rect, &t) != GP_SETUP_DRAWN)
        return 0;
    GpRasterWalk walk = gp_raster_triangle(&t);
    GpQuad quad;
    while (gp_raster_next(&walk, &quad)) {
        gp_interpolate_depth(&t, 0, 1, &quad);
        for (int i = 0; i < 4; i++) {
            if (!(quad.mask >> i & 1))
                continue;
            double error = fabs((double)((long double)quad.depth[i] - exact_depth(&t, &quad, i)));
            worst = error > worst ? error : worst;
            ++*pixels;
        }
    }
    return worst / d24_step;
}

static void r16_depth_within_two_d24_steps_up_to_the_viewport(void **state)
{
    (void)state;
    Random random = { 16 };
    const GpRect rect = { 0, 0, 1024, 1024 };
    long pixels = 0;
    double worst = 0;
    for (int i = 0; i < 60; i++) {
        GpScreenVertex corner[3];
        for (int k = 0; k < 3; k++) {
            corner[k] = random_corner(&random, 512 * 256, NULL);
            corner[k].x += 512 * 256;
            corner[k].y += 512 * 256;
        }
        if (i % 3 == 0) { /* slivers: the third corner next to the line of the others */
            corner[2].x = (corner[0].x + corner[1].x) / 2 + random_int(&random, -3, 3);
            corner[2].y = (corner[0].y + corner[1].y) / 2 + random_int(&random, -3, 3);
        }
        double error = worst_depth_error(corner, &rect, &pixels);
        worst = error > worst ? error : worst;
    }
    assert_true(pixels > 100000);
    assert_true(worst <= 2);
    assert_true(worst <= 0.51); /* what the model really promises: the rounding to binary32 */
}

static void r16_depth_bound_holds_up_to_the_guard_band(void **state)
{
    (void)state;
    Random random = { 161 };
    const GpRect rect = { 0, 0, 128, 128 };
    long pixels = 0;
    for (int i = 0; i < 300; i++) {
        GpScreenVertex corner[3];
        for (int k = 0; k < 3; k++)
            corner[k] = random_corner(&random, 8380000, NULL);
        assert_true(worst_depth_error(corner, &rect, &pixels) <= 0.51);
    }
    assert_true(pixels > 100000);
}

/* The thinnest triangle that can hold a pixel centre: by Pick's theorem its doubled area is 3. With
 * det(u, v) = 1 the corners P+u, P+v, P-u-v make one round P. */
static void r16_depth_is_right_in_the_thinnest_triangle(void **state)
{
    (void)state;
    enum { M = 60000, P = 512 * 256 + 128 };
    const GpRect rect = { 0, 0, 1024, 1024 };
    GpScreenVertex corner[3] = {
        { .x = P + M, .y = P + M - 1, .z = 0.1f, .rw = 1 },
        { .x = P + M + 1, .y = P + M, .z = 0.9f, .rw = 1 },
        { .x = P - 2 * M - 1, .y = P - 2 * M + 1, .z = 0.3f, .rw = 1 },
    };
    assert_true(gp_signed_area2(corner) == 3);
    long pixels = 0;
    assert_true(worst_depth_error(corner, &rect, &pixels) <= 0.51);
    assert_int_equal(pixels, 1);
}

static void r16_interpolants_are_perspective_correct(void **state)
{
    (void)state;
    Random random = { 162 };
    const GpRect rect = { 0, 0, 256, 256 };
    long pixels = 0;
    double worst = 0;
    for (int i = 0; i < 200; i++) {
        float varying[3][2];
        GpScreenVertex corner[3];
        for (int k = 0; k < 3; k++) {
            varying[k][0] = random_float(&random, -1, 1);
            varying[k][1] = 0.3f; /* constant */
            corner[k] = random_corner(&random, 300 * 256, varying[k]);
        }
        GpTriangle t;
        GpVaryingModes modes = { .components = 2, .sprite = -1 };
        if (gp_setup_triangle(corner, &(GpRasterState){ 0 }, &rect, &t) != GP_SETUP_DRAWN)
            continue;
        GpRasterWalk walk = gp_raster_triangle(&t);
        GpQuad quad;
        while (gp_raster_next(&walk, &quad)) {
            gp_interpolate_barycentrics(&t, &quad);
            gp_interpolate_varyings(&t, &modes, 3, &quad);
            for (int p = 0; p < 4; p++) {
                assert_true(quad.varying[1][p] == 0.3f); /* bit for bit, helpers too */
                if (!(quad.mask >> p & 1))
                    continue;
                long double over_w = 0, rw = 0;
                for (int k = 0; k < 3; k++) {
                    long double share = (long double)quad.edge[k][p] * (long double)t.corner[k].rw;
                    over_w += share * (long double)t.corner[k].varying[0];
                    rw += share;
                }
                double error = fabs((double)((long double)quad.varying[0][p] - over_w / rw));
                worst = error > worst ? error : worst;
                pixels++;
            }
        }
    }
    assert_true(pixels > 100000);
    assert_true(worst < 0x1p-19); /* of values in [-1, 1], with w from 0.1 to 50 */
}

static void modes_flat_and_linear_do_as_they_say(void **state)
{
    (void)state;
    const GpRect rect = { 0, 0, 64, 64 };
    float varying[3][3] = { { 5, 0, 0 }, { 6, 1, 1 }, { 7, 0, 0 } };
    GpScreenVertex corner[3] = { { .x = 0, .y = 0, .rw = 1, .varying = varying[0] },
                                 { .x = 64 * 256, .y = 0, .rw = 0.1f, .varying = varying[1] },
                                 { .x = 0, .y = 64 * 256, .rw = 1, .varying = varying[2] } };
    GpVaryingModes modes = { .components = 3,
                             .mode = { GP_FLAT, GP_LINEAR_SCREEN, GP_PERSPECTIVE },
                             .sprite = -1 };
    GpTriangle t;
    assert_int_equal(gp_setup_triangle(corner, &(GpRasterState){ 0 }, &rect, &t), GP_SETUP_DRAWN);
    GpRasterWalk walk = gp_raster_triangle(&t);
    GpQuad quad;
    while (gp_raster_next(&walk, &quad)) {
        gp_interpolate_barycentrics(&t, &quad);
        gp_interpolate_varyings(&t, &modes, 7, &quad);
        for (int p = 0; p < 4; p++) {
            float x = (float)(quad.x + p % 2) + 0.5f;
            assert_true(quad.varying[0][p] == 5);
            assert_true(fabsf(quad.varying[1][p] - x / 64) < 1e-6f);
            if (quad.mask >> p & 1)
                assert_true(quad.varying[2][p] <= quad.varying[1][p]);
        }
    }
}

static void r11_negative_or_no_number_clip_distances_are_not_drawn(void **state)
{
    (void)state;
    const GpRect rect = { 0, 0, 64, 64 };
    GpScreenVertex corner[3] = { { .x = 0, .y = 0, .rw = 1 },
                                 { .x = 64 * 256, .y = 0, .rw = 1 },
                                 { .x = 0, .y = 64 * 256, .rw = 1 } };
    for (int k = 0; k < 3; k++) { /* distance = x - 20 pixels */
        corner[k].clip_distance[2] = (float)corner[k].x / 256 - 20;
        corner[k].clip_distance[5] = NAN;
    }
    GpTriangle t;
    gp_setup_triangle(corner, &(GpRasterState){ 0 }, &rect, &t);
    GpRasterWalk walk = gp_raster_triangle(&t);
    GpQuad quad;
    while (gp_raster_next(&walk, &quad)) {
        gp_interpolate_barycentrics(&t, &quad);
        unsigned before = quad.mask;
        gp_interpolate_clip(&t, 1u << 2, &quad);
        for (int p = 0; p < 4; p++)
            if (before >> p & 1)
                assert_int_equal(quad.mask >> p & 1, quad.x + p % 2 >= 20);
        gp_interpolate_clip(&t, 1u << 5, &quad);
        assert_int_equal(quad.mask, 0);
    }
}

static void r18_depth_is_clamped_to_the_viewport_range(void **state)
{
    (void)state;
    const GpRect rect = { 0, 0, 8, 8 };
    GpScreenVertex corner[3] = { { .x = 0, .y = 0, .z = 0, .rw = 1 },
                                 { .x = 2048, .y = 0, .z = 1, .rw = 1 },
                                 { .x = 0, .y = 2048, .z = 1, .rw = 1 } };
    GpTriangle t;
    gp_setup_triangle(corner, &(GpRasterState){ .depth_bias = 3 }, &rect, &t);
    GpRasterWalk walk = gp_raster_triangle(&t);
    GpQuad quad;
    while (gp_raster_next(&walk, &quad)) {
        gp_interpolate_depth(&t, 0.25f, 0.75f, &quad);
        for (int p = 0; p < 4; p++)
            assert_true(quad.depth[p] == 0.75f);
    }
}

static void r22_depth_bias_is_slope_times_the_larger_gradient_plus_bias(void **state)
{
    (void)state;
    const GpRect rect = { 0, 0, 64, 64 };
    GpScreenVertex corner[3] = { { .x = 0, .y = 0, .z = 0.25f, .rw = 1 },
                                 { .x = 64 * 256, .y = 0, .z = 0.5f, .rw = 1 },
                                 { .x = 0, .y = 64 * 256, .z = 0.125f, .rw = 1 } };
    GpTriangle plain, biased, flat;
    const double dz_dx = 0.25 / 64, bias = 0.0625;
    gp_setup_triangle(corner, &(GpRasterState){ 0 }, &rect, &plain);
    gp_setup_triangle(corner, &(GpRasterState){ .depth_bias = 0.0625f, .slope_depth_bias = 2 },
                      &rect, &biased);
    assert_true(fabs(biased.z_base - plain.z_base - (2 * dz_dx + bias)) < 1e-12);
    corner[0].z = corner[1].z = corner[2].z = INFINITY; /* 0 * infinity must not arise */
    gp_setup_triangle(corner, &(GpRasterState){ .depth_bias = 0.0625f }, &rect, &flat);
    assert_true(flat.z_base == (double)INFINITY);
}

static void sprite_coordinates_run_from_0_to_1(void **state)
{
    (void)state;
    const GpRect rect = { 0, 0, 64, 64 };
    float varying[3] = { 9, 9, 42 };
    GpScreenVertex center = {
        .x = 32 * 256, .y = 32 * 256, .z = 0.5f, .rw = 1, .varying = varying
    };
    GpPointSprite sprite;
    GpVaryingModes modes = { .components = 3, .sprite = 0 };
    assert_int_equal(gp_setup_point(&center, 16, &rect, &sprite), GP_SETUP_DRAWN);
    GpRasterWalk walk = gp_raster_sprite(&sprite);
    GpQuad quad;
    int pixels = 0;
    while (gp_raster_next(&walk, &quad)) {
        gp_interpolate_sprite(&sprite, &modes, 0, 1, &quad);
        for (int p = 0; p < 4; p++) {
            float u = ((float)(quad.x + p % 2) + 0.5f - 24) / 16;
            float v = ((float)(quad.y + p / 2) + 0.5f - 24) / 16;
            assert_true(quad.varying[0][p] == u && quad.varying[1][p] == v);
            assert_true(quad.varying[2][p] == 42 && quad.depth[p] == 0.5f);
            pixels += (int)(quad.mask >> p & 1);
        }
    }
    assert_int_equal(pixels, 256);
}

static void a_varying_of_sprite_coordinates_is_perspective_in_triangles(void **state)
{
    (void)state;
    const GpProgram program = { .varyings = { { "sprite", 2, GP_FLAT },
                                              { "corner", 2, GP_SPRITE_COORD },
                                              { "rest", 1, GP_LINEAR_SCREEN } } };
    GpVaryingModes modes = gp_varying_modes(&program);
    assert_int_equal(modes.components, 5);
    assert_int_equal(modes.sprite, 2); /* by its mode: a name means nothing */
    assert_int_equal(modes.flat, 3);
    assert_true(modes.mode[2] == GP_PERSPECTIVE && modes.mode[3] == GP_PERSPECTIVE);
    assert_true(modes.mode[4] == GP_LINEAR_SCREEN);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r16_depth_within_two_d24_steps_up_to_the_viewport),
        cmocka_unit_test(r16_depth_bound_holds_up_to_the_guard_band),
        cmocka_unit_test(r16_depth_is_right_in_the_thinnest_triangle),
        cmocka_unit_test(r16_interpolants_are_perspective_correct),
        cmocka_unit_test(modes_flat_and_linear_do_as_they_say),
        cmocka_unit_test(r11_negative_or_no_number_clip_distances_are_not_drawn),
        cmocka_unit_test(r18_depth_is_clamped_to_the_viewport_range),
        cmocka_unit_test(r22_depth_bias_is_slope_times_the_larger_gradient_plus_bias),
        cmocka_unit_test(sprite_coordinates_run_from_0_to_1),
        cmocka_unit_test(a_varying_of_sprite_coordinates_is_perspective_in_triangles),
    };
    return cmocka_run_group_tests_name("interpolate", tests, NULL, NULL);
}
