/* Points that are spread over a mesh lie on it, everywhere, and evenly. */
#include "apps/points/cloud/neighbours.h"
#include "apps/points/sample.h"
#include "apps/points/subdivide.h"
#include "apps/points/triangle.h"
#include "apps/points/vertices.h"
#include "tests/support/groups/pool.h"
#include "tests/support/meshes/named_mesh.h"
#include "tests/support/unit.h"

#include <math.h>
#include <string.h>

static GpPoints sample(const GpMesh *mesh, uint32_t count)
{
    GpPoints points;
    assert_int_equal(mesh_sample(mesh, count, &points), GP_OK);
    assert_int_equal(points.count, count);
    return points;
}

/* Of the distances from each point to its nearest: deviation / mean, and the mean as a part of that
 * in the densest lattice. White noise has 0.52 and 0.47, a square lattice 0 and 0.93. */
static void measure_evenness(const GpPoints *points, double area, double *deviation, double *mean)
{
    NeighbourTree tree;
    double sum = 0, squares = 0;
    assert_int_equal(neighbour_tree_build(points->positions, points->count, pool, &tree), GP_OK);
    for (uint32_t rank = 0; rank < points->count; rank++) {
        Neighbour nearest;
        neighbours_of(&tree, rank, 1, 0, &nearest);
        sum += sqrt(nearest.distance2);
        squares += nearest.distance2;
    }
    const double average = sum / points->count;
    *deviation = sqrt(squares / points->count - average * average) / average;
    *mean = average / sqrt(1.1547005383792515 * area / points->count);
    neighbour_tree_free(&tree);
}

/* Triangles much larger than the distances between points, and much smaller. */
static void points_are_far_more_even_than_noise(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint32_t count;
    } cases[] = { { "builtin:cube", 20000 }, { "builtin:torus", 1000 }, { "builtin:ball", 5000 } };
    for (size_t c = 0; c < GP_COUNT(cases); c++) {
        GpMesh mesh = referenced_mesh(cases[c].name);
        GpPoints points = sample(&mesh, cases[c].count);
        double deviation, mean;
        measure_evenness(&points, mesh_area(&mesh), &deviation, &mean);
        print_message("%s: %u points, deviation %.3f, mean %.3f\n", cases[c].name, points.count,
                      deviation, mean);
        assert_true(deviation < 0.16 && mean > 0.7);
        gp_points_free(&points);
        gp_mesh_free(&mesh);
    }
}

static void points_lie_on_the_surface_with_its_normals_and_colors(void **state)
{
    (void)state;
    GpMesh mesh = referenced_mesh("builtin:sphere");
    gp_free(mesh.colors);
    mesh.colors = gp_alloc(4 * (size_t)mesh.vertex_count, sizeof(float));
    for (size_t v = 0; v < mesh.vertex_count; v++)
        mesh.colors[4 * v + 1] = mesh.positions[3 * v + 1] * 0.5F + 0.5F;
    GpPoints points = sample(&mesh, 3000);
    double low = 1, high = -1;
    for (size_t i = 0; i < points.count; i++) {
        const float *at = points.positions + 3 * i, *normal = points.normals + 3 * i;
        const double radius = sqrt(triangle_side(at, (const float[3]){ 0 }));
        const double dot = (double)at[0] * (double)normal[0] + (double)at[1] * (double)normal[1] +
                           (double)at[2] * (double)normal[2];
        if (!(radius > 0.99 && radius < 1.0001 && dot > 0.998 * radius))
            fail_msg("point %zu: radius %g, cosine %g", i, radius, dot / radius);
        assert_true(fabs(points.colors[3 * i + 1] / 255.0 - ((double)at[1] * 0.5 + 0.5)) < 0.003);
        low = fmin(low, (double)at[1]);
        high = fmax(high, (double)at[1]);
    }
    assert_true(low < -0.99 && high > 0.99);
    gp_points_free(&points);
    gp_mesh_free(&mesh);
}

/* A square of two sides: each has its points. */
static void both_sides_of_a_sheet_have_points(void **state)
{
    (void)state;
    float positions[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 }, normals[12] = { 0 };
    uint32_t indices[12] = { 0, 1, 2, 0, 2, 3, 2, 1, 0, 3, 2, 0 };
    for (int vertex = 0; vertex < 4; vertex++)
        normals[3 * vertex + 2] = 1;
    const GpMesh mesh = { .positions = positions,
                          .normals = normals,
                          .indices = indices,
                          .vertex_count = 4,
                          .triangle_count = 4 };
    GpPoints points = sample(&mesh, 2000);
    double deviation, mean;
    measure_evenness(&points, 1, &deviation, &mean); /* as if of one side */
    assert_true(mean < 0.7); /* sides do not keep a distance from each other */
    gp_points_free(&points);
    assert_int_equal(mesh_sample(&mesh, 0, &points), GP_ERROR_INVALID);
}

static void degenerate_meshes_and_few_points_are_sampled(void **state)
{
    (void)state;
    float positions[9] = { 1, 1, 1, 1, 1, 1, 1, 1, 1 }, normals[9] = { 0, 0, 1, 0, 0, 1, 0, 0, 1 };
    uint32_t indices[3] = { 0, 1, 2 };
    const GpMesh mesh = { .positions = positions,
                          .normals = normals,
                          .indices = indices,
                          .vertex_count = 3,
                          .triangle_count = 1 };
    GpPoints points;
    assert_int_equal(mesh_sample(&mesh, 5, &points), GP_ERROR_INVALID);
    positions[3] = 2;
    positions[7] = 2;
    for (uint32_t count = 1; count < 6; count++) {
        points = sample(&mesh, count);
        gp_points_free(&points);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_far_more_even_than_noise),
        cmocka_unit_test(points_lie_on_the_surface_with_its_normals_and_colors),
        cmocka_unit_test(both_sides_of_a_sheet_have_points),
        cmocka_unit_test(degenerate_meshes_and_few_points_are_sampled),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
