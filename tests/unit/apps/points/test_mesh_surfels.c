/* Surfels of meshes: vertices that triangles use, midpoints once, and discs without holes that are
 * no larger than they must be. */
#include "apps/points/edges.h"
#include "apps/points/subdivide.h"
#include "apps/points/triangle.h"
#include "apps/points/vertices.h"
#include "tests/support/meshes/named_mesh.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

static void refine(GpMesh *mesh)
{
    GpMesh finer;
    assert_int_equal(mesh_subdivide(mesh, &finer), GP_OK);
    gp_mesh_free(mesh);
    *mesh = finer;
}

static void only_what_triangles_use_is_left(void **state)
{
    (void)state;
    float positions[18] = { 9, 9, 9, 0, 0, 0, 1, 0, 0, 8, 8, 8, 0, 1, 0, 7, 7, 7 };
    float normals[18] = { 0 }, colors[24] = { 0 };
    uint32_t indices[9] = { 2, 1, 4, 0, 0, 1, 5, 2, 5 }; /* 2 becomes 1, which is there yet */
    colors[4 * 4 + 1] = 0.5F;
    const GpMesh mesh = { .positions = positions,
                          .normals = normals,
                          .colors = colors,
                          .indices = indices,
                          .vertex_count = 6,
                          .triangle_count = 3 };
    GpMesh left;
    assert_int_equal(mesh_copy(&mesh, &left), GP_OK);
    assert_memory_equal(left.positions, positions, sizeof positions);
    assert_int_equal(mesh_keep_referenced(&left), GP_OK);
    assert_int_equal(left.vertex_count, 3);
    assert_int_equal(left.triangle_count, 1);
    static const float expected[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
    static const uint32_t corners[3] = { 1, 0, 2 };
    assert_memory_equal(left.positions, expected, sizeof expected);
    assert_memory_equal(left.indices, corners, sizeof corners);
    assert_true(left.colors[4 * 2 + 1] == 0.5F && left.normals[2] == -1);
    gp_mesh_free(&left);
}

static void edges_are_found_once(void **state)
{
    (void)state;
    GpMesh mesh = referenced_mesh("builtin:torus");
    Edges edges;
    assert_int_equal(edges_find(&mesh, &edges), GP_OK);
    unsigned char *sides = gp_alloc(edges.count, 1);
    for (size_t s = 0; s < 3 * (size_t)mesh.triangle_count; s++) {
        const uint32_t a = mesh.indices[s], b = mesh.indices[s / 3 * 3 + (s + 1) % 3];
        const uint32_t *ends = edges.ends + 2 * (size_t)edges.of_side[s];
        assert_true(ends[0] == (a < b ? a : b) && ends[1] == (a < b ? b : a));
        sides[edges.of_side[s]]++;
    }
    for (size_t e = 0; e < edges.count; e++) {
        const uint32_t *ends = edges.ends + 2 * e;
        assert_true(sides[e] == 1 || sides[e] == 2); /* 1: at a seam of texture coordinates */
        assert_true(e == 0 || ends[0] > ends[-2] || (ends[0] == ends[-2] && ends[1] > ends[-1]));
    }
    gp_free(sides);
    edges_free(&edges);
    gp_mesh_free(&mesh);
}

static void a_fan_with_a_large_hub_has_its_edges_once(void **state)
{
    (void)state;
    enum { SPOKES = 100 };
    uint32_t indices[3 * SPOKES];
    for (uint32_t i = 0; i < SPOKES; i++) {
        indices[3 * i] = 1 + (i * 37 + 37) % SPOKES; /* not in the order of the circle */
        indices[3 * i + 1] = 0;
        indices[3 * i + 2] = 1 + (i * 37) % SPOKES;
    }
    const GpMesh fan = { .indices = indices, .vertex_count = SPOKES + 1, .triangle_count = SPOKES };
    Edges edges;
    assert_int_equal(edges_find(&fan, &edges), GP_OK);
    assert_int_equal(edges.count, 2 * SPOKES);
    edges_free(&edges);
}

static double sum_of_areas(const Surfels *surfels)
{
    double sum = 0;
    for (size_t i = 0; i < surfels->count; i++)
        sum += surfel_area(&surfels->surfels[i]);
    return sum;
}

/* Points all over the triangles lie within the radius of a corner, and some nearly that far. */
static void assert_no_hole(const char *name, const GpMesh *mesh, const Surfels *surfels)
{
    enum { STEPS = 24 };
    double widest = 0;
    const uint32_t every = 1 + mesh->triangle_count / 4000;
    for (size_t t = 0; t < mesh->triangle_count; t += every) {
        const uint32_t *corner = mesh->indices + 3 * t;
        for (int i = 0; i <= STEPS; i++) {
            for (int j = 0; j <= STEPS - i; j++) {
                double nearest = HUGE_VAL;
                float place[3];
                for (size_t k = 0; k < 3; k++)
                    place[k] = (float)(((double)mesh->positions[3 * (size_t)corner[0] + k] * i +
                                        (double)mesh->positions[3 * (size_t)corner[1] + k] * j +
                                        (double)mesh->positions[3 * (size_t)corner[2] + k] *
                                            (STEPS - i - j)) /
                                       STEPS);
                for (int k = 0; k < 3; k++) {
                    const Surfel *surfel = &surfels->surfels[corner[k]];
                    const double share =
                        sqrt(triangle_side(place, surfel->position)) / (double)surfel->radius;
                    nearest = share < nearest ? share : nearest;
                }
                widest = nearest > widest ? nearest : widest;
            }
        }
    }
    if (!(widest <= 1.0001))
        fail_msg("%s: a hole, %g of the radius away", name, widest);
    if (every == 1 && !(widest > 0.9))
        fail_msg("%s: the discs are needlessly large: %g is enough", name, widest);
}

static void assert_surfels(const char *name, const GpMesh *mesh)
{
    const double area = mesh_area(mesh);
    float largest = 0, largest_each = 0;
    for (int each = 0; each < 2; each++) {
        Surfels surfels;
        assert_int_equal(surfels_of_vertices(mesh, each, &surfels), GP_OK);
        assert_int_equal(surfels.count, mesh->vertex_count);
        assert_no_hole(name, mesh, &surfels);
        const double sum = sum_of_areas(&surfels);
        if (!(fabs(sum - area) < 0.01 * area))
            fail_msg("%s: surfels stand for %g, the area is %g", name, sum, area);
        for (size_t i = 0; i < surfels.count; i++) {
            const float radius = surfels.surfels[i].radius;
            assert_true(radius > 0 && surfels.surfels[i].share > 0);
            if (each)
                largest_each = radius > largest_each ? radius : largest_each;
            else
                assert_true(i == 0 || radius == largest);
            if (!each)
                largest = radius;
        }
        surfels_free(&surfels);
    }
    assert_true(largest == largest_each);
}

static void discs_cover_the_mesh_and_are_no_larger_than_needed(void **state)
{
    (void)state;
    static const char *const names[] = { "builtin:ball", "builtin:torus", "builtin:knot",
                                         "builtin:cube", "builtin:teapot" };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        GpMesh mesh = referenced_mesh(names[i]);
        assert_surfels(names[i], &mesh);
        gp_mesh_free(&mesh);
    }
}

static void reach_is_the_farthest_point_of_a_triangle(void **state)
{
    (void)state;
    Random random = { .state = 16 };
    for (int round = 0; round < 300; round++) {
        float corners[9] = { 0 };
        for (int i = 0; i < 9; i++)
            corners[i] = random_float(&random, -1, 1) * (i % 3 == round % 3 ? 0.05F : 1);
        float normals[9] = { 0 };
        uint32_t indices[3] = { 0, 1, 2 };
        const GpMesh mesh = { .positions = corners,
                              .normals = normals,
                              .indices = indices,
                              .vertex_count = 3,
                              .triangle_count = 1 };
        Surfels surfels;
        assert_int_equal(surfels_of_vertices(&mesh, false, &surfels), GP_OK);
        assert_no_hole("a triangle", &mesh, &surfels);
        surfels_free(&surfels);
    }
    /* On a line: halfway between corners. At one place: none. */
    assert_true(fabs(triangle_reach(1, 4, 9) - 1) < 1e-12);
    assert_true(triangle_reach(0, 4, 4) == 1 && triangle_reach(0, 0, 0) == 0);
}

static void midpoints_are_shared_and_change_nothing_else(void **state)
{
    (void)state;
    GpMesh mesh = referenced_mesh("builtin:ball");
    const double area = mesh_area(&mesh);
    Surfels before, after;
    assert_int_equal(surfels_of_vertices(&mesh, false, &before), GP_OK);
    Edges edges;
    assert_int_equal(edges_find(&mesh, &edges), GP_OK);
    const uint32_t vertices = mesh.vertex_count, triangles = mesh.triangle_count;
    GpMesh finer;
    assert_int_equal(mesh_subdivide(&mesh, &finer), GP_OK);
    assert_int_equal(finer.vertex_count, vertices + edges.count);
    assert_int_equal(finer.triangle_count, 4 * triangles);
    assert_memory_equal(finer.positions, mesh.positions, 3 * vertices * sizeof(float));
    assert_true(fabs(mesh_area(&finer) - area) < 1e-5 * area);
    assert_int_equal(surfels_of_vertices(&finer, false, &after), GP_OK);
    assert_true(fabsf(after.surfels[0].radius * 2 / before.surfels[0].radius - 1) < 1e-5F);
    for (size_t v = 0; v < vertices; v++) {
        float dot = 0; /* a vertex keeps its normal: its triangles keep their planes */
        for (size_t i = 0; i < 3; i++)
            dot += finer.normals[3 * v + i] * mesh.normals[3 * v + i];
        assert_true(dot > 0.99999F);
    }
    surfels_free(&before);
    surfels_free(&after);
    edges_free(&edges);
    gp_mesh_free(&finer);
    gp_mesh_free(&mesh);
}

static void the_bunny_has_the_surfels_that_figures_are_taken_on(void **state)
{
    (void)state;
    static const char path[] = "../shared/data/meshes/bunny.ply";
    static const uint32_t counts[3] = { 34834, 139122, 556051 };
    if (access(path, R_OK) != 0) {
        print_message("skipped: %s is not there\n", path);
        return;
    }
    GpMesh mesh = referenced_mesh(path);
    for (int level = 0; level < 3; level++) {
        if (level > 0)
            refine(&mesh);
        assert_int_equal(mesh.vertex_count, counts[level]);
        assert_surfels(path, &mesh);
    }
    gp_mesh_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_what_triangles_use_is_left),
        cmocka_unit_test(edges_are_found_once),
        cmocka_unit_test(a_fan_with_a_large_hub_has_its_edges_once),
        cmocka_unit_test(reach_is_the_farthest_point_of_a_triangle),
        cmocka_unit_test(discs_cover_the_mesh_and_are_no_larger_than_needed),
        cmocka_unit_test(midpoints_are_shared_and_change_nothing_else),
        cmocka_unit_test(the_bunny_has_the_surfels_that_figures_are_taken_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
