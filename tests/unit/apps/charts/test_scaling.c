/* Scaling: which points a run makes of a table, the layout of their picture, and their files; no
 * time is judged. */
#include "apps/charts/chart_page.h"
#include "apps/charts/scaling_draw.h"
#include "apps/charts/scaling_file.h"
#include "apps/charts/scaling_run.h"
#include "apps/techniques/registry.h"
#include "apps/techniques/voxel/models.h"
#include "apps/techniques/voxel/technique.h"
#include "tests/support/folder.h"
#include "tests/support/markup.h"

#include <math.h>
#include <stdio.h>

/* --- a table of its own ----------------------------------------------------------------------- */

static double side(const void *scene, const Frame *frame)
{
    (void)scene;
    return ((const VoxelMade *)frame->made)->setting.size;
}

static double triangles(const void *scene, const Frame *frame)
{
    (void)frame;
    return ((const VoxelScene *)scene)->mesh.triangle_count;
}

static const TechniqueLine with_side[] = {
    { "thin, \"1\"", "builtin:cube", "--method thin --size 8|16|32" },
    { "solid", "builtin:cube", "--kind solid --size 8|16" },
    { .name = NULL },
};
static const TechniqueLine with_triangles[] = {
    { "solid", "builtin:cube|missing/a.ply|builtin:knot", "--kind solid --size 16" },
    { .name = NULL },
};
static const TechniqueSlope slopes[] = { { 3, "as <the cube>" }, { .name = NULL } };
static const char *const text[] = { "Why & how.", NULL };

static const TechniqueScaling table = {
    .title = "Growth & co",
    .text = text,
    .panels = { { "Sides", "voxels, a side", true, side, with_side, slopes },
                { "Meshes", "triangles", false, triangles, with_triangles, slopes } },
};

static Technique voxels(const TechniqueScaling *scaling)
{
    Technique technique = voxel_technique;
    technique.scaling = scaling;
    return technique;
}

static GpResult run(const Technique *technique, Scaling *scaling, GpError *error)
{
    GpDevice *device;
    const ChartListener nobody = { .notice = NULL };
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &device, error), GP_OK);
    GpResult result = scaling_run(technique, device, &nobody, 0, scaling, error);
    gp_device_destroy(&device);
    return result;
}

static void a_run_makes_all_points_of_the_table_in_order(void **state)
{
    (void)state;
    static const struct {
        int panel, line;
        double amount;
        const char *options;
    } expected[] = {
        { 0, 0, 8, "--method thin --size 8" },   { 0, 0, 16, "--method thin --size 16" },
        { 0, 0, 32, "--method thin --size 32" }, { 0, 1, 8, "--kind solid --size 8" },
        { 0, 1, 16, "--kind solid --size 16" },  { 1, 0, 12, "--kind solid --size 16" },
        { 1, 0, 0, "--kind solid --size 16" },
    };
    const Technique technique = voxels(&table);
    Scaling scaling;
    GpError error = { "" };
    assert_int_equal(run(&technique, &scaling, &error), GP_OK);
    assert_int_equal(scaling.count, GP_COUNT(expected));
    assert_int_equal(scaling.threads, 2);
    for (uint32_t i = 0; i < scaling.count; i++) {
        const ScalingPoint *point = &scaling.points[i];
        assert_int_equal(point->panel, expected[i].panel);
        assert_int_equal(point->line, expected[i].line);
        assert_string_equal(point->options, expected[i].options);
        if (expected[i].amount > 0)
            assert_true(point->amount == expected[i].amount);
        assert_true(point->time.frames > 0 && point->time.ms >= point->time.min_ms &&
                    point->time.min_ms > 0);
    }
    assert_string_equal(scaling.points[6].scene, "builtin:knot");
    assert_true(scaling.points[6].amount > 12);
    scaling_free(&scaling);
}

static void a_table_without_any_scene_fails(void **state)
{
    (void)state;
    static const TechniqueLine none[] = { { "thin", "missing/a.ply|missing/b.ply", "--size 8" },
                                          { .name = NULL } };
    static const TechniqueLine wrong[] = { { "thin", "builtin:cube", "--size 7" },
                                           { .name = NULL } };
    TechniqueScaling scaling_table = table;
    scaling_table.panels[0].lines = scaling_table.panels[1].lines = none;
    const Technique technique = voxels(&scaling_table);
    Scaling scaling = { .count = 77 };
    GpError error = { "" };
    assert_int_equal(run(&technique, &scaling, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, "missing/b.ply"));
    scaling_table.panels[0].lines = wrong;
    assert_int_equal(run(&technique, &scaling, &error), GP_ERROR_INVALID);
    assert_int_equal(scaling.count, 77);
}

static void the_tables_of_techniques_are_whole(void **state)
{
    (void)state;
    int failed = 0;
    for (const Technique *const *one = technique_registry; *one; one++) {
        const TechniqueScaling *scaling = (*one)->scaling;
        for (int p = 0; scaling && p < TECHNIQUE_PANELS; p++)
            for (const TechniqueLine *line = scaling->panels[p].lines; line->name; line++) {
                char options[8][SETTING_MAX_TEXT];
                void *setting = gp_alloc(1, (*one)->setting_bytes);
                size_t count = technique_expand(line->options, options, 8);
                GpError error = { "" };
                assert_in_range(count, 1, 8);
                for (size_t k = 0; k < count; k++)
                    if (setting_parse((*one)->settings, setting, options[k], &error)) {
                        print_error("%s\n", error.text);
                        failed++;
                    }
                gp_free(setting);
            }
    }
    assert_int_equal(failed, 0);
    assert_non_null(voxel_technique.scaling);
}

/* --- numbers without a clock ------------------------------------------------------------------ */

enum { POINTS = 7 };

/* Times that are the amount's square over 100, but one that is no number. */
static Scaling make_scaling(const Technique *technique)
{
    static const double amounts[POINTS] = { 8, 16, 32, 8, 16, 100, 4000 };
    Scaling scaling = { .technique = technique,
                        .machine = "m",
                        .isa = "i",
                        .threads = 1,
                        .points = gp_alloc(POINTS, sizeof *scaling.points),
                        .count = POINTS };
    for (int i = 0; i < POINTS; i++) {
        double ms = amounts[i] * amounts[i] / 100;
        scaling.points[i] = (ScalingPoint){ .panel = i >= 5,
                                            .line = i == 3 || i == 4,
                                            .amount = amounts[i],
                                            .time.ms = ms,
                                            .time.min_ms = ms / 2,
                                            .time.cpu_ms = 2 * ms,
                                            .time.frames = 9 };
        snprintf(scaling.points[i].scene, sizeof scaling.points[i].scene, "a/mesh<%d>.ply", i);
        snprintf(scaling.points[i].options, sizeof scaling.points[i].options, "--size %d", i);
    }
    scaling.points[4].time.ms = (double)NAN;
    return scaling;
}

static void the_picture_is_well_formed_and_has_every_point(void **state)
{
    (void)state;
    const Technique technique = voxels(&table);
    Scaling scaling = make_scaling(&technique);
    Text svg = { .data = NULL };
    scaling_draw(&scaling, &svg);
    assert_false(svg.failed);
    markup_check(svg.data);
    assert_int_equal(markup_count(svg.data, "<g><title>"), POINTS - 1);
    assert_int_equal(markup_count(svg.data, "as &lt;the cube&gt;"), 2);
    assert_int_equal(markup_count(svg.data, ">mesh&lt;5&gt;<"), 1);
    assert_int_equal(markup_count(svg.data, ">mesh&lt;0&gt;<"), 0);
    assert_null(strstr(svg.data, "nan"));
    static const char *const ticks[] = { ">8<", ">16<", ">32<", ">1,000<" };
    for (size_t i = 0; i < GP_COUNT(ticks); i++)
        assert_non_null(strstr(svg.data, ticks[i]));
    text_free(&svg);
    scaling_free(&scaling);
}

/* Places of the markers, in the order of the points: the last of the legend's two come before. */
static void find_markers(const char *svg, double (*places)[2], int count)
{
    const char *at = svg;
    for (int i = 0; i < count; i++) {
        at = strstr(at, "</title><path");
        assert_non_null(at);
        at = strstr(at, "translate(");
        assert_int_equal(sscanf(at, "translate(%lf %lf)", &places[i][0], &places[i][1]), 2);
    }
}

/* Powers are straight lines, with one scale of times in both panels. */
static void powers_are_straight_lines(void **state)
{
    (void)state;
    const Technique technique = voxels(&table);
    Scaling scaling = make_scaling(&technique);
    Text svg = { .data = NULL };
    double at[POINTS - 1][2];
    scaling_draw(&scaling, &svg);
    find_markers(svg.data, at, POINTS - 1);
    for (int k = 0; k < 2; k++)
        assert_true(fabs((at[1][k] - at[0][k]) - (at[2][k] - at[1][k])) < 0.25);
    assert_true(at[1][0] > at[0][0] && at[1][1] < at[0][1]);
    assert_true(fabs(at[3][0] - at[0][0]) < 0.06 && fabs(at[3][1] - at[0][1]) < 0.06);
    assert_true(at[4][0] > at[2][0] + 100);
    /* four times the time, and 1600 times */
    double four = at[0][1] - at[1][1], more = at[4][1] - at[5][1];
    assert_true(fabs(more / four - log(1600) / log(4)) < 0.02);
    text_free(&svg);
    scaling_free(&scaling);
}

/* Times were made as the square: nothing else is said, whatever a technique expects. */
static void powers_are_those_of_the_points(void **state)
{
    (void)state;
    const Technique technique = voxels(&table);
    Scaling scaling = make_scaling(&technique);
    ScalingPower power = { .power = 77 };
    Text svg = { .data = NULL };
    assert_true(scaling_power(&scaling, 0, 0, &power));
    assert_true(fabs(power.power - 2) < 1e-9 && fabs(power.least - 2) < 1e-9 &&
                fabs(power.most - 2) < 1e-9);
    scaling.points[2].time.ms *= 4; /* 8 16 32: the square, then the fourth power */
    assert_true(scaling_power(&scaling, 0, 0, &power));
    assert_true(fabs(power.power - 3) < 1e-9 && fabs(power.least - 2) < 1e-9 &&
                fabs(power.most - 4) < 1e-9);
    scaling.points[1].amount = 9; /* too near to the first to have a slope with it */
    assert_true(scaling_power(&scaling, 0, 0, &power));
    assert_true(power.least == power.most &&
                fabs(power.least -
                     log(scaling.points[2].time.ms / scaling.points[0].time.ms) / log(4)) < 1e-9);
    scaling.points[1].amount = 16;
    power.power = 77;
    assert_false(scaling_power(&scaling, 0, 1, &power)); /* one of two times is no number */
    assert_true(power.power == 77);
    scaling_draw(&scaling, &svg);
    assert_non_null(strstr(svg.data, ">thin, &quot;1&quot;: 3.00 (2.00 to 4.00)<"));
    json_t *object = scaling_json(&scaling), *powers = json_object_get(object, "powers");
    assert_int_equal(json_array_size(powers), 2);
    assert_true(fabs(json_number_value(json_object_get(json_array_get(powers, 0), "most")) - 4) <
                1e-9);
    json_decref(object);
    scaling.points[1].time.ms = 0.999999 * scaling.points[0].time.ms;
    text_free(&svg);
    scaling_draw(&scaling, &svg);
    assert_null(strstr(svg.data, "-0.00"));
    assert_non_null(strstr(svg.data, " (0.00 to "));
    text_free(&svg);
    scaling_free(&scaling);
}

static void bars_are_the_middle_half_of_the_times(void **state)
{
    (void)state;
    const Technique technique = voxels(&table);
    Scaling scaling = make_scaling(&technique);
    Text svg = { .data = NULL };
    scaling.points[0].time.low_ms = 0.9 * scaling.points[0].time.ms;
    scaling.points[0].time.high_ms = 3 * scaling.points[0].time.ms;
    scaling_draw(&scaling, &svg);
    assert_int_equal(markup_count(svg.data, "h6.0m-3.0 0V"), 1);
    text_free(&svg);
    scaling_free(&scaling);
}

static void no_points_are_a_picture_too(void **state)
{
    (void)state;
    const Technique technique = voxels(&table);
    const Scaling scaling = { .technique = &technique };
    Text svg = { .data = NULL };
    scaling_draw(&scaling, &svg);
    markup_check(svg.data);
    assert_int_equal(markup_count(svg.data, "<g><title>"), 0);
    text_free(&svg);
}

/* --- files ------------------------------------------------------------------------------------ */

static char content[1 << 17];

static void files_are_csv_and_svg(void **state)
{
    (void)state;
    const Technique technique = voxels(&table);
    Scaling scaling = make_scaling(&technique);
    GpError error = { "" };
    scaling.count = 2;
    assert_int_equal(scaling_write(in_folder("g"), &scaling, &error), GP_OK);
    assert_int_equal(folder_count(false), 2);
    get_text("g.csv", content, sizeof content);
    assert_string_equal(content, "grows,amount,method,scene,options,ms,min_ms,cpu_ms,frames\n"
                                 "\"voxels, a side\",8,\"thin, \"\"1\"\"\",a/mesh<0>.ply,--size 0,"
                                 "0.64,0.32,1.28,9\n"
                                 "\"voxels, a side\",16,\"thin, \"\"1\"\"\",a/mesh<1>.ply,--size 1,"
                                 "2.56,1.28,5.12,9\n");
    get_text("g.svg", content, sizeof content);
    markup_check(content);
    assert_int_equal(scaling_write(in_folder("none/g"), &scaling, &error), GP_ERROR_IO);
    scaling_free(&scaling);
}

static void json_has_an_object_for_each_point(void **state)
{
    (void)state;
    const Technique technique = voxels(&table);
    Scaling scaling = make_scaling(&technique);
    json_t *object = scaling_json(&scaling), *points = json_object_get(object, "points");
    assert_int_equal(json_array_size(points), POINTS);
    json_t *last = json_array_get(points, POINTS - 1);
    assert_string_equal(json_string_value(json_object_get(last, "grows")), "triangles");
    assert_string_equal(json_string_value(json_object_get(last, "method")), "solid");
    assert_true(json_real_value(json_object_get(last, "amount")) == 4000);
    json_t *absent = json_object_get(json_array_get(points, 4), "ms");
    assert_string_equal(json_string_value(absent), "nan");
    json_decref(object);
    scaling_free(&scaling);
}

static void the_page_shows_the_scaling_of_techniques_that_declare_it(void **state)
{
    (void)state;
    const Technique technique = voxels(voxel_technique.scaling);
    Scaling scaling = make_scaling(&technique);
    GpError error = { "" };
    assert_int_equal(scaling_write(in_folder("voxelize_scaling"), &scaling, &error), GP_OK);
    put_text("shadow_scaling.svg", "<svg>");
    put_text("other_scaling.svg", "<svg>");
    assert_int_equal(chart_write_page(folder, technique_registry, &error), GP_OK);
    get_text("index.html", content, sizeof content);
    markup_check(content);
    assert_int_equal(markup_count(content, "<svg"), 1);
    assert_int_equal(markup_count(content, "<section id=\"voxelize_scaling\">"), 1);
    assert_int_equal(markup_count(content, "<a href=\"#voxelize_scaling\">"), 1);
    assert_non_null(strstr(content, "Two costs add up."));
    assert_non_null(strstr(content, "<dt>solid: xor</dt>"));
    scaling_free(&scaling);
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_run_makes_all_points_of_the_table_in_order),
        cmocka_unit_test(a_table_without_any_scene_fails),
        cmocka_unit_test(the_tables_of_techniques_are_whole),
        cmocka_unit_test(the_picture_is_well_formed_and_has_every_point),
        cmocka_unit_test(powers_are_straight_lines),
        cmocka_unit_test(powers_are_those_of_the_points),
        cmocka_unit_test(bars_are_the_middle_half_of_the_times),
        cmocka_unit_test(no_points_are_a_picture_too),
        IN_FOLDER(files_are_csv_and_svg),
        cmocka_unit_test(json_has_an_object_for_each_point),
        IN_FOLDER(the_page_shows_the_scaling_of_techniques_that_declare_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
