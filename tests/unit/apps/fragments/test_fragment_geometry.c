/* Triangles as draws take them: each with its own first corner, colour and normal. */
#include "apps/fragments/drawing/geometry.h"
#include "apps/fragments/spheres.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>
#include <string.h>

enum { VERTICES = 40, TRIANGLES = 150 };

/* More triangles than vertices, some without area, some twice. */
static void every_triangle_keeps_its_corners_and_has_its_colour_and_normal(void **state)
{
    (void)state;
    Random random = { 1 };
    float positions[VERTICES][3], colors[TRIANGLES][4];
    uint32_t indices[3 * TRIANGLES];
    FragmentGeometry geometry;
    for (int i = 0; i < 3 * VERTICES; i++)
        positions[i / 3][i % 3] = random_float(&random, -1, 1);
    for (int i = 0; i < 4 * TRIANGLES; i++)
        colors[i / 4][i % 4] = random_float(&random, 0, 1);
    for (int i = 0; i < 3 * TRIANGLES; i++)
        indices[i] = (uint32_t)random_int(&random, 0, VERTICES - 1);
    const FragmentMesh mesh = { .positions = (const float(*)[3])positions,
                                .vertex_count = VERTICES,
                                .indices = indices,
                                .triangle_count = TRIANGLES,
                                .colors = (const float(*)[4])colors };
    assert_int_equal(fragment_geometry_make(&mesh, true, &geometry, NULL), GP_OK);
    bool is_first[VERTICES + TRIANGLES] = { false };
    for (uint32_t i = 0; i < TRIANGLES; i++) {
        const uint32_t *corner = indices + 3 * i, *drawn = geometry.indices + 3 * i;
        int turn = 0;
        for (int k = 0; k < 3; k++)
            assert_true(drawn[k] < geometry.drawn.vertex_count);
        while (turn < 3 &&
               (memcmp(geometry.positions[drawn[0]], positions[corner[turn]], 12) ||
                memcmp(geometry.positions[drawn[1]], positions[corner[(turn + 1) % 3]], 12) ||
                memcmp(geometry.positions[drawn[2]], positions[corner[(turn + 2) % 3]], 12)))
            turn++;
        assert_true(turn < 3);
        assert_false(is_first[drawn[0]]);
        is_first[drawn[0]] = true;
        assert_memory_equal(geometry.colors[drawn[0]], colors[i], sizeof colors[i]);
        const float *n = geometry.normals[drawn[0]];
        const double square = (double)(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        assert_true(square == 0 || fabs(square - 1) < 1e-6);
        for (int k = 0; k < 3; k++) { /* square to its edges */
            const float *a = positions[corner[k]], *b = positions[corner[(k + 1) % 3]];
            assert_true(fabsf(n[0] * (b[0] - a[0]) + n[1] * (b[1] - a[1]) + n[2] * (b[2] - a[2])) <
                        1e-5f);
        }
    }
    fragment_geometry_free(&geometry);
}

/* Closed, and every triangle turns counter-clockwise seen from outside. */
static void expect_spheres(uint32_t columns, uint32_t triangles)
{
    GpMesh mesh;
    assert_int_equal(spheres_make(4, columns, &mesh), GP_OK);
    assert_int_equal(mesh.triangle_count, 2 * 4 * triangles);
    for (uint32_t i = 0; i < mesh.triangle_count; i++) {
        const float *corner[3];
        double edge[2][3], from[3], normal[3];
        for (int k = 0; k < 3; k++)
            corner[k] = mesh.positions + 3 * (size_t)mesh.indices[3 * i + (uint32_t)k];
        const uint32_t sphere = i / triangles;
        const double centre[3] = { sphere % 2 - 0.5, sphere / 2 % 2 - 0.5, -(double)(sphere / 4) };
        for (int k = 0; k < 3; k++) {
            edge[0][k] = (double)(corner[1][k] - corner[0][k]);
            edge[1][k] = (double)(corner[2][k] - corner[0][k]);
            from[k] = (double)corner[0][k] - centre[k];
        }
        vector_cross(edge[0], edge[1], normal);
        assert_true(fabs(vector_dot(from, from) - 0.48 * 0.48) < 1e-6);
        assert_true(vector_dot(normal, from) > 0);
    }
    gp_mesh_free(&mesh);
}

static void spheres_are_as_many_as_layers_ask_for(void **state)
{
    (void)state;
    expect_spheres(SPHERE_COLUMNS, SPHERE_TRIANGLES);
    expect_spheres(4, 8);
    expect_spheres(40, 40 * 38);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_triangle_keeps_its_corners_and_has_its_colour_and_normal),
        cmocka_unit_test(spheres_are_as_many_as_layers_ask_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
