/* How sorting fragments fails, each failure beside its remedy. */
#include "apps/techniques/fragments/model.h"
#include "apps/techniques/fragments/report.h"
#include "apps/techniques/fragments/technique.h"
#include "tests/support/random.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"

#include <string.h>

static void check(const TechniqueCase *rows, size_t count)
{
    GpError error;
    if (technique_cases_check(&fragment_technique, rows, count, &error))
        fail_msg("%s", error.text);
}

#define KNOT "builtin:knot" /* up to 14 layers */
#define NONE "beyond edges", 0, 0

static void methods_that_keep_all_fragments_are_exact(void **state)
{
    (void)state;
    static const TechniqueCase rows[] = {
        { "the machine sorts", KNOT, "--method sorted", NONE },
        { "convex pieces", KNOT, "--method convex", NONE },
        { "as printed, but exact", KNOT, "--method convex --pieces outward", NONE },
        { "peeling", KNOT, "--method dp", NONE },
        { "dual peeling", KNOT, "--method ddp", NONE },
        { "lists", KNOT, "--method abuffer", NONE },
        { "lists on the processor", KNOT, "--method cpu", NONE },
        { "as many kept as there are", KNOT, "--method kbuffer --kept 14", NONE },
        { "the same as they come", KNOT, "--method stencil --kept 14", NONE },
    };
    check(rows, GP_COUNT(rows));
}

static void what_is_lost_is_seen_and_found_again(void **state)
{
    (void)state;
    static const TechniqueCase rows[] = {
        { "k smaller than the depth", KNOT, "--method kbuffer --kept 4", "beyond edges", 2000,
          9000 },
        { "twice that", KNOT, "--method kbuffer --kept 8", "beyond edges", 1, 100 },
        { "the first that come", KNOT, "--method stencil --kept 4", "beyond edges", 2000, 9000 },
        { "16 in flight", KNOT, "--method kbuffer --kept 14 --hazard 16", "beyond edges", 100,
          600 },
        { "256 in flight", KNOT, "--method kbuffer --kept 14 --hazard 256", "beyond edges", 600,
          2000 },
        { "one in flight, which is none", KNOT, "--method kbuffer --kept 14 --hazard 1", NONE },
        { "collisions in 16 buckets", KNOT, "--method bucket1", "beyond edges", 800, 2500 },
        { "of pairs fewer", KNOT, "--method bucket2", "beyond edges", 50, 500 },
        { "where fragments are", KNOT, "--method adaptive", "beyond edges", 50, 600 },
        { "depth in 16 bits, colour in 16", KNOT, "--method mdt", "beyond edges", 15000, 40000 },
        { "convex pieces that may be concave", KNOT, "--method convex --tolerance 0.05",
          "beyond edges", 10, 1000 },
        { "convex pieces by a grid", KNOT, "--method convex --order grid", "beyond edges", 3000,
          20000 },
        { "no order at all", KNOT, "--method weighted", "beyond edges", 30000, 60000 },
    };
    check(rows, GP_COUNT(rows));
}

/* --- meshes that are hard --------------------------------------------------------------------- */

/* Wrong pixels of a mesh of triangles in front of the eye. */
static FragmentError error_of(const float (*corners)[3], uint32_t triangles, const char *options)
{
    GpError error;
    FragmentOptions *setting = NULL;
    Frame frame = { .color = NULL };
    FragmentModel model = { .file = { .vertex_count = 3 * triangles,
                                      .triangle_count = triangles,
                                      .positions = gp_alloc(3 * triangles, 3 * sizeof(float)),
                                      .indices = gp_alloc(3 * triangles, sizeof(uint32_t)) },
                            .colors = gp_alloc(triangles, sizeof *model.colors),
                            .view = { .width = 64,
                                      .height = 64,
                                      .camera = { .eye = { 0, 0, 3 },
                                                  .up = { 0, 1, 0 },
                                                  .fovy = 40,
                                                  .near = 0.5,
                                                  .far = 9 } } };
    GpDevice *device;
    memcpy(model.file.positions, corners, 9 * triangles * sizeof(float));
    for (uint32_t i = 0; i < 3 * triangles; i++)
        model.file.indices[i] = i;
    for (uint32_t i = 0; i < triangles; i++)
        memcpy(model.colors[i],
               (const float[4]){ (float)(i % 2), (float)(i % 3) / 2, 1 - (float)(i % 2), 0.4f },
               16);
    model.mesh = (FragmentMesh){ .positions = (const float(*)[3])(void *)model.file.positions,
                                 .vertex_count = 3 * triangles,
                                 .indices = model.file.indices,
                                 .triangle_count = triangles,
                                 .colors = (const float(*)[4])model.colors,
                                 .drawn = &model.geometry.drawn,
                                 .backwards = &model.geometry.backwards };
    assert_int_equal(fragment_geometry_make(&model.mesh, true, &model.geometry, &error), GP_OK);
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 1 }, &device, &error), GP_OK);
    if (technique_setting(&fragment_technique, options, (void **)&setting, &error) ||
        fragment_technique.build(&model, setting, device, &frame, &error) ||
        gp_device_run(device, &frame.list, &error) || fragment_model_truth(&model, 1, &error))
        fail_msg("%s: %s", options, error.text);
    const FragmentError off = fragment_error(&model, frame.color);
    frame_free(&frame);
    gp_free(setting);
    gp_device_destroy(&device);
    fragment_truth_free(&model.truth);
    convex_close(&model.convex);
    gp_free(model.facts);
    fragment_geometry_free(&model.geometry);
    gp_free(model.colors);
    gp_mesh_free(&model.file);
    return off;
}

static uint64_t wrong_of(const float (*corners)[3], uint32_t triangles, const char *options)
{
    return error_of(corners, triangles, options).wrong_beyond_edges;
}

/* Three sheets of one plane: of their fragments peeling sees one, dual peeling one of mixed
 * colours; lists keep them in the order of triangles. */
static void layers_in_one_plane_are_one_to_those_who_peel(void **state)
{
    (void)state;
    static const float sheets[][3] = { { -1, -1, 0 }, { 1, -1, 0 }, { 0, 1, 0 },
                                       { -1, -1, 0 }, { 1, -1, 0 }, { 0, 1, 0 },
                                       { -1, -1, 0 }, { 1, -1, 0 }, { 0, 1, 0 } };
    assert_true(wrong_of(sheets, 3, "--method dp") > 300);
    assert_true(wrong_of(sheets, 3, "--method ddp") > 300);
    assert_true(wrong_of(sheets, 3, "--method abuffer") == 0);
    assert_true(wrong_of(sheets, 3, "--method cpu") == 0);
    assert_true(wrong_of(sheets, 3, "--method sorted") == 0);
    assert_true(wrong_of(sheets, 3, "--method kbuffer --kept 3") == 0);
}

/* A nearer fragment that comes last moves those of one depth on by one place: none of them is lost,
 * and none is counted twice. */
static void lists_keep_layers_of_one_plane_in_their_order(void **state)
{
    (void)state;
    static const char *const lists[] = { "--method abuffer", "--method cpu", "--method stencil",
                                         "--method kbuffer" };
    static const float sheet[3][2] = { { -1, -1 }, { 1, -1 }, { 0, 1 } };
    float sheets[21][3];
    for (int i = 0; i < 21; i++) {
        memcpy(sheets[i], sheet[i % 3], sizeof sheet[0]);
        sheets[i][2] = i < 18 ? 0 : 1;
    }
    for (size_t i = 0; i < GP_COUNT(lists); i++)
        assert_true(wrong_of((const float(*)[3])sheets, 7, lists[i]) == 0);
}

/* Five layers closer than 16 bits of depth tell apart, drawn back to front, before one that is
 * far. */
static void close_layers_are_mixed_up_by_buckets_and_packed_depths(void **state)
{
    (void)state;
    static const char *const exact[] = { "--method dp", "--method ddp", "--method abuffer",
                                         "--method cpu" };
    static const char *const mixed[] = { "--method mdt", "--method bucket1", "--method bucket2",
                                         "--method adaptive" };
    static const float sheet[3][2] = { { -1, -1 }, { 1, -1 }, { 0, 1 } };
    float sheets[18][3];
    for (int i = 0; i < 18; i++) {
        memcpy(sheets[i], sheet[i % 3], sizeof sheet[0]);
        sheets[i][2] = i < 15 ? 1e-5f * (float)(i / 3) : -4;
    }
    for (size_t i = 0; i < GP_COUNT(mixed); i++) {
        assert_true(wrong_of((const float(*)[3])sheets, 6, mixed[i]) > 300);
        assert_true(wrong_of((const float(*)[3])sheets, 6, exact[i]) == 0);
    }
}

/* The near plane cuts triangles, some of which begin behind the eye; others are open, pass through
 * each other, have no area. */
static void open_meshes_from_inside_are_exact(void **state)
{
    (void)state;
    static const float walls[][3] = {
        { -5, -1, 0 }, { 5, -1, 0 },  { 0, 2, 5 },  { -4, 1, -2 },   { 4, 1, 1 },
        { 0, -3, 4 },  { -1, -2, 9 }, { 1, -2, 9 }, { 0, -0.5f, 0 }, { 0, 0, 0 },
        { 1, 1, 0 },   { 2, 2, 0 },   { -2, 2, 2 }, { 2, 2, -2 },    { 0, -2, 1 },
    };
    static const char *const exact[] = { "--method sorted", "--method dp", "--method ddp",
                                         "--method abuffer", "--method cpu" };
    for (size_t i = 0; i < GP_COUNT(exact); i++)
        assert_true(wrong_of(walls, 5, exact[i]) == 0);
}

/* A triangle alone, triangles without area, and the same one twice, once turned over. */
static void meshes_of_next_to_nothing_are_exact(void **state)
{
    (void)state;
    static const float corners[][3] = { { -1, -1, 0 },   { 1, -1, 0 },   { 0, 1, 0 },
                                        { 0.5f, 0, 1 },  { 0.5f, 0, 1 }, { 0.5f, 0, 1 },
                                        { -1, -1, -1 },  { 0, 0, -1 },   { 1, 1, -1 },
                                        { -1, 0, 0.5f }, { 1, 0, 0.5f }, { 0, 1, 0.5f },
                                        { 0, 1, 0.5f },  { 1, 0, 0.5f }, { -1, 0, 0.5f } };
    static const struct {
        int first;
        uint32_t count;
    } meshes[] = { { 0, 1 }, { 1, 1 }, { 1, 2 }, { 3, 2 }, { 0, 5 } };
    static const char *const exact[] = { "--method sorted",
                                         "--method convex",
                                         "--method convex --pieces merged",
                                         "--method convex --pieces outward --order grid",
                                         "--method abuffer",
                                         "--method cpu",
                                         "--method kbuffer",
                                         "--method stencil" };
    for (size_t i = 0; i < GP_COUNT(meshes) * GP_COUNT(exact); i++) {
        const float(*mesh)[3] = corners + 3 * meshes[i / GP_COUNT(exact)].first;
        const char *options = exact[i % GP_COUNT(exact)];
        if (wrong_of(mesh, meshes[i / GP_COUNT(exact)].count, options) > 0)
            fail_msg("mesh %zu, %s", i / GP_COUNT(exact), options);
    }
}

/* Triangles in a heap, most of which the near plane cuts: what is wrong lies at edges, or where two
 * of them cross, within the steps that corners are rounded to. */
static void a_heap_of_triangles_is_exact_but_for_the_steps_of_corners(void **state)
{
    (void)state;
    enum { TRIANGLES = 120 };
    static const char *const exact[] = { "--method sorted", "--method convex", "--method abuffer",
                                         "--method cpu" };
    float corners[3 * TRIANGLES][3];
    uint64_t at_crossings = 0;
    for (uint64_t seed = 0; seed < 12; seed++) {
        Random random = { seed };
        for (int i = 0; i < 3 * TRIANGLES; i++)
            for (int k = 0; k < 3; k++)
                corners[i][k] =
                    k < 2 ? random_float(&random, -1, 1) : random_float(&random, 1.7f, 2.8f);
        const FragmentError off =
            error_of((const float(*)[3])corners, TRIANGLES, exact[seed % GP_COUNT(exact)]);
        assert_int_equal(off.wrong_beyond_edges, off.wrong_at_crossings);
        at_crossings += off.wrong_at_crossings;
    }
    assert_true(at_crossings > 0);
}

/* --- bodies ----------------------------------------------------------------------------------- */

static void light_is_taken_on_its_way_through_a_body(void **state)
{
    (void)state;
    static const double sigmas[] = { 0.5, 1, 4 };
    static const char *const methods[] = { "--method dp", "--method sorted", "--method ddp" };
    GpError error;
    GpDevice *device;
    void *model, *setting;
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &device, &error), GP_OK);
    for (size_t i = 0; i < 2 * GP_COUNT(sigmas); i++) {
        FragmentOptions options = fragment_option_defaults;
        Frame frame = { .color = NULL };
        options.sigma = sigmas[i / 2];
        options.is_as_printed = i % 2;
        const TechniqueInput input = {
            .path = KNOT, .width = 128, .height = 128, .setting = &options
        };
        assert_int_equal(fragment_technique.open(&input, &model, &error), GP_OK);
        if (technique_setting(&fragment_technique, methods[i % GP_COUNT(methods)], &setting,
                              &error) ||
            fragment_technique.build(model, setting, device, &frame, &error) ||
            gp_device_run(device, &frame.list, &error) || fragment_model_truth(model, 2, &error))
            fail_msg("%s", error.text);
        assert_int_equal(fragment_error(model, frame.color).wrong_beyond_edges, 0);
        frame_free(&frame);
        gp_free(setting);
        fragment_technique.close(model);
    }
    gp_device_destroy(&device);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(methods_that_keep_all_fragments_are_exact),
        cmocka_unit_test(what_is_lost_is_seen_and_found_again),
        cmocka_unit_test(layers_in_one_plane_are_one_to_those_who_peel),
        cmocka_unit_test(lists_keep_layers_of_one_plane_in_their_order),
        cmocka_unit_test(close_layers_are_mixed_up_by_buckets_and_packed_depths),
        cmocka_unit_test(open_meshes_from_inside_are_exact),
        cmocka_unit_test(meshes_of_next_to_nothing_are_exact),
        cmocka_unit_test(a_heap_of_triangles_is_exact_but_for_the_steps_of_corners),
        cmocka_unit_test(light_is_taken_on_its_way_through_a_body),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
