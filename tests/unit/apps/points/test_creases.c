/* Where faces meet at an angle each has its own normals: of vertices, midpoints and samples. */
#include "apps/points/cloud/distinct.h"
#include "apps/points/creases.h"
#include "apps/points/open.h"
#include "apps/points/sample.h"
#include "apps/points/subdivide.h"
#include "tests/support/groups/pool.h"
#include "tests/support/meshes/named_mesh.h"
#include "tests/support/unit.h"

#include <math.h>
#include <string.h>

/* A builtin mesh with one vertex at a place, whose normal is the mean of what is there. */
static GpMesh welded(const char *name)
{
    GpMesh mesh = named_mesh(name);
    uint32_t *first = gp_alloc(mesh.vertex_count, sizeof *first);
    assert_int_equal(places_find(mesh.positions, mesh.vertex_count, first), GP_OK);
    for (size_t i = 0; i < 3 * (size_t)mesh.triangle_count; i++)
        mesh.indices[i] = first[mesh.indices[i]];
    gp_free(first);
    mesh.had_normals = false;
    assert_int_equal(mesh_keep_referenced(&mesh), GP_OK);
    return mesh;
}

static GpMesh copy_of(const GpMesh *mesh)
{
    GpMesh copy;
    assert_int_equal(mesh_copy(mesh, &copy), GP_OK);
    return copy;
}

/* 1 where a normal is square to a side of a cube, and that side is at the place. */
static bool is_of_face(const float place[3], const float normal[3])
{
    for (int k = 0; k < 3; k++)
        if (normal[k] == place[k] && fabsf(normal[k]) == 1)
            return true;
    return false;
}

static void a_cube_of_eight_vertices_has_three_sides_at_each(void **state)
{
    (void)state;
    for (int had_normals = 0; had_normals < 2; had_normals++) {
        GpMesh mesh = welded("builtin:cube");
        assert_int_equal(mesh.vertex_count, 8);
        mesh.had_normals = had_normals;
        const GpMesh before = copy_of(&mesh);
        assert_int_equal(mesh_split_creases(&mesh, 40), GP_OK);
        assert_int_equal(mesh.vertex_count, 24);
        assert_memory_equal(mesh.positions, before.positions, 24 * sizeof(float));
        for (size_t i = 0; i < 36; i++) {
            const float *place = mesh.positions + 3 * (size_t)mesh.indices[i];
            assert_memory_equal(place, before.positions + 3 * (size_t)before.indices[i], 12);
            assert_true(is_of_face(place, mesh.normals + 3 * (size_t)mesh.indices[i]));
        }
        gp_mesh_free(&mesh);
        gp_mesh_free((GpMesh *)&before);
    }
}

static void what_has_no_crease_or_is_cut_already_stays(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        bool is_welded;
        double degrees;
    } cases[] = {
        { "builtin:ball", true, 40 }, /* 22.5 degrees from face to face */
        { "builtin:torus", true, 40 },     { "builtin:cube", false, 40 },
        { "builtin:cylinder", false, 40 }, { "builtin:cube", true, 91 },
        { "builtin:ball", false, 20 }, /* flat by its triangles, but round by its normals */
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        GpMesh read = { .positions = NULL }, mesh;
        if (cases[i].is_welded) {
            mesh = welded(cases[i].name);
        } else {
            read = named_mesh(cases[i].name);
            mesh = copy_of(&read);
        }
        GpMesh before = copy_of(&mesh);
        assert_int_equal(mesh_split_creases(&mesh, cases[i].degrees), GP_OK);
        if (mesh.vertex_count != before.vertex_count)
            fail_msg("case %zu, %s: %u vertices of %u", i, cases[i].name, mesh.vertex_count,
                     before.vertex_count);
        assert_memory_equal(mesh.normals, before.normals, 12 * (size_t)mesh.vertex_count);
        assert_memory_equal(mesh.indices, before.indices, 12 * (size_t)mesh.triangle_count);
        gp_mesh_free(&read);
        gp_mesh_free(&mesh);
        gp_mesh_free(&before);
    }
}

static void a_smooth_side_has_one_normal_around_a_vertex(void **state)
{
    (void)state;
    GpMesh mesh = welded("builtin:cylinder");
    const uint32_t before = mesh.vertex_count;
    assert_int_equal(mesh_split_creases(&mesh, 40), GP_OK);
    assert_int_equal(mesh.vertex_count, before + 2 * 64); /* both rims */
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        const float *at = mesh.positions + 3 * v, *normal = mesh.normals + 3 * v;
        const float outwards = at[0] * normal[0] + at[2] * normal[2];
        if (!(fabsf(normal[1]) == 1 || (outwards > 0.999F && fabsf(normal[1]) < 1e-6F)))
            fail_msg("vertex %zu: normal %g %g %g", v, (double)normal[0], (double)normal[1],
                     (double)normal[2]);
    }
    gp_mesh_free(&mesh);
}

/* With normals in the file that lean at the corners: what lies inside of a face does not. */
static void midpoints_inside_of_a_face_look_as_it_does(void **state)
{
    (void)state;
    GpMesh mesh = welded("builtin:cube");
    mesh.had_normals = true;
    for (size_t i = 0; i < 24; i++)
        mesh.normals[i] = mesh.positions[i] * 0.57735F;
    for (int round = 0; round < 3; round++) {
        GpMesh finer;
        assert_int_equal(mesh_subdivide(&mesh, &finer), GP_OK);
        gp_mesh_free(&mesh);
        mesh = finer;
    }
    uint32_t inside = 0;
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        const float *at = mesh.positions + 3 * v;
        int faces = 0;
        for (int k = 0; k < 3; k++)
            faces += fabsf(at[k]) == 1;
        if (faces == 1) {
            assert_true(is_of_face(at, mesh.normals + 3 * v));
            inside++;
        }
    }
    assert_int_equal(inside, 6 * 49);
    gp_mesh_free(&mesh);
}

static void samples_look_as_their_faces_do(void **state)
{
    (void)state;
    for (int had_normals = 0; had_normals < 2; had_normals++) {
        GpMesh mesh = welded("builtin:cube");
        mesh.had_normals = had_normals;
        const PointsSource source = { .mesh = &mesh, .sample = 3000 };
        Surfels surfels;
        GpError error;
        if (points_open(&source, pool, &surfels, NULL, &error) != GP_OK)
            fail_msg("%s", error.text);
        for (uint32_t i = 0; i < surfels.count; i++)
            assert_true(is_of_face(surfels.surfels[i].position, surfels.surfels[i].normal));
        surfels_free(&surfels);
        gp_mesh_free(&mesh);
    }
}

static void sharp_vertices_are_told_of(void **state)
{
    (void)state;
    GpMesh mesh = welded("builtin:cube");
    PointsSource source = { .mesh = &mesh, .sharp = 40, .subdivide = 1 };
    for (int round = 0; round < 2; round++) {
        Surfels surfels;
        PointsFacts facts;
        GpError error;
        if (points_open(&source, pool, &surfels, &facts, &error) != GP_OK)
            fail_msg("%s", error.text);
        assert_int_equal(surfels.count, round == 0 ? 6 * 9 : 8 + 12 + 6);
        assert_int_equal(facts.split, round == 0 ? 16 : 0);
        Text lines = { .data = NULL };
        facts_report(&facts, &lines, NULL);
        assert_int_equal(strstr(lines.data, "; 16 more for the sides of creases\n") != NULL,
                         round == 0);
        text_free(&lines);
        surfels_free(&surfels);
        source.sharp = 0;
    }
    gp_mesh_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cube_of_eight_vertices_has_three_sides_at_each),
        cmocka_unit_test(what_has_no_crease_or_is_cut_already_stays),
        cmocka_unit_test(a_smooth_side_has_one_normal_around_a_vertex),
        cmocka_unit_test(midpoints_inside_of_a_face_look_as_it_does),
        cmocka_unit_test(samples_look_as_their_faces_do),
        cmocka_unit_test(sharp_vertices_are_told_of),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
