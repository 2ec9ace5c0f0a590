/* The light that goes with a camera. */
#include "apps/depth_images/drawing/light.h"

#include "tests/support/random.h"
#include "tests/support/unit.h"

static void it_stands_before_the_picture_to_the_left_and_above(void **state)
{
    (void)state;
    Random random = { 1 };
    for (int i = 0; i < 100; i++) {
        Camera camera = {
            .up = { 0, 1, 0.1 }, .fovy = i & 1 ? 40 : 0, .height = 2, .near = 1, .far = 9
        };
        for (int k = 0; k < 3; k++) {
            camera.eye[k] = (double)random_float(&random, -9, 9);
            camera.at[k] = (double)random_float(&random, -2, 2);
        }
        const CameraAxes axes = camera_axes(&camera, 1);
        const WarpLight light = warp_light_beside(&camera);
        assert_true(light.directional);
        assert_true(fabs(vector_dot(light.position, light.position) - 1) < 1e-12);
        assert_true(vector_dot(light.position, axes.right) < -0.2);
        assert_true(vector_dot(light.position, axes.up) > 0.2);
        assert_true(vector_dot(light.position, axes.forward) < -0.5);
        for (int k = 0; k < 3; k++)
            assert_true(light.color[k] == light.color[0] && light.ambient[k] == light.ambient[0]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_stands_before_the_picture_to_the_left_and_above),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
