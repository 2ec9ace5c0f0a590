/* Distances to columns, against all columns asked one by one. */
#include "apps/depth_images/rivals/distance_field.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

enum { NX = 13, NY = 9, NZ = 11, SAMPLES = NX * NY * NZ };

static double nearest_column(const DistanceColumns *columns, uint32_t at[3])
{
    double least = HUGE_VAL;
    for (uint32_t y = 0; y < NY; y++)
        for (uint32_t x = 0; x < NX; x++) {
            const double top = (double)columns->z[y * NX + x], z = (double)at[2] / (NZ - 1);
            const double off[3] = { ((double)x - at[0]) / (NX - 1) * columns->metric[0],
                                    ((double)y - at[1]) / (NY - 1) * columns->metric[1],
                                    fmax(fmax(top - z, z - top - columns->thickness), 0) *
                                        columns->metric[2] };
            if (top <= 1)
                least = fmin(least, sqrt(off[0] * off[0] + off[1] * off[1] + off[2] * off[2]));
        }
    return least;
}

static void compare(const DistanceColumns *columns, double reach)
{
    static uint8_t codes[SAMPLES];
    assert_int_equal(distance_field_make(columns, reach, codes), GP_OK);
    for (uint32_t i = 0; i < SAMPLES; i++) {
        uint32_t at[3] = { i % NX, i / NX % NY, i / NX / NY };
        const double code = fmin(nearest_column(columns, at) / reach, 1) * 255;
        if (codes[i] != (uint8_t)code) /* rounding may go either way where it is whole */
            assert_true(fabs((double)codes[i] - code) < 1 + 1e-9 &&
                        fabs(code - round(code)) < 1e-9);
    }
}

static void distances_are_those_to_the_nearest_column(void **state)
{
    (void)state;
    Random random = { 7 };
    float z[NX * NY];
    for (int turn = 0; turn < 60; turn++) {
        DistanceColumns columns = { .z = z, .size = { NX, NY, NZ } };
        columns.thickness = (double)random_float(&random, 0, 1) * 0.3;
        for (int k = 0; k < 3; k++)
            columns.metric[k] = 0.1 + (double)random_float(&random, 0, 1);
        for (int i = 0; i < NX * NY; i++) /* some columns; at first all, in the end hardly any */
            z[i] =
                (double)random_float(&random, 0, 1) * 60 < turn ? 2 : random_float(&random, 0, 1);
        compare(&columns, 0.2 + (double)random_float(&random, 0, 1));
    }
}

static void nothing_is_near_where_nothing_stands(void **state)
{
    (void)state;
    float z[NX * NY];
    for (int i = 0; i < NX * NY; i++)
        z[i] = 2;
    const DistanceColumns columns = { .z = z, .size = { NX, NY, NZ }, .metric = { 1, 1, 1 } };
    compare(&columns, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_are_those_to_the_nearest_column),
        cmocka_unit_test(nothing_is_near_where_nothing_stands),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
