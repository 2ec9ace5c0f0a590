/* Boxes, and cameras that look at them from around. */
#include "apps/base/orbit.h"
#include "tests/support/unit.h"

#include <math.h>

static const float corners[][4] = { { 1, 2, 3, 9 }, { -1, 5, 2, 9 }, { 100, 100, 100, 9 } };

static void a_box_has_what_is_referred_to(void **state)
{
    (void)state;
    static const uint32_t indices[] = { 1, 0, 1 };
    const Bounds some = bounds_of(corners[0], sizeof corners[0], indices, 3);
    const Bounds first = bounds_of(corners[0], sizeof corners[0], NULL, 2);
    const Bounds expected = { { -1, 2, 2 }, { 1, 5, 3 } };
    assert_memory_equal(&some, &expected, sizeof some);
    assert_memory_equal(&first, &expected, sizeof first);
    assert_float_equal(bounds_longest(&some), 3, 0);
}

static void nothing_adds_nothing(void **state)
{
    (void)state;
    const Bounds none = bounds_of(NULL, 12, NULL, 0);
    const Bounds one = { { 1, 2, 3 }, { 4, 5, 6 } };
    Bounds both = none;
    assert_true(none.low[0] > none.high[0]);
    assert_float_equal(bounds_longest(&none), 0, 0);
    bounds_join(&both, &one);
    bounds_join(&both, &none);
    assert_memory_equal(&both, &one, sizeof both);
}

/* Largest absolute coordinate of the box's corners in the picture, whose border is 1. */
static double farthest_corner(const Camera *camera, const Bounds *box, double aspect)
{
    float clip[4][4];
    double most = 0;
    camera_matrix(camera, aspect, clip);
    for (int corner = 0; corner < 8; corner++) {
        double out[4];
        for (int row = 0; row < 4; row++) {
            out[row] = (double)clip[row][3];
            for (int k = 0; k < 3; k++)
                out[row] += (double)clip[row][k] * (corner >> k & 1 ? box->high[k] : box->low[k]);
        }
        assert_true(out[3] > 0 && out[2] >= 0 && out[2] <= out[3]);
        most = fmax(most, fmax(fabs(out[0]), fabs(out[1])) / out[3]);
    }
    return most;
}

static void an_orbit_has_all_of_the_box_in_the_picture(void **state)
{
    (void)state;
    static const Bounds box = { { 10, -20, 30 }, { 40, 60, 35 } };
    for (OrbitUp up = ORBIT_UP_Y; up <= ORBIT_DOWN_Z; up++)
        for (double azimuth = -180; azimuth < 180; azimuth += 33)
            for (double aspect = 0.5; aspect < 3; aspect *= 2) {
                Orbit orbit = { azimuth, azimuth / 3, up, 1 };
                Camera camera = orbit_camera(&orbit, &box, aspect, 1e-3);
                const double fits = farthest_corner(&camera, &box, aspect);
                assert_true(fits > 0.9 && fits < 1);
                orbit.zoom = 2;
                camera = orbit_camera(&orbit, &box, aspect, 1e-3);
                assert_true(fabs(farthest_corner(&camera, &box, aspect) - 2 * fits) < 1e-3);
            }
}

static void an_orbit_starts_in_front_and_turns_right_and_up(void **state)
{
    (void)state;
    static const Bounds box = { { -1, -1, -1 }, { 1, 1, 1 } };
    const Orbit front = { .zoom = 1 }, right = { .azimuth = 90, .zoom = 1 },
                above = { .elevation = 80, .zoom = 1 };
    const Camera camera = orbit_camera(&front, &box, 1, 0.1);
    assert_true(camera.eye[2] > 1 && camera.up[1] > 0.99);
    assert_float_equal(camera.eye[0], 0, 1e-12);
    assert_true(orbit_camera(&right, &box, 1, 0.1).eye[0] > 1);
    assert_true(orbit_camera(&above, &box, 1, 0.1).eye[1] > 1);
    assert_float_equal(orbit_camera(&front, &box, 1, 3).near, fmax(3, camera.near), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_has_what_is_referred_to),
        cmocka_unit_test(nothing_adds_nothing),
        cmocka_unit_test(an_orbit_has_all_of_the_box_in_the_picture),
        cmocka_unit_test(an_orbit_starts_in_front_and_turns_right_and_up),
    };
    return cmocka_run_group_tests_name("bounds", tests, NULL, NULL);
}
