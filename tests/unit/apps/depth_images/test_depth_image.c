/* Pixels to points and back, by planes and cylinders that stand anywhere; places known by hand. */
#include "apps/base/camera.h"
#include "apps/depth_images/depth_image.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#define CLOSE(a, b) assert_true(fabs((a) - (b)) < 1e-12)

static const DepthPixels picture = { .width = 37, .height = 19 };

/* Three unit vectors, square to each other, right-handed. */
static void random_axes(Random *random, double a[3], double b[3], double c[3])
{
    do {
        for (int k = 0; k < 3; k++) {
            a[k] = (double)random_float(random, -1, 1);
            b[k] = (double)random_float(random, -1, 1);
        }
        vector_cross(a, b, c);
    } while (vector_dot(c, c) < 0.01);
    vector_normalize(a);
    vector_normalize(c);
    vector_cross(c, a, b);
}

static DepthPlane random_plane(Random *random, bool is_parallel)
{
    DepthPlane plane = { .is_parallel = is_parallel,
                         .left = (double)random_float(random, -1, 1),
                         .bottom = (double)random_float(random, -1, 1),
                         .width = (double)random_float(random, 0.1F, 2),
                         .height = (double)random_float(random, 0.1F, 2) };
    double back[3];
    random_axes(random, plane.right, plane.up, back);
    for (int k = 0; k < 3; k++) {
        plane.forward[k] = -back[k];
        plane.eye[k] = (double)random_float(random, -3, 3);
    }
    return plane;
}

static void point_and_place_of_a_plane_undo_each_other(void **state)
{
    (void)state;
    Random random = { 1 };
    for (int i = 0; i < 2000; i++) {
        const DepthPlane plane = random_plane(&random, i & 1);
        const double x = (double)random_float(&random, -5, 50);
        const double y = (double)random_float(&random, -5, 30);
        const double depth = (double)random_float(&random, 0.25F, 4);
        double point[3], place[2], again;
        depth_plane_point(&plane, &picture, x, y, depth, point);
        assert_true(depth_plane_place(&plane, &picture, point, place, &again));
        assert_true(fabs(place[0] - x) < 1e-9 && fabs(place[1] - y) < 1e-9);
        CLOSE(again, depth);
    }
}

/* A picture that is not about the eye: its corners are where left, bottom, width and height say. */
static void corners_of_pictures_beside_the_eye_are_where_they_are_said_to_be(void **state)
{
    (void)state;
    DepthPlane plane = { .eye = { 1, 2, 3 },
                         .right = { 1, 0, 0 },
                         .up = { 0, 1, 0 },
                         .forward = { 0, 0, -1 },
                         .left = 0.5,
                         .bottom = -2,
                         .width = 3,
                         .height = 1 };
    double point[3];
    depth_plane_point(&plane, &picture, 0, 0, 2, point);
    CLOSE(point[0], 1 + 2 * 0.5);
    CLOSE(point[1], 2 + 2 * -1.0);
    CLOSE(point[2], 1);
    depth_plane_point(&plane, &picture, picture.width, picture.height, 2, point);
    CLOSE(point[0], 1 + 2 * 3.5);
    CLOSE(point[1], 2 + 2 * -2.0);
    plane.is_parallel = true;
    depth_plane_point(&plane, &picture, 0, picture.height, 2, point);
    CLOSE(point[0], 1.5);
    CLOSE(point[1], 0);
    CLOSE(point[2], 1);
}

static void what_is_behind_the_eye_has_no_place(void **state)
{
    (void)state;
    DepthPlane plane = { .right = { 1, 0, 0 },
                         .up = { 0, 1, 0 },
                         .forward = { 0, 0, -1 },
                         .left = -1,
                         .bottom = -1,
                         .width = 2,
                         .height = 2 };
    const double before[3] = { 0, 0, -1 }, at[3] = { 0, 0, 0 }, behind[3] = { 0, 0, 1 };
    double place[2], depth;
    assert_true(depth_plane_place(&plane, &picture, before, place, &depth));
    assert_false(depth_plane_place(&plane, &picture, at, place, &depth));
    assert_false(depth_plane_place(&plane, &picture, behind, place, &depth));
    plane.is_parallel = true;
    assert_true(depth_plane_place(&plane, &picture, behind, place, &depth));
    CLOSE(depth, -1);
}

static void point_and_place_of_a_cylinder_undo_each_other(void **state)
{
    (void)state;
    Random random = { 2 };
    for (int i = 0; i < 2000; i++) {
        DepthCylinder cylinder = { .radius = (double)random_float(&random, 1, 3),
                                   .height = (double)random_float(&random, 0.5F, 3) };
        double aside[3];
        random_axes(&random, cylinder.zero, aside, cylinder.axis);
        for (int k = 0; k < 3; k++)
            cylinder.center[k] = (double)random_float(&random, -3, 3);
        const double x = (double)random_float(&random, 0, 36.99F);
        const double y = (double)random_float(&random, -5, 30);
        const double depth = (double)random_float(&random, -1, 0.75F);
        double point[3], place[2], again;
        depth_cylinder_point(&cylinder, &picture, x, y, depth, point);
        assert_true(depth_cylinder_place(&cylinder, &picture, point, place, &again));
        assert_true(fabs(place[0] - x) < 1e-9 && fabs(place[1] - y) < 1e-9);
        CLOSE(again, depth);
    }
}

/* A quarter of the picture on is `axis` x `zero`; half way is against `zero`; row 0 is the top. */
static void azimuths_and_heights_of_a_cylinder_run_as_they_are_said_to(void **state)
{
    (void)state;
    const DepthCylinder cylinder = {
        .center = { 5, 6, 7 }, .axis = { 0, 1, 0 }, .zero = { 0, 0, 1 }, .radius = 2, .height = 4
    };
    static const struct {
        double x, y, depth, point[3];
    } rows[] = {
        { 0, 0, 0, { 5, 8, 9 } },          { 37 / 4.0, 19, 0, { 7, 4, 7 } },
        { 37 / 2.0, 9.5, 0, { 5, 6, 5 } }, { 37 * 0.75, 9.5, 1.5, { 4.5, 6, 7 } },
        { 37, 9.5, 0.5, { 5, 6, 8.5 } },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        double point[3];
        depth_cylinder_point(&cylinder, &picture, rows[i].x, rows[i].y, rows[i].depth, point);
        for (int k = 0; k < 3; k++)
            CLOSE(point[k], rows[i].point[k]);
    }
    const double on_axis[3] = { 5, 7, 7 };
    double place[2], depth;
    assert_false(depth_cylinder_place(&cylinder, &picture, on_axis, place, &depth));
}

static void rooms_are_of_nothing_and_freed_whole(void **state)
{
    (void)state;
    DepthModel model = { .count = 1 };
    DepthPixels *front = &model.images[0].front;
    assert_int_equal(depth_pixels_make(5, 4, true, front), GP_OK);
    for (int i = 0; i < 20; i++)
        assert_true(isinf(front->depth[i]) && front->color[3 * i + 2] == 0);
    assert_non_null(front->normal);
    depth_model_free(&model);
    assert_true(model.count == 0 && !front->depth && front->width == 0);
    assert_int_equal(depth_pixels_make(UINT32_MAX, UINT32_MAX, false, front), GP_ERROR_MEMORY);
    assert_null(front->depth);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(point_and_place_of_a_plane_undo_each_other),
        cmocka_unit_test(corners_of_pictures_beside_the_eye_are_where_they_are_said_to_be),
        cmocka_unit_test(what_is_behind_the_eye_has_no_place),
        cmocka_unit_test(point_and_place_of_a_cylinder_undo_each_other),
        cmocka_unit_test(azimuths_and_heights_of_a_cylinder_run_as_they_are_said_to),
        cmocka_unit_test(rooms_are_of_nothing_and_freed_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
