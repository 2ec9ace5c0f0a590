/* Where a body is for a camera, against its corners and random points of it, projected one by
 * one. */
#include "apps/base/reach.h"

#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { WIDTH = 90, HEIGHT = 60, TRIES = 3000 };

static Camera random_camera(Random *random)
{
    Camera camera = { .up = { 0, 1, 0.1 }, .near = 1, .far = random_between(random, 2, 30) };
    if (random_int(random, 0, 1))
        camera.fovy = random_between(random, 20, 100);
    else
        camera.height = random_between(random, 1, 10);
    for (int k = 0; k < 3; k++) {
        camera.eye[k] = random_between(random, -9, 9);
        camera.at[k] = random_between(random, -2, 2);
    }
    return camera;
}

/* Any eight points: a body is between them. */
static void random_body(Random *random, double corners[8][3])
{
    const double size = random_int(random, 0, 1) ? 1 : 8;
    double middle[3];
    for (int k = 0; k < 3; k++)
        middle[k] = random_between(random, -4, 4);
    for (int i = 0; i < 8; i++)
        for (int k = 0; k < 3; k++)
            corners[i][k] = middle[k] + random_between(random, -size, size);
}

static void random_point(Random *random, double corners[8][3], double point[3])
{
    double share[8], sum = 0;
    for (int i = 0; i < 8; i++)
        sum += share[i] = random_int(random, 0, 2) ? random_between(random, 0, 1) : 0.0001;
    vector_set(point, 0, 0, 0);
    for (int i = 0; i < 8; i++)
        vector_add_scaled(point, share[i] / sum, corners[i], point);
}

/* x and y in pixels, down; z as stored. */
static void project(const Camera *camera, const double point[3], double pixel[3])
{
    double view[4][4], projection[4][4], both[4][4], clip[4];
    camera_view(camera, view);
    camera_projection(camera, (double)WIDTH / HEIGHT, projection);
    matrix_multiply(projection, view, both);
    for (int row = 0; row < 4; row++)
        clip[row] = vector_dot(both[row], point) + both[row][3];
    vector_set(pixel, (clip[0] / clip[3] + 1) / 2 * WIDTH, (1 - clip[1] / clip[3]) / 2 * HEIGHT,
               clip[2] / clip[3]);
}

static double distance_of(const Camera *camera, const CameraAxes *axes, const double point[3])
{
    double from_eye[3];
    vector_subtract(point, camera->eye, from_eye);
    return vector_dot(from_eye, axes->forward);
}

static void every_seen_point_is_in_the_rectangle_and_within_reach(void **state)
{
    (void)state;
    Random random = { 1 };
    int seen = 0, partly = 0;
    for (int i = 0; i < TRIES; i++) {
        const Camera camera = random_camera(&random);
        const CameraAxes axes = camera_axes(&camera, (double)WIDTH / HEIGHT);
        double corners[8][3], reach[2], point[3], pixel[3];
        random_body(&random, corners);
        const bool somewhere = reach_find(corners, &camera, &axes, reach);
        const GpRect rect = reach_rect(corners, &camera, &axes, WIDTH, HEIGHT);
        partly += rect.x0 > 0 || rect.y0 > 0 || rect.x1 < WIDTH || rect.y1 < HEIGHT;
        for (int p = 0; p < 20; p++) {
            random_point(&random, corners, point);
            const double distance = distance_of(&camera, &axes, point);
            if (distance < camera.near || distance > camera.far)
                continue;
            assert_true(somewhere && distance >= reach[0] - 1e-9 && distance <= reach[1] + 1e-9);
            project(&camera, point, pixel);
            if (pixel[0] < 0 || pixel[0] >= WIDTH || pixel[1] < 0 || pixel[1] >= HEIGHT)
                continue;
            seen++;
            assert_true(pixel[0] >= rect.x0 && pixel[0] < rect.x1);
            assert_true(pixel[1] >= rect.y0 && pixel[1] < rect.y1);
        }
    }
    assert_true(seen > TRIES && partly > TRIES / 4);
}

/* No more than a pixel around what is wholly before the eye. */
static void rectangles_are_tight(void **state)
{
    (void)state;
    Random random = { 2 };
    int checked = 0;
    for (int i = 0; i < TRIES; i++) {
        const Camera camera = random_camera(&random);
        const CameraAxes axes = camera_axes(&camera, (double)WIDTH / HEIGHT);
        double corners[8][3], low[2] = { WIDTH, HEIGHT }, high[2] = { 0, 0 }, nearest = HUGE_VAL;
        random_body(&random, corners);
        for (int c = 0; c < 8; c++) {
            double pixel[3];
            project(&camera, corners[c], pixel);
            nearest = fmin(nearest, distance_of(&camera, &axes, corners[c]));
            for (int k = 0; k < 2; k++) {
                low[k] = fmin(low[k], pixel[k]);
                high[k] = fmax(high[k], pixel[k]);
            }
        }
        const bool inside = low[0] > 2 && low[1] > 2 && high[0] < WIDTH - 2 && high[1] < HEIGHT - 2;
        if (nearest < camera.near || !inside)
            continue;
        const GpRect rect = reach_rect(corners, &camera, &axes, WIDTH, HEIGHT);
        checked++;
        assert_int_equal(rect.x0, (int32_t)floor(low[0]) - 1);
        assert_int_equal(rect.y0, (int32_t)floor(low[1]) - 1);
        assert_int_equal(rect.x1, (int32_t)ceil(high[0]) + 1);
        assert_int_equal(rect.y1, (int32_t)ceil(high[1]) + 1);
    }
    assert_true(checked > TRIES / 50);
}

static void what_is_behind_or_beyond_is_nowhere(void **state)
{
    (void)state;
    const Camera camera = {
        .up = { 0, 1, 0 }, .at = { 0, 0, -1 }, .fovy = 60, .near = 1, .far = 9
    };
    const CameraAxes axes = camera_axes(&camera, 1);
    static const double middles[] = { 5, -0.4, -9.6, -30 };
    for (size_t i = 0; i < GP_COUNT(middles); i++) {
        double corners[8][3], reach[2];
        for (int c = 0; c < 8; c++)
            vector_set(corners[c], c & 1, c >> 1 & 1, middles[i] + (c & 4 ? 0.5 : -0.5));
        assert_false(reach_find(corners, &camera, &axes, reach));
    }
}

static void depths_follow_from_the_share_of_the_way(void **state)
{
    (void)state;
    Random random = { 3 };
    for (int i = 0; i < TRIES; i++) {
        const Camera camera = random_camera(&random);
        const CameraAxes axes = camera_axes(&camera, (double)WIDTH / HEIGHT);
        const double share = random_between(&random, 0, 1),
                     end = random_between(&random, 1, camera.far);
        const double reach[2] = { random_between(&random, 1, end), end };
        double point[3], pixel[3];
        float depth[4];
        reach_depth(&camera, reach, depth);
        vector_add_scaled(camera.eye, reach[0] + share * (end - reach[0]), axes.forward, point);
        project(&camera, point, pixel);
        const double told = ((double)depth[0] + (double)depth[1] * share) /
                            ((double)depth[2] + (double)depth[3] * share);
        assert_true(fabs(told - pixel[2]) < 1e-6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_seen_point_is_in_the_rectangle_and_within_reach),
        cmocka_unit_test(rectangles_are_tight),
        cmocka_unit_test(what_is_behind_or_beyond_is_nowhere),
        cmocka_unit_test(depths_follow_from_the_share_of_the_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
