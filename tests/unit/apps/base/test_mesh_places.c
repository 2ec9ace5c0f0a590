/* Places of vertices: numbered as a comparison of their coordinates orders them. */
#include "apps/base/mesh_places.h"
#include "tests/support/unit.h"

#include <stdlib.h>
#include <string.h>

enum { VERTICES = 5000 };

static float positions[VERTICES][3];

static int compare(const void *a, const void *b)
{
    const float *p = positions[*(const uint32_t *)a], *q = positions[*(const uint32_t *)b];
    for (int k = 0; k < 3; k++)
        if (p[k] != q[k])
            return p[k] < q[k] ? -1 : 1;
    return 0;
}

/* Few values, so that many places have several vertices; zeros of both signs, subnormals and the
 * largest. */
static void scatter(void)
{
    static const float values[] = { 0,    -0.0f,  1e-45f,   -1e-45f,     1,
                                    -1,   -2,     1.00001f, 3.40282e38f, -3.40282e38f,
                                    0.5f, -0.25f, 7,        7.000001f };
    uint32_t random = 3;
    for (int i = 0; i < VERTICES; i++)
        for (int k = 0; k < 3; k++) {
            random = random * 1664525 + 1013904223;
            positions[i][k] = values[(random >> 16) % GP_COUNT(values)];
        }
}

static void places_are_numbered_by_x_then_y_then_z(void **state)
{
    (void)state;
    static uint32_t order[VERTICES], place_of[VERTICES];
    scatter();
    for (uint32_t i = 0; i < VERTICES; i++)
        order[i] = i;
    qsort(order, VERTICES, sizeof *order, compare);
    assert_int_equal(mesh_places(positions[0], VERTICES, place_of), GP_OK);
    uint32_t number = 0;
    for (uint32_t i = 0; i < VERTICES; i++) {
        number += i > 0 && compare(&order[i - 1], &order[i]) != 0;
        assert_int_equal(place_of[order[i]], number);
    }
    assert_true(number > 1000 && number < VERTICES / 2);
}

static void one_vertex_has_one_place_and_none_has_none(void **state)
{
    (void)state;
    uint32_t place_of[1] = { 9 };
    assert_int_equal(mesh_places(positions[0], 0, place_of), GP_OK);
    assert_int_equal(place_of[0], 9);
    assert_int_equal(mesh_places(positions[0], 1, place_of), GP_OK);
    assert_int_equal(place_of[0], 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places_are_numbered_by_x_then_y_then_z),
        cmocka_unit_test(one_vertex_has_one_place_and_none_has_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
