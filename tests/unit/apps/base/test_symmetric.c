/* Spreads of points and their axes: what the definitions say, of matrices of all kinds. */
#include "apps/base/symmetric.h"

#include "apps/base/vector.h"
#include "pipeline/base/base.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

static void multiply(const Symmetric *matrix, const double v[3], double out[3])
{
    const double *m = matrix->m;
    vector_set(out, m[0] * v[0] + m[5] * v[1] + m[4] * v[2],
               m[5] * v[0] + m[1] * v[1] + m[3] * v[2], m[4] * v[0] + m[3] * v[1] + m[2] * v[2]);
}

/* Orthonormal, right-handed, largest first, and A v = value v. */
static void check_eigen(const Symmetric *matrix)
{
    double values[3], vectors[3][3], third[3], size = 0;
    symmetric_eigen(matrix, values, vectors);
    for (int i = 0; i < 6; i++)
        size = fmax(size, fabs(matrix->m[i]));
    for (int i = 0; i < 3; i++) {
        double image[3];
        multiply(matrix, vectors[i], image);
        for (int k = 0; k < 3; k++) {
            assert_true(fabs(image[k] - values[i] * vectors[i][k]) <= 1e-14 * size);
            assert_true(fabs(vector_dot(vectors[i], vectors[k]) - (i == k)) < 1e-14);
        }
        assert_true(i == 0 || values[i] <= values[i - 1]);
    }
    vector_cross(vectors[0], vectors[1], third);
    assert_true(vector_dot(third, vectors[2]) > 0);
    assert_true(fabs(values[0] + values[1] + values[2] -
                     (matrix->m[0] + matrix->m[1] + matrix->m[2])) <= 1e-14 * size);
}

static void eigenvectors_are_what_the_matrix_only_scales(void **state)
{
    (void)state;
    static const Symmetric rows[] = {
        { { 0 } },
        { { 1, 2, 3, 0, 0, 0 } },
        { { 3, 2, 1, 0, 0, 0 } },
        { { 5, 5, 5, 0, 0, 0 } },          /* all directions alike */
        { { 1, 1, 1, 1, 1, 1 } },          /* one direction, and a plane of nothing */
        { { 0, 0, 0, 1, 1, 1 } },          /* nothing on the diagonal */
        { { -1, -2, -3, .5, .5, .5 } },    /* below 0 */
        { { 1, 1, 1, 1e-9, 0, 0 } },       /* almost alike */
        { { 1e200, 1, 1e-200, 0, 1, 0 } }, /* far apart */
        { { 2e-150, 1e-150, 3e-150, 1e-150, 0, -1e-150 } },
    };
    Random random = { 1 };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        check_eigen(&rows[i]);
    for (int i = 0; i < 2000; i++) {
        Symmetric matrix;
        for (int k = 0; k < 6; k++)
            matrix.m[k] = random_int(&random, 0, 5) ? random_between(&random, -9, 9) : 0;
        check_eigen(&matrix);
    }
}

/* The 64th power of a ratio of 0.8 is below one millionth. */
static void the_long_axis_is_the_first_eigenvector(void **state)
{
    (void)state;
    Random random = { 2 };
    int checked = 0;
    for (int i = 0; i < 2000; i++) {
        Moments moments = { .count = 0 };
        float point[3];
        double stretch[3], values[3], vectors[3][3], axis[3];
        for (int k = 0; k < 3; k++)
            stretch[k] = random_between(&random, 0, 4);
        for (int p = 0; p < 20; p++) {
            const double along = random_between(&random, -5, 5);
            for (int k = 0; k < 3; k++)
                point[k] = (float)(stretch[k] * along + random_between(&random, -1, 1));
            moments_add(&moments, point);
        }
        const Symmetric spread = moments_covariance(&moments);
        symmetric_eigen(&spread, values, vectors);
        symmetric_long_axis(&spread, axis);
        assert_true(fabs(vector_dot(axis, axis) - 1) < 1e-14);
        if (values[1] > 0.8 * values[0])
            continue;
        checked++;
        assert_true(fabs(vector_dot(axis, vectors[0])) > 1 - 1e-6);
    }
    assert_true(checked > 1000);
}

static void what_has_no_spread_is_long_along_x(void **state)
{
    (void)state;
    double axis[3];
    symmetric_long_axis(&(Symmetric){ { 0 } }, axis);
    assert_true(axis[0] == 1 && axis[1] == 0 && axis[2] == 0);
}

/* A million away. */
static void moments_are_the_mean_square_from_the_mean(void **state)
{
    (void)state;
    enum { POINTS = 50 };
    Random random = { 3 };
    float points[POINTS][3];
    Moments moments = { .origin = { 1e6, -1e6, 5e5 } };
    double mean[3] = { 0 };
    for (int p = 0; p < POINTS; p++) {
        for (int k = 0; k < 3; k++)
            points[p][k] = (float)(moments.origin[k] + random_between(&random, -8, 8));
        moments_add(&moments, points[p]);
        for (int k = 0; k < 3; k++)
            mean[k] += (double)points[p][k] / POINTS;
    }
    const Symmetric covariance = moments_covariance(&moments);
    static const int row[6] = { 0, 1, 2, 1, 0, 0 }, column[6] = { 0, 1, 2, 2, 2, 1 };
    for (int i = 0; i < 6; i++) {
        double sum = 0;
        for (int p = 0; p < POINTS; p++)
            sum += ((double)points[p][row[i]] - mean[row[i]]) *
                   ((double)points[p][column[i]] - mean[column[i]]);
        assert_true(fabs(covariance.m[i] - sum / POINTS) < 1e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eigenvectors_are_what_the_matrix_only_scales),
        cmocka_unit_test(the_long_axis_is_the_first_eigenvector),
        cmocka_unit_test(what_has_no_spread_is_long_along_x),
        cmocka_unit_test(moments_are_the_mean_square_from_the_mean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
