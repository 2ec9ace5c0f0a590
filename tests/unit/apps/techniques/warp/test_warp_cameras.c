/* Cameras of depth images are those that took them, and turn about what they look at. */
#include "apps/depth_images/capture.h"
#include "apps/techniques/warp/cameras.h"
#include "tests/support/unit.h"

#include <math.h>

static const Bounds box = { { -1, -2, -1 }, { 2, 1, 1 } };

static const Camera cameras[] = {
    { .eye = { 3, 2, 6 },
      .at = { 0.5, -0.5, 0 },
      .up = { 0, 1, 0 },
      .fovy = 35,
      .near = 1,
      .far = 20 },
    { .eye = { -4, 1, -5 },
      .at = { 0, 0, 0 },
      .up = { 1, 0, 0 },
      .height = 7,
      .near = 1,
      .far = 20 },
};

static void assert_near(const double a[3], const double b[3])
{
    for (int k = 0; k < 3; k++)
        assert_true(fabs(a[k] - b[k]) < 1e-12);
}

static void a_planes_camera_is_the_one_that_took_it(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(cameras); i++) {
        const DepthPlane plane = depth_plane_of_camera(&cameras[i], 1.5);
        const Camera found = camera_of_plane(&plane, &box);
        const CameraAxes a = camera_axes(&cameras[i], 1.5), b = camera_axes(&found, 1.5);
        assert_near(a.right, b.right);
        assert_near(a.up, b.up);
        assert_near(a.forward, b.forward);
        assert_true(fabs(a.half_height - b.half_height) < 1e-9);
        if (cameras[i].fovy > 0)
            assert_near(cameras[i].eye, found.eye);
    }
}

/* A window that is not about the eye is within the picture of one that is. */
static void windows_off_the_middle_are_seen_whole(void **state)
{
    (void)state;
    DepthPlane plane = depth_plane_of_camera(&cameras[0], 1);
    plane.bottom += 0.2;
    const Camera seen = camera_of_plane(&plane, &box);
    const CameraAxes axes = camera_axes(&seen, 1);
    assert_true(axes.half_height > plane.bottom + plane.height - 1e-9);
}

/* In pixels of a picture all of the box is between near and far, from everywhere. */
static void turned_cameras_see_the_box_between_near_and_far(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(cameras); i++)
        for (int degrees = -180; degrees <= 180; degrees += 30) {
            const Camera turned = camera_turned(&cameras[i], &box, degrees);
            const CameraAxes axes = camera_axes(&turned, 1);
            double before[3], after[3];
            vector_subtract(cameras[i].eye, cameras[i].at, before);
            vector_subtract(turned.eye, turned.at, after);
            if (cameras[i].fovy > 0)
                assert_true(fabs(vector_dot(before, before) - vector_dot(after, after)) < 1e-9);
            for (int corner = 0; corner < 8; corner++) {
                double from[3];
                for (int k = 0; k < 3; k++)
                    from[k] = (corner >> k & 1 ? box.high[k] : box.low[k]) - turned.eye[k];
                const double ahead = vector_dot(from, axes.forward);
                assert_true(ahead > turned.near - 1e-9 && ahead < turned.far + 1e-9);
            }
        }
}

/* A model in any unit is seen alike; and one that is a point, from a range about it. */
static void ranges_have_no_unit(void **state)
{
    (void)state;
    for (int e = -30; e <= 18; e += 6) {
        const double unit = pow(10, e);
        Bounds small = box;
        Camera camera = cameras[0];
        camera.near *= unit;
        camera.far *= unit;
        for (int k = 0; k < 3; k++) {
            small.low[k] *= unit;
            small.high[k] *= unit;
            camera.eye[k] *= unit;
            camera.at[k] *= unit;
        }
        const Camera at_one = camera_turned(&cameras[0], &box, 40);
        Camera turned = camera_turned(&camera, &small, 40);
        assert_true(fabs(turned.near / unit - at_one.near) < 1e-9);
        assert_true(fabs(turned.far / unit - at_one.far) < 1e-9);
        small.high[0] = small.low[0] = camera.at[0];
        small.high[1] = small.low[1] = camera.at[1];
        small.high[2] = small.low[2] = camera.at[2];
        turned = camera_turned(&camera, &small, 0);
        double line[3];
        vector_subtract(camera.at, camera.eye, line);
        const double ahead = sqrt(vector_dot(line, line));
        assert_true(turned.near > 0.99 * ahead && turned.near < ahead && turned.far > ahead);
    }
}

static void images_of_nothing_have_a_place(void **state)
{
    (void)state;
    float depth[2] = { DEPTH_NOTHING, DEPTH_NOTHING };
    DepthModel model = { .count = 1 };
    model.images[0].plane = depth_plane_of_camera(&cameras[0], 2);
    model.images[0].front = (DepthPixels){ .width = 2, .height = 1, .depth = depth };
    Bounds bounds = bounds_of_images(&model);
    assert_true(bounds_longest(&bounds) > 0 && isfinite(bounds.low[0]) && isfinite(bounds.high[2]));
    depth[1] = 3;
    bounds = bounds_of_images(&model);
    double point[3];
    depth_plane_point(&model.images[0].plane, &model.images[0].front, 1.5, 0.5, 3, point);
    assert_near(bounds.low, point);
    assert_near(bounds.high, point);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_planes_camera_is_the_one_that_took_it),
        cmocka_unit_test(windows_off_the_middle_are_seen_whole),
        cmocka_unit_test(turned_cameras_see_the_box_between_near_and_far),
        cmocka_unit_test(ranges_have_no_unit),
        cmocka_unit_test(images_of_nothing_have_a_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
