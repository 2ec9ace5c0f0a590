/* Cells of points in a plane, against polygons that are cut by the bisectors of all points, one by
 * one. */
#define POOL_THREADS 3
#include "apps/points/cloud/cells.h"

#include "apps/base/vector.h"
#include "tests/support/groups/pool.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { POINTS = 900, CORNERS = 64 };

typedef struct Polygon {
    double corner[CORNERS][2];
    int count;
} Polygon;

/* Keeps what is nearer to 0 than to a place. */
static Polygon cut(const Polygon *whole, const double place[2])
{
    Polygon rest = { .count = 0 };
    const double middle = (place[0] * place[0] + place[1] * place[1]) / 2;
    for (int i = 0; i < whole->count; i++) {
        const double *a = whole->corner[i], *b = whole->corner[(i + 1) % whole->count];
        const double beyond_a = a[0] * place[0] + a[1] * place[1] - middle;
        const double beyond_b = b[0] * place[0] + b[1] * place[1] - middle;
        assert_true(rest.count + 2 < CORNERS);
        if (beyond_a <= 0)
            memcpy(rest.corner[rest.count++], a, sizeof rest.corner[0]);
        if ((beyond_a < 0) != (beyond_b < 0) && beyond_a != 0 && beyond_b != 0)
            for (int k = 0, at = rest.count++; k < 2; k++)
                rest.corner[at][k] = a[k] + beyond_a / (beyond_a - beyond_b) * (b[k] - a[k]);
    }
    return rest;
}

static double area_of(const Polygon *polygon)
{
    double twice = 0;
    for (int i = 0; i < polygon->count; i++) {
        const double *a = polygon->corner[i], *b = polygon->corner[(i + 1) % polygon->count];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice / 2;
}

static double reach_of(const Polygon *polygon)
{
    double reach = 0;
    for (int i = 0; i < polygon->count; i++)
        reach = fmax(reach, sqrt(polygon->corner[i][0] * polygon->corner[i][0] +
                                 polygon->corner[i][1] * polygon->corner[i][1]));
    return reach;
}

/* The cell of a point among all; nearer: how many are within twice its reach. */
static Polygon find_slowly(double (*flat)[2], int point, int *nearer)
{
    Polygon cell = { { { -900, -900 }, { 900, -900 }, { 900, 900 }, { -900, 900 } }, 4 };
    for (int pass = 0; pass < 2; pass++) {
        const double most = pass ? 2 * reach_of(&cell) : 0;
        *nearer = 0;
        for (int i = 0; i < POINTS; i++) {
            const double place[2] = { flat[i][0] - flat[point][0], flat[i][1] - flat[point][1] };
            if (i == point)
                continue;
            if (!pass)
                cell = cut(&cell, place);
            *nearer += sqrt(place[0] * place[0] + place[1] * place[1]) < most;
        }
    }
    return cell;
}

/* A square of points, turned in space: its inner cells are closed by their neighbours. */
static void cells_in_a_plane_are_what_is_nearest(void **state)
{
    (void)state;
    static double flat[POINTS][2];
    static float positions[3 * POINTS], normals[3 * POINTS], radii[POINTS], areas[POINTS];
    Random random = { 1 };
    double axis[3][3] = { { 2, 1, -1 }, { 0, 1, 1 } };
    NeighbourTree tree;
    CellFacts facts;
    vector_cross(axis[0], axis[1], axis[2]);
    for (int i = 0; i < 3; i++)
        vector_normalize(axis[i]);
    for (int i = 0; i < POINTS; i++)
        for (int k = 0; k < 3; k++) {
            if (k < 2)
                flat[i][k] = (double)random_float(&random, -50, 50);
            normals[3 * i + k] = (float)axis[2][k];
        }
    for (int i = 0; i < 3 * POINTS; i++)
        positions[i] = (float)(flat[i / 3][0] * axis[0][i % 3] + flat[i / 3][1] * axis[1][i % 3]);
    assert_int_equal(neighbour_tree_build(positions, POINTS, pool, &tree), GP_OK);
    assert_int_equal(cells_measure(&tree, normals, pool, radii, areas, &facts), GP_OK);
    int checked = 0;
    for (int i = 0; i < POINTS; i++) {
        int nearer;
        const Polygon cell = find_slowly(flat, i, &nearer);
        const double area = area_of(&cell), reach = reach_of(&cell);
        if (nearer >= CELLS_NEIGHBOURS)
            continue;
        checked++;
        assert_true(fabs((double)areas[i] - area) < 1e-5 * area + 1e-8);
        assert_true(fabs((double)radii[i] - reach) < 1e-4 * reach);
    }
    print_message("# %d of %d closed\n", checked, POINTS);
    assert_true(checked > POINTS / 2);
    neighbour_tree_free(&tree);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_in_a_plane_are_what_is_nearest),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
