/* Whatever a user has becomes surfels with facts, or an error that says why not. */
#define POOL_THREADS 2
#include "apps/points/open.h"
#include "tests/support/folder.h"
#include "tests/support/groups/pool.h"
#include "tests/support/meshes/named_mesh.h"
#include "tests/support/random.h"

#include <math.h>

static GpError error;

static Surfels open_source(const PointsSource *source, PointsFacts *facts)
{
    Surfels surfels;
    if (points_open(source, pool, &surfels, facts, &error) != GP_OK)
        fail_msg("%s", error.text);
    for (uint32_t i = 0; i < surfels.count; i++) {
        const Surfel *surfel = &surfels.surfels[i];
        const double x = (double)surfel->normal[0], y = (double)surfel->normal[1],
                     z = (double)surfel->normal[2];
        if (!(fabs(sqrt(x * x + y * y + z * z) - 1) < 1e-6) || !(surfel->radius > 0) ||
            surfel->share == 0)
            fail_msg("surfel %u: normal %g %g %g, radius %g, share %d", i, x, y, z,
                     (double)surfel->radius, surfel->share);
    }
    return surfels;
}

static Surfels open_text(const char *name, const char *text, PointsFacts *facts)
{
    return open_source(&(PointsSource){ .path = put_text(name, text) }, facts);
}

/* --- small and odd ---------------------------------------------------------------------------- */

#define PLY(count, properties)                                                                     \
    "ply\nformat ascii 1.0\nelement vertex " count "\nproperty float x\nproperty float y\n"        \
    "property float z\n" properties "end_header\n"
#define RADIUS "property float radius\n"
#define NORMAL "property float nx\nproperty float ny\nproperty float nz\n"

static void few_points_have_stated_surfels(void **state)
{
    (void)state;
    PointsFacts facts;
    /* One point: its radius is all that it needs. Nothing says where it looks: z. */
    Surfels surfels = open_text("a.ply", PLY("1", RADIUS) "1 2 3 0.5\n", &facts);
    assert_int_equal(facts.normals_undefined, 1);
    assert_int_equal(facts.radii_made, 0);
    assert_true(surfels.surfels->normal[2] == 1 && surfels.surfels->radius == 0.5F);
    assert_true(fabs(facts.area - M_PI / 4) < 0.01);
    surfels_free(&surfels);
    /* Two: discs that meet, across the line. */
    surfels = open_text("a.xyz", "1 2 3\n1 2 5\n", &facts);
    assert_int_equal(facts.normals_undefined, 2);
    assert_true(surfels.surfels[0].normal[1] == 1 && surfels.surfels[1].normal[1] == 1);
    assert_true(surfels.surfels[0].radius == 1 && facts.spacing.mean == 2);
    surfels_free(&surfels);
    /* Three, of which one is there twice. */
    surfels = open_text("a.xyz", "0 0 0\n1 0 0\n-0 0 -0\n0 1 0\n", &facts);
    assert_int_equal(surfels.count, 3);
    assert_int_equal(facts.read, 4);
    assert_int_equal(facts.left_out, 1);
    assert_int_equal(facts.normals_undefined, 0);
    for (int i = 0; i < 3; i++)
        assert_true(surfels.surfels[i].normal[2] == 1);
    surfels_free(&surfels);
}

static void points_on_a_line_look_across_it(void **state)
{
    (void)state;
    char text[2000] = "";
    for (int i = 0; i < 50; i++)
        snprintf(text + strlen(text), 40, "%d %d 7\n", i, 2 * i);
    PointsFacts facts;
    Surfels surfels = open_text("a.xyz", text, &facts);
    assert_int_equal(facts.normals_undefined, 50);
    assert_int_equal(facts.boundary, 50);
    for (int i = 0; i < 50; i++)
        assert_true(surfels.surfels[i].normal[2] > 0.999F);
    surfels_free(&surfels);
}

static void zero_normals_and_radii_are_estimated(void **state)
{
    (void)state;
    char text[8000] = PLY("400", NORMAL RADIUS);
    for (int i = 0; i < 400; i++) { /* a square that looks down */
        const bool is_given = i % 7 != 0;
        snprintf(text + strlen(text), 40, "%d %d 0 0 0 %d %d\n", i % 20, i / 20, is_given ? -3 : 0,
                 i % 5 ? 2 : 0);
    }
    PointsFacts facts;
    Surfels surfels = open_text("a.ply", text, &facts);
    assert_int_equal(facts.zero_normals, 58);
    assert_int_equal(facts.normals_made, 58);
    assert_int_equal(facts.radii_made, 80);
    assert_int_equal(facts.components, 1);
    assert_int_equal(facts.boundary, 76);
    for (int i = 0; i < 400; i++) {
        assert_true(surfels.surfels[i].normal[2] == -1);
        const bool is_inside = i % 20 > 0 && i % 20 < 19 && i / 20 > 0 && i / 20 < 19;
        if (i % 5)
            assert_true(surfels.surfels[i].radius == 2);
        else if (is_inside)
            assert_true(fabsf(surfels.surfels[i].radius - sqrtf(0.5F)) < 1e-6F);
    }
    surfels_free(&surfels);
}

static void what_cannot_be_opened_says_why(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text, *part;
        PointsSource source;
        GpResult result;
    } cases[] = {
        { "a.las",
          "x",
          "expected a name that ends with .ply, .xyz",
          { NULL },
          GP_ERROR_UNSUPPORTED },
        { "a.xyz", "1 2 3\n", "1 point at one place, without a radius", { NULL }, GP_ERROR_FORMAT },
        { "a.xyz", "1 2 3\n1 2 3\n1 2 3\n", "3 points at one place", { NULL }, GP_ERROR_FORMAT },
        { "a.xyz",
          "1 2 3\n1 nan 3\n",
          "line 2: expected a finite number",
          { NULL },
          GP_ERROR_FORMAT },
        { "a.ply",
          PLY("2147483648", "") "1 2 3\n",
          "2147483648 elements are promised",
          { NULL },
          GP_ERROR_FORMAT },
        { "a.ply", PLY("2", "") "1 2 3\n4 5    \n", "the file ends", { NULL }, GP_ERROR_FORMAT },
        { "a.ply", PLY("0", ""), "no points", { NULL }, GP_ERROR_FORMAT },
        { "a.xyz", "1 2 3\n4 5 6\n", "only a mesh can be", { .sample = 9 }, GP_ERROR_INVALID },
        { "a.off",
          "OFF\n2 0 0\n0 0 0\n1 1 1\n",
          "only a mesh can be",
          { .subdivide = 1 },
          GP_ERROR_INVALID },
        { "a.off",
          "OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n",
          "no triangle with an area",
          { NULL },
          GP_ERROR_FORMAT },
        { "a.off",
          "OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 7\n",
          "refers to vertex 7",
          { NULL },
          GP_ERROR_FORMAT },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        PointsSource source = cases[i].source;
        Surfels surfels = { .count = 77 };
        source.path = put_text(cases[i].name, cases[i].text);
        error.text[0] = '\0';
        PointsFacts facts;
        const GpResult result = points_open(&source, pool, &surfels, &facts, &error);
        if (result != cases[i].result || !strstr(error.text, cases[i].part) ||
            !strstr(error.text, cases[i].name))
            fail_msg("expected '%s': got %s, '%s'", cases[i].part, gp_result_name(result),
                     error.text);
        assert_int_equal(surfels.count, 77);
    }
}

/* --- meshes ----------------------------------------------------------------------------------- */

static const char square_off[] = "OFF\n6 2 0\n9 9 9\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n8 8 8\n"
                                 "3 1 2 3\n3 1 3 4\n";

static void meshes_give_vertices_midpoints_or_samples(void **state)
{
    (void)state;
    PointsFacts facts;
    PointsSource source = { .path = put_text("a.off", square_off) };
    static const uint32_t counts[] = { 4, 9, 25 };
    for (source.subdivide = 0; source.subdivide < 3; source.subdivide++) {
        Surfels surfels = open_source(&source, &facts);
        assert_int_equal(surfels.count, counts[source.subdivide]);
        assert_int_equal(facts.left_out, 2);
        assert_int_equal(facts.triangles, 2);
        assert_int_equal(facts.components, 1);
        assert_int_equal(facts.boundary, 4 << source.subdivide);
        assert_true(fabs(facts.area - 4) < 0.1);
        assert_true(facts.spacing.least == 2.0 / (1 << source.subdivide));
        surfels_free(&surfels);
    }
    source.subdivide = 0;
    source.sample = 4000;
    Surfels surfels = open_source(&source, &facts);
    assert_int_equal(surfels.count, 4000);
    assert_int_equal(facts.sampled, 4000);
    if (!(fabs(facts.area - 4) < 0.12))
        fail_msg("samples stand for %g, the area is 4", facts.area);
    assert_true(facts.low[0] < 0.1F && facts.high[1] > 1.9F);
    assert_true(facts.boundary > 120 && facts.boundary < 500);
    surfels_free(&surfels);
}

static void a_mesh_in_memory_is_as_good(void **state)
{
    (void)state;
    GpMesh mesh = named_mesh("builtin:torus");
    PointsFacts facts;
    Surfels surfels = open_source(&(PointsSource){ .mesh = &mesh, .subdivide = 1 }, &facts);
    assert_true(facts.had_normals && facts.normals_made == 0);
    surfels_free(&surfels);
    GpPoints points = { .positions = mesh.positions, .count = mesh.vertex_count };
    surfels = open_source(&(PointsSource){ .points = &points }, &facts);
    assert_true(facts.left_out > 0 && facts.normals_made == surfels.count);
    assert_int_equal(facts.boundary, 0);
    assert_int_equal(facts.components, 1);
    surfels_free(&surfels);
    gp_mesh_free(&mesh);
}

/* --- the report ------------------------------------------------------------------------------- */

static void the_report_tells_what_was_read_and_made(void **state)
{
    (void)state;
    PointsFacts facts;
    Surfels surfels = open_text("a.xyz", "0 0 0\n1 0 0\n0 0 0\n0 1 0\n1 1 0\n", &facts);
    Text lines = { .data = NULL };
    json_t *members = json_object();
    facts_report(&facts, &lines, members);
    static const char *const parts[] = {
        "points 4; the file has 5 points, 1 at the place of another left out\n",
        "normals 4 estimated; radii 4 estimated; colours white\n",
        "box (0, 0, 0) to (1, 1, 0)\n",
        "spacing 1, from 1 to 1\n",
        "boundary 4 points at an edge or a hole; 1 component\n",
    };
    for (size_t i = 0; i < GP_COUNT(parts); i++) {
        if (!strstr(lines.data, parts[i]))
            fail_msg("'%s' is not in\n%s", parts[i], lines.data);
    }
    assert_int_equal(json_integer_value(json_object_get(members, "left_out")), 1);
    assert_true(json_number_value(json_object_get(json_object_get(members, "spacing"), "mean")) ==
                1);
    assert_int_equal(json_array_size(json_object_get(members, "box")), 2);
    json_decref(members);
    text_free(&lines);
    surfels_free(&surfels);

    surfels = open_text("a.off", square_off, &facts);
    facts_report(&facts, &lines, NULL);
    assert_non_null(strstr(lines.data,
                           "points 4, vertices of 2 triangles; the file has 6 vertices, "
                           "2 of no triangle left out\n"
                           "normals of the triangles; radii 4 estimated"));
    text_free(&lines);
    surfels_free(&surfels);
}

static void a_mesh_turned_inside_out_has_surfels_that_look_outwards(void **state)
{
    (void)state;
    GpMesh mesh = named_mesh("builtin:ball");
    PointsFacts facts;
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        const uint32_t second = mesh.indices[3 * t + 1];
        mesh.indices[3 * t + 1] = mesh.indices[3 * t + 2];
        mesh.indices[3 * t + 2] = second;
    }
    mesh.had_normals = false;
    Surfels surfels = open_source(&(PointsSource){ .mesh = &mesh, .subdivide = 1 }, &facts);
    for (uint32_t i = 0; i < surfels.count; i++) {
        float outwards = 0;
        for (int k = 0; k < 3; k++)
            outwards += surfels.surfels[i].normal[k] * surfels.surfels[i].position[k];
        assert_true(outwards > 0.8F);
    }
    Text lines = { .data = NULL };
    facts_report(&facts, &lines, NULL);
    assert_non_null(strstr(lines.data, "; 1 part turned inside out\n"));
    text_free(&lines);
    surfels_free(&surfels);
    gp_mesh_free(&mesh);
}

static void scans_are_opened(void **state)
{
    (void)state;
    static const char *const paths[] = { "../shared/data/points/rangemap_lato315.ply" };
    for (size_t i = 0; i < GP_COUNT(paths); i++) {
        if (access(paths[i], R_OK) != 0) {
            print_message("skipped: %s is not there\n", paths[i]);
            continue;
        }
        PointsFacts facts;
        Surfels surfels = open_source(&(PointsSource){ .path = paths[i] }, &facts);
        assert_int_equal(facts.normals_made, 0);
        assert_true(facts.boundary > 500 && facts.boundary < facts.count / 4);
        surfels_free(&surfels);
    }
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(few_points_have_stated_surfels),
        TEST(points_on_a_line_look_across_it),
        TEST(zero_normals_and_radii_are_estimated),
        TEST(what_cannot_be_opened_says_why),
        TEST(meshes_give_vertices_midpoints_or_samples),
        TEST(a_mesh_in_memory_is_as_good),
        TEST(the_report_tells_what_was_read_and_made),
        TEST(a_mesh_turned_inside_out_has_surfels_that_look_outwards),
        cmocka_unit_test(scans_are_opened),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
