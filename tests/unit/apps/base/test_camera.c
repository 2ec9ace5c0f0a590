/* Matrices of cameras, against their definitions and libm. */
#include "apps/base/camera.h"
#include "apps/base/orbit.h"
#include "pipeline/base/base.h"
#include "tests/support/unit.h"

#include <math.h>

static const Camera some_camera = {
    .eye = { 3, 2, 5 },
    .at = { 0.5, 1, -1 },
    .up = { 0, 1, 0.2 },
    .fovy = 40,
    .near = 0.5,
    .far = 50,
};

static void transform(double m[4][4], const double p[4], double out[4])
{
    for (int i = 0; i < 4; i++)
        out[i] = m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2] + m[i][3] * p[3];
}

static void near_to(double a, double b, double tolerance)
{
    if (!(fabs(a - b) <= tolerance))
        fail_msg("%.17g is not within %g of %.17g", a, tolerance, b);
}

static void sine_and_cosine_are_within_1e15_of_libm(void **state)
{
    (void)state;
    for (int i = -40000; i <= 40000; i++) {
        double degrees = i * 0.0371, s, c;
        angle_sincos(degrees, &s, &c);
        long double radians = (long double)degrees * 3.14159265358979323846264338L / 180;
        near_to(s, (double)sinl(radians), 1e-15);
        near_to(c, (double)cosl(radians), 1e-15);
    }
}

static void sine_and_cosine_are_exact_at_quarters(void **state)
{
    (void)state;
    for (int quarter = -9; quarter <= 9; quarter++) {
        double s, c;
        static const double sines[4] = { 0, 1, 0, -1 };
        angle_sincos(90.0 * quarter, &s, &c);
        assert_true(s == sines[quarter & 3]);
        assert_true(c == sines[(quarter + 1) & 3]);
    }
}

static void the_eye_is_the_origin_and_the_target_straight_ahead(void **state)
{
    (void)state;
    double view[4][4], eye[4], at[4];
    const double from[4] = { 3, 2, 5, 1 }, to[4] = { 0.5, 1, -1, 1 };
    camera_view(&some_camera, view);
    transform(view, from, eye);
    transform(view, to, at);
    for (int i = 0; i < 3; i++)
        near_to(eye[i], 0, 1e-14);
    near_to(at[0], 0, 1e-14);
    near_to(at[1], 0, 1e-14);
    near_to(at[2], -sqrt(2.5 * 2.5 + 1 + 36), 1e-14);
}

static void a_view_is_a_rotation_that_keeps_handedness(void **state)
{
    (void)state;
    double view[4][4], cross[3];
    camera_view(&some_camera, view);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            near_to(vector_dot(view[i], view[j]), i == j, 1e-14);
    vector_cross(view[0], view[1], cross);
    for (int i = 0; i < 3; i++)
        near_to(cross[i], view[2][i], 1e-14);
    assert_true(vector_dot(view[1], some_camera.up) > 0);
}

static void depth_runs_from_0_at_near_to_1_at_far(void **state)
{
    (void)state;
    for (int parallel = 0; parallel < 2; parallel++) {
        Camera camera = some_camera;
        camera.height = 2;
        camera.fovy = parallel ? 0 : 40;
        double m[4][4], near[4], far[4];
        camera_projection(&camera, 1.5, m);
        transform(m, (double[4]){ 0, 0, -0.5, 1 }, near);
        transform(m, (double[4]){ 0, 0, -50, 1 }, far);
        near_to(near[2] / near[3], 0, 1e-15);
        near_to(far[2] / far[3], 1, 1e-15);
        assert_true(near[3] > 0 && far[3] > 0);
    }
}

static void the_edge_of_the_field_of_view_is_the_edge_of_the_picture(void **state)
{
    (void)state;
    double m[4][4], top[4], right[4], tangent = tan(20 * 3.14159265358979323846 / 180);
    camera_projection(&some_camera, 1.5, m);
    transform(m, (double[4]){ 0, 7 * tangent, -7, 1 }, top);
    transform(m, (double[4]){ 7 * tangent * 1.5, 0, -7, 1 }, right);
    near_to(top[1] / top[3], 1, 1e-14);
    near_to(right[0] / right[3], 1, 1e-14);
}

static void parallel_rays_show_their_height(void **state)
{
    (void)state;
    Camera camera = some_camera;
    camera.fovy = 0;
    camera.height = 6;
    double m[4][4], corner[4];
    camera_projection(&camera, 2, m);
    transform(m, (double[4]){ 6, 3, -10, 1 }, corner);
    near_to(corner[0], 1, 1e-15);
    near_to(corner[1], 1, 1e-15);
    near_to(corner[3], 1, 0);
}

static void an_inverse_undoes_its_matrix(void **state)
{
    (void)state;
    double m[4][4], projection[4][4], view[4][4], inverse[4][4], product[4][4];
    camera_view(&some_camera, view);
    camera_projection(&some_camera, 1.5, projection);
    matrix_multiply(projection, view, m);
    assert_true(matrix_inverse(m, inverse) != 0);
    matrix_multiply(inverse, m, product);
    for (int i = 0; i < 16; i++)
        near_to(product[i / 4][i % 4], i / 4 == i % 4, 1e-12);
    memset(m[2], 0, sizeof m[2]);
    assert_true(matrix_inverse(m, inverse) == 0);
}

static void a_rotation_turns_right_handed_about_its_axis(void **state)
{
    (void)state;
    double m[4][4], out[4];
    matrix_rotation((double[3]){ 0, 2, 0 }, 90, m);
    transform(m, (double[4]){ 0, 0, 1, 1 }, out); /* z goes to x about y */
    near_to(out[0], 1, 1e-15);
    near_to(out[2], 0, 1e-15);
    matrix_rotation((double[3]){ 1, 1, 1 }, 120, m);
    transform(m, (double[4]){ 1, 0, 0, 1 }, out); /* x goes to y about the diagonal */
    near_to(out[0], 0, 1e-15);
    near_to(out[1], 1, 1e-15);
}

static void normals_stay_square_to_their_surface(void **state)
{
    (void)state;
    double m[4][4], n[3][3];
    const double a[4] = { 1, 2, 0.5, 0 }, b[4] = { -1, 0.3, 2, 0 };
    matrix_rotation((double[3]){ 1, 2, 3 }, 33, m);
    for (int i = 0; i < 3; i++) { /* a shear and unequal scales */
        m[0][i] = m[0][i] * 3 + m[1][i];
        m[2][i] *= 0.2;
    }
    matrix_normals(m, n);
    double normal[3], moved[3], ma[4], mb[4];
    vector_cross(a, b, normal);
    for (int i = 0; i < 3; i++)
        moved[i] = vector_dot(n[i], normal);
    transform(m, a, ma);
    transform(m, b, mb);
    near_to(vector_dot(moved, ma), 0, 1e-12);
    near_to(vector_dot(moved, mb), 0, 1e-12);
}

/* Of a point too there is a picture, with the point in its middle. */
static void an_orbit_about_a_point_has_a_matrix(void **state)
{
    (void)state;
    static const double points[][3] = { { 0, 0, 0 }, { 3, -4e6, 5 }, { 1e-12, 0, 0 } };
    const Orbit orbit = { .azimuth = 30, .elevation = 20, .zoom = 2 };
    for (size_t i = 0; i < GP_COUNT(points); i++) {
        const double *p = points[i], at[4] = { p[0], p[1], p[2], 1 };
        const Bounds seen = { { p[0], p[1], p[2] }, { p[0], p[1], p[2] } };
        const Camera camera = orbit_camera(&orbit, &seen, 1.5, 0);
        double view[4][4], eye[4];
        assert_true(camera.near > 0 && camera.far > camera.near);
        camera_view(&camera, view);
        transform(view, at, eye);
        const double distance = fabs(eye[2]);
        assert_true(distance > camera.near && distance < camera.far);
        assert_true(fabs(eye[0]) < 1e-6 * distance && fabs(eye[1]) < 1e-6 * distance);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sine_and_cosine_are_within_1e15_of_libm),
        cmocka_unit_test(sine_and_cosine_are_exact_at_quarters),
        cmocka_unit_test(the_eye_is_the_origin_and_the_target_straight_ahead),
        cmocka_unit_test(a_view_is_a_rotation_that_keeps_handedness),
        cmocka_unit_test(depth_runs_from_0_at_near_to_1_at_far),
        cmocka_unit_test(the_edge_of_the_field_of_view_is_the_edge_of_the_picture),
        cmocka_unit_test(parallel_rays_show_their_height),
        cmocka_unit_test(an_inverse_undoes_its_matrix),
        cmocka_unit_test(a_rotation_turns_right_handed_about_its_axis),
        cmocka_unit_test(normals_stay_square_to_their_surface),
        cmocka_unit_test(an_orbit_about_a_point_has_a_matrix),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
