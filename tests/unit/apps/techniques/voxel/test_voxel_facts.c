/* What is told of meshes and solids: shapes whose faults are known, made and found, and files whose
 * faults were counted by another program in exact arithmetic. */
#include "apps/scene/shapes.h"
#include "apps/techniques/voxel/facts.h"
#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh_file.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

#include <stdio.h>

/* --- shapes ----------------------------------------------------------------------------------- */

/* Positions alone, with room for more triangles. */
typedef struct Mesh {
    float *positions;
    uint32_t *indices;
    uint32_t vertex_count, triangle_count;
} Mesh;

enum { MORE = 8 };

static Mesh make(const char *name)
{
    Shape shape;
    assert_int_equal(shape_create(name, &shape), GP_OK);
    Mesh mesh = { gp_alloc(shape.vertex_count, 12), gp_alloc(shape.index_count + 3 * MORE, 4),
                  shape.vertex_count, shape.index_count / 3 };
    for (uint32_t i = 0; i < shape.vertex_count; i++)
        memcpy(mesh.positions + 3 * (size_t)i, shape.positions + 3 * i, 12);
    memcpy(mesh.indices, shape.indices, shape.index_count * sizeof *mesh.indices);
    shape_free(&shape);
    return mesh;
}

static void release(Mesh *mesh)
{
    gp_free(mesh->positions);
    gp_free(mesh->indices);
}

static MeshReport report_of(const Mesh *mesh)
{
    MeshReport report;
    assert_int_equal(mesh_report(mesh->positions, mesh->vertex_count, mesh->indices,
                                 mesh->triangle_count, &report),
                     GP_OK);
    return report;
}

static void add_triangle(Mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t *corner = mesh->indices + 3 * mesh->triangle_count++;
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
}

static void turn_over(Mesh *mesh, uint32_t triangle)
{
    uint32_t *corner = mesh->indices + 3 * (size_t)triangle, swap = corner[0];
    corner[0] = corner[1];
    corner[1] = swap;
}

static void closed_shapes_are_closed_and_hold_their_volume(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double low, high;
    } closed[] = {
        { "cube", 8, 8 },   { "sphere", 4.10, 4.19 },  { "ball", 3.5, 4.19 },   { "torus", 0.5, 3 },
        { "knot", 0.1, 3 }, { "cylinder", 6.1, 6.29 }, { "cone", 2.0, 2.0944 },
    };
    for (size_t i = 0; i < GP_COUNT(closed); i++) {
        Mesh mesh = make(closed[i].name);
        MeshReport report = report_of(&mesh);
        if (!report.is_closed || report.is_inside_out || report.volume < closed[i].low ||
            report.volume > closed[i].high)
            fail_msg("%s: closed %d, volume %g", closed[i].name, report.is_closed, report.volume);
        assert_int_equal(report.edges, mesh.triangle_count / 2 * 3); /* Euler: 2 edges = 3 faces */
        assert_int_equal(report.boundary_edges + report.odd_edges + report.duplicates, 0);
        for (uint32_t t = 0; t < mesh.triangle_count; t++)
            turn_over(&mesh, t);
        MeshReport turned = report_of(&mesh);
        assert_true(turned.is_closed && turned.is_inside_out);
        assert_true(fabs(turned.volume + report.volume) < 1e-12);
        release(&mesh);
    }
}

static void open_shapes_have_their_rim_as_boundary_edges(void **state)
{
    (void)state;
    Mesh quad = make("quad");
    MeshReport report = report_of(&quad);
    assert_int_equal(quad.triangle_count, 2);
    assert_false(report.is_closed);
    assert_int_equal(report.edges, 5);
    assert_int_equal(report.boundary_edges, 4);
    assert_int_equal(report.odd_edges, 4);
    release(&quad);

    Mesh cube = make("cube");
    cube.triangle_count -= 2;
    report = report_of(&cube);
    assert_false(report.is_closed);
    assert_int_equal(report.boundary_edges, 4);
    assert_int_equal(report.non_manifold_edges + report.inconsistent_edges, 0);
    char faults[100];
    mesh_report_faults(&report, faults, sizeof faults);
    assert_string_equal(faults, "4 boundary edges");
    release(&cube);

    Mesh teapot = make("teapot");
    assert_false(report_of(&teapot).is_closed);
    release(&teapot);
}

static void a_triangle_turned_over_has_three_inconsistent_edges(void **state)
{
    (void)state;
    Mesh mesh = make("sphere");
    turn_over(&mesh, mesh.triangle_count / 2);
    MeshReport report = report_of(&mesh);
    assert_false(report.is_closed);
    assert_false(report.is_inside_out);
    assert_int_equal(report.inconsistent_edges, 3);
    assert_int_equal(report.unbalanced_edges, 3);
    assert_int_equal(report.boundary_edges + report.non_manifold_edges + report.odd_edges, 0);
    release(&mesh);
}

static void duplicates_crowd_their_edges(void **state)
{
    (void)state;
    Mesh mesh = make("cube");
    const uint32_t *first = mesh.indices;
    add_triangle(&mesh, first[1], first[2], first[0]); /* again */
    MeshReport report = report_of(&mesh);
    assert_false(report.is_closed);
    assert_int_equal(report.duplicates, 1);
    assert_int_equal(report.non_manifold_edges, 3);
    assert_int_equal(report.odd_edges, 3);
    assert_int_equal(report.unbalanced_edges, 3);
    add_triangle(&mesh, first[2], first[1], first[0]); /* and turned over */
    report = report_of(&mesh);
    assert_int_equal(report.unbalanced_edges, 0);
    assert_int_equal(report.duplicates, 2);
    assert_int_equal(report.non_manifold_edges, 3);
    assert_int_equal(report.odd_edges, 0);
    assert_false(report.is_closed);
    release(&mesh);
}

static void triangles_without_area_are_counted_and_have_edges_where_they_have_corners(void **state)
{
    (void)state;
    static const float positions[] = { 0, 0, 0, 1, 0, 0, 3, 0, 0, 1, -0.0f, 0 };
    static const uint32_t indices[] = { 0, 1, 2, 0, 1, 3, 2, 2, 2 };
    MeshReport report;
    assert_int_equal(mesh_report(positions, 4, indices, 3, &report), GP_OK);
    assert_int_equal(report.degenerate, 3);
    assert_int_equal(report.edges, 3); /* the second has one corner twice: 0 and -0 are one place */
    assert_int_equal(report.boundary_edges, 3);
    assert_int_equal(mesh_report(positions, 4, indices + 3, 2, &report), GP_OK);
    assert_int_equal(report.edges, 0);
    assert_false(report.is_closed);
    char faults[100];
    mesh_report_faults(&report, faults, sizeof faults);
    assert_string_equal(faults, "no triangle with three corners");
}

/* The same shape from vertices of its own for each corner. */
static void vertices_at_one_place_are_one(void **state)
{
    (void)state;
    Mesh mesh = make("knot");
    const uint32_t corners = 3 * mesh.triangle_count;
    float *positions = gp_alloc(corners, 12);
    uint32_t *indices = gp_alloc(corners, sizeof *indices);
    for (uint32_t i = 0; i < corners; i++) {
        memcpy(positions + 3 * (size_t)i, mesh.positions + 3 * (size_t)mesh.indices[i], 12);
        indices[i] = i;
    }
    MeshReport welded = report_of(&mesh), loose;
    assert_int_equal(mesh_report(positions, corners, indices, mesh.triangle_count, &loose), GP_OK);
    assert_memory_equal(&loose, &welded, offsetof(MeshReport, is_closed)); /* all counts */
    assert_true(loose.is_closed);
    gp_free(positions);
    gp_free(indices);
    release(&mesh);
}

/* --- files ------------------------------------------------------------------------------------ */

static void files_have_the_faults_that_are_known(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint32_t triangles;
        uint64_t edges, open, crowded, odd, turned, duplicates, degenerate;
    } known[] = {
        { "dirty/beast.ply", 64618, 96925, 0, 2, 0, 0, 2, 0 },
        { "dirty/beetle.ply", 38656, 58552, 1136, 0, 1136, 0, 0, 0 },
        { "dirty/boeing.ply", 2564, 3846, 0, 0, 0, 978, 0, 0 },
        { "dirty/chair_dup_faces.ply", 12756, 9527, 0, 9518, 0, 0, 6382, 0 },
        { "dirty/conrod.ply", 6442, 9660, 0, 3, 0, 5149, 3, 0 },
        { "dirty/elephant_with_holes.ply", 4463, 7371, 1353, 0, 1353, 0, 0, 0 },
        { "dirty/hourglass_one_hole.ply", 2145, 3219, 3, 0, 3, 0, 0, 0 },
        { "dirty/many_small_holes.ply", 3524, 5564, 556, 0, 556, 0, 0, 0 },
        { "dirty/mech_holes_shark.ply", 10192, 15440, 304, 0, 304, 0, 0, 0 },
        { "dirty/non_manifold_hole.ply", 755, 1192, 119, 0, 119, 0, 0, 0 },
        { "dirty/office_chair.ply", 6893, 10250, 157, 132, 157, 0, 12, 40 },
        { "dirty/triangle_soup.ply", 100, 300, 300, 0, 300, 0, 0, 0 },
        { "dirty/wallhole.ply", 66, 98, 0, 1, 0, 0, 1, 11 },
        { "bunny.ply", 69451, 104288, 223, 0, 223, 0, 0, 0 },
        { "cycloidal.ply", 43368, 64810, 0, 242, 0, 0, 0, 0 },
        { "hourglass.ply", 2146, 3219, 0, 0, 0, 72, 0, 0 },
        { "teapot.ply", 6320, 9560, 160, 0, 160, 0, 0, 0 },
    };
    for (size_t i = 0; i < GP_COUNT(known); i++) {
        char name[100], path[400];
        GpMesh mesh;
        GpError error = { "" };
        snprintf(name, sizeof name, "meshes/%s", known[i].name);
        if (gp_data_find(name, path, sizeof path, &error))
            skip();
        if (gp_mesh_read(path, GP_MESH_TRIANGLES, &mesh, &error))
            fail_msg("%s", error.text);
        MeshReport report;
        assert_int_equal(mesh_report(mesh.positions, mesh.vertex_count, mesh.indices,
                                     mesh.triangle_count, &report),
                         GP_OK);
        assert_int_equal(mesh.triangle_count, known[i].triangles);
        const uint64_t found[] = {
            report.edges,     report.boundary_edges,     report.non_manifold_edges,
            report.odd_edges, report.inconsistent_edges, report.duplicates,
            report.degenerate
        };
        assert_memory_equal(found, &known[i].edges, sizeof found);
        assert_false(report.is_closed);
        gp_mesh_free(&mesh);
    }
}

/* Two closed ones, of which the horse is inside out. */
static void closed_files_are_closed(void **state)
{
    (void)state;
    static const char *const names[] = { "meshes/knot2.ply", "meshes/horse.ply" };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        char path[400];
        GpMesh mesh;
        GpError error = { "" };
        MeshReport report;
        if (gp_data_find(names[i], path, sizeof path, &error))
            skip();
        assert_int_equal(gp_mesh_read(path, GP_MESH_TRIANGLES, &mesh, &error), GP_OK);
        assert_int_equal(mesh_report(mesh.positions, mesh.vertex_count, mesh.indices,
                                     mesh.triangle_count, &report),
                         GP_OK);
        assert_true(report.is_closed);
        assert_int_equal(report.is_inside_out, i == 1);
        gp_mesh_free(&mesh);
    }
}

/* --- solids ----------------------------------------------------------------------------------- */

enum { SIZE = 24 };

static void solids_of(const Mesh *mesh, uint64_t odd_columns[3], uint64_t *disagreements)
{
    const VoxelScene scene = { .mesh = { .positions = mesh->positions,
                                         .indices = mesh->indices,
                                         .vertex_count = mesh->vertex_count,
                                         .triangle_count = mesh->triangle_count } };
    VoxelFacts facts = { .has_solids = false };
    assert_int_equal(voxel_facts_find_solids(&scene, SIZE, &facts, NULL), GP_OK);
    assert_true(facts.has_solids);
    memcpy(odd_columns, facts.odd_columns, sizeof facts.odd_columns);
    *disagreements = facts.disagreements;
}

static void closed_solids_agree_and_open_ones_tell_where_they_do_not(void **state)
{
    (void)state;
    uint64_t odd[3], disagreements;
    Mesh sphere = make("sphere");
    solids_of(&sphere, odd, &disagreements);
    assert_int_equal(odd[0] + odd[1] + odd[2] + disagreements, 0);
    turn_over(&sphere, 5); /* parity does not care */
    solids_of(&sphere, odd, &disagreements);
    assert_int_equal(odd[0] + odd[1] + odd[2] + disagreements, 0);
    release(&sphere);

    /* Without one side, the columns through it cross the other alone; along the other two axes
     * nothing is missing. The cube is 21.5 voxels long: 21 or 22 centres a side. */
    Mesh cube = make("cube");
    cube.triangle_count -= 2;
    solids_of(&cube, odd, &disagreements);
    int hurt = 0;
    for (int axis = 0; axis < 3; axis++) {
        hurt += odd[axis] > 0;
        assert_true(odd[axis] == 0 || (odd[axis] >= 21 * 21 && odd[axis] <= 22 * 22));
    }
    assert_int_equal(hurt, 1);
    assert_true(disagreements > 0);
    release(&cube);

    /* Every triangle twice: all is outside along every axis, and only the mesh's report tells. */
    Mesh quad = make("quad");
    add_triangle(&quad, quad.indices[0], quad.indices[1], quad.indices[2]);
    add_triangle(&quad, quad.indices[3], quad.indices[4], quad.indices[5]);
    solids_of(&quad, odd, &disagreements);
    assert_int_equal(odd[0] + odd[1] + odd[2] + disagreements, 0);
    MeshReport report = report_of(&quad);
    assert_false(report.is_closed);
    assert_int_equal(report.odd_edges, 0);
    release(&quad);
}

/* Made at many sizes, of shapes whose sides and seams lie on centres of voxels, and turned: the
 * pipeline's own solids along three axes disagree in up to 150 voxels here. */
static void closed_meshes_have_no_disagreement_at_all(void **state)
{
    (void)state;
    static const char *const names[] = { "cube",
                                         "sphere",
                                         "ball",
                                         "torus",
                                         "knot",
                                         "cone",
                                         "cylinder",
                                         "meshes/knot2.ply",
                                         "meshes/horse.ply",
                                         "meshes/gears.ply" };
    static const uint32_t sizes[] = { 8, 31, 64, 129 };
    for (size_t i = 0; i < GP_COUNT(names); i++)
        for (size_t j = 0; j < GP_COUNT(sizes); j++) {
            VoxelCase subject = voxel_case_open(names[i], 0, sizes[j]);
            VoxelFacts facts;
            assert_int_equal(voxel_facts_find(&subject.scene, &facts, NULL), GP_OK);
            assert_true(facts.mesh.is_closed);
            assert_int_equal(facts.mesh.unbalanced_edges, 0);
            assert_int_equal(voxel_facts_find_solids(&subject.scene, sizes[j], &facts, NULL),
                             GP_OK);
            assert_int_equal(facts.odd_columns[0] + facts.odd_columns[1] + facts.odd_columns[2], 0);
            if (facts.disagreements || facts.doubled)
                fail_msg("%s, %u: %lu disagree, %lu doubled", names[i], sizes[j],
                         (unsigned long)facts.disagreements, (unsigned long)facts.doubled);
            voxel_case_free(&subject);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_shapes_are_closed_and_hold_their_volume),
        cmocka_unit_test(open_shapes_have_their_rim_as_boundary_edges),
        cmocka_unit_test(a_triangle_turned_over_has_three_inconsistent_edges),
        cmocka_unit_test(duplicates_crowd_their_edges),
        cmocka_unit_test(triangles_without_area_are_counted_and_have_edges_where_they_have_corners),
        cmocka_unit_test(vertices_at_one_place_are_one),
        cmocka_unit_test(files_have_the_faults_that_are_known),
        cmocka_unit_test(closed_files_are_closed),
        cmocka_unit_test(closed_solids_agree_and_open_ones_tell_where_they_do_not),
        cmocka_unit_test(closed_meshes_have_no_disagreement_at_all),
    };
    return cmocka_run_group_tests_name("voxel facts", tests, NULL, NULL);
}
