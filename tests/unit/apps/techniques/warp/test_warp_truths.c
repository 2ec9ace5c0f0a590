/* What is measured of warped pictures, on pictures of a few pixels by hand. */
#include "apps/techniques/warp/truths.h"
#include "tests/support/unit.h"

#include <math.h>
#include <string.h>

static const Camera camera = {
    .at = { 0, 0, -1 }, .up = { 0, 1, 0 }, .fovy = 90, .near = 1, .far = 10
};

/* A depth as the buffer of a camera has it. */
static float buffered(const Camera *of, double depth)
{
    return of->fovy > 0 ? (float)(of->far / (of->far - of->near) * (1 - of->near / depth))
                        : (float)((depth - of->near) / (of->far - of->near));
}

enum { PIXELS = 4 };

/* Both cover the first two; the truth alone the third, the picture alone the last. */
static WarpError measure(const Camera *of)
{
    double colors[3 * PIXELS] = { 0.2, 0.4, 0.6, 0, 1, 0, 0.5, 0.5, 0.5 };
    double depths[PIXELS] = { 2, 4, 3, (double)INFINITY };
    RayPicture truth = { PIXELS, 1, colors, depths };
    uint8_t texels[4 * PIXELS] = { 153, 102, 51, 255, 51, 255, 0, 255, 9, 9, 9, 0, 0, 0, 255, 255 };
    float buffer[PIXELS] = { buffered(of, 2.25), buffered(of, 4.5), 1, buffered(of, 3) };
    GpSurface color = { .width = PIXELS, .height = 1 }, depth = { .width = PIXELS, .height = 1 };
    WarpError off;
    color.level[0].texels = texels;
    depth.level[0].texels = (uint8_t *)buffer;
    assert_int_equal(warp_error(&truth, of, &color, &depth, &off), GP_OK);
    return off;
}

static void figures_are_those_by_hand(void **state)
{
    (void)state;
    Camera parallel = camera;
    parallel.fovy = 0;
    parallel.height = 2;
    const Camera *const cameras[] = { &camera, &parallel };
    for (size_t i = 0; i < GP_COUNT(cameras); i++) {
        const WarpError off = measure(cameras[i]);
        assert_true(off.covered == 3 && off.both == 2 && off.missing == 1 && off.extra == 1);
        assert_true(fabs(off.interior_psnr - 10 * log10(6 / 0.04)) < 1e-9); /* one channel by 0.2 */
        assert_true(fabs(off.depth_mean - 0.375) < 1e-5 && fabs(off.depth_error - 0.5) < 1e-5);
        assert_true(fabs(off.rmse - sqrt((0.04 + 0.75 + 1) / 12)) < 1e-9);
    }
}

/* A pixel each way from the middle, from the same eye, is looked up whatever the picture's size. */
static void a_depth_image_is_a_truth_from_its_eye(void **state)
{
    (void)state;
    float depths[4] = { 3, 5, DEPTH_NOTHING, 7 },
          colors[12] = { 1, 0, 0, 0, 1, 0, 9, 9, 9, 0, 0, 1 };
    DepthImage image = { .plane = { .right = { 1, 0, 0 },
                                    .up = { 0, 1, 0 },
                                    .forward = { 0, 0, -1 },
                                    .left = -1,
                                    .bottom = -1,
                                    .width = 2,
                                    .height = 2 },
                         .front = { 2, 2, depths, colors, NULL } };
    WarpView view = { .camera = camera, .width = 4, .height = 4 };
    RayPicture truth;
    GpError error;
    assert_int_equal(warp_truth_of_image(&image, &view, &truth, &error), GP_OK);
    assert_true(fabs(truth.depth[0] - 3) < 1e-6 && fabs(truth.depth[3] - 5) < 1e-6);
    assert_true(isinf(truth.depth[12]) && truth.color[36] == 0);
    assert_true(fabs(truth.depth[15] - 7) < 1e-6 && truth.color[47] == 1);
    ray_picture_free(&truth);
    view.camera.eye[0] = 0.1;
    assert_int_equal(warp_truth_of_image(&image, &view, &truth, &error), GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "from the eye of the view"));
}

static void a_mesh_that_is_not_finite_has_no_truth(void **state)
{
    (void)state;
    const float positions[9] = { 0, 0, -2, 1, 0, -2, 0, (float)INFINITY, -2 };
    const uint32_t indices[3] = { 0, 1, 2 };
    const Polygons mesh = { .positions = positions, .indices = indices, .triangle_count = 1 };
    const WarpView view = { .camera = camera, .width = 4, .height = 4 };
    RayPicture truth;
    GpError error;
    assert_int_equal(warp_truth_of_mesh(&mesh, &view, 1, &truth, &error), GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "finite coordinates"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(figures_are_those_by_hand),
        cmocka_unit_test(a_mesh_that_is_not_finite_has_no_truth),
        cmocka_unit_test(a_depth_image_is_a_truth_from_its_eye),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
