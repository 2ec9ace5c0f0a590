/* How splats fail, each failure beside its remedy, as rows of a table; and that what is whole stays
 * whole from all round. Popping has a test of its own (test_popping.c), and so have what bytes do
 * to normals and tangents (test_compress.c). */
#include "apps/techniques/points/technique.h"

#include "apps/techniques/points/model.h"
#include "tests/support/groups/device.h"
#include "tests/support/scene_text.h"
#include "tests/support/unit.h"

#include <stdio.h>

enum { SIDE = 128 };

/* What is seen, and how. */
typedef struct Model {
    const char *path;
    uint32_t subdivide;
    double waves;         /* 0: one colour, lit */
    const Camera *camera; /* NULL: one that shows all of it */
} Model;

/* A figure of a picture, and what it must lie between. */
typedef struct Row {
    const char *name;
    const Model *model;
    const char *options, *metric;
    double low, high; /* both included */
} Row;

/* --- measuring -------------------------------------------------------------------------------- */

static PointsModel *open_model(const Model *model, PointsOptions *options)
{
    const TechniqueInput input = {
        .path = model->path, .width = SIDE, .height = SIDE, .setting = options
    };
    GpError error;
    void *opened;
    options->subdivide = model->subdivide;
    if (points_technique.open(&input, &opened, &error))
        fail_msg("%s: %s", model->path, error.text);
    PointsModel *made = opened;
    made->view.waves = model->waves;
    made->view.lit = !(model->waves > 0);
    if (model->camera)
        made->view.camera = *model->camera;
    return made;
}

static PointsError draw(PointsModel *model, const PointsOptions *options)
{
    GpError error;
    Frame frame = { .color = NULL };
    if (points_model_truth(model, 2, &error) ||
        points_technique.build(model, options, device, &frame, &error) ||
        gp_device_run(device, &frame.list, &error))
        fail_msg("%s", error.text);
    const PointsError off = points_error(&model->truth, frame.color);
    frame_free(&frame);
    return off;
}

static double figure(const PointsError *off, const char *metric)
{
    const struct {
        const char *name;
        double value;
    } figures[] = {
        { "decibels", off->interior_psnr },
        { "holes", off->holes },
        { "area", 100 * off->area_error },
        { "largest", 255 * off->largest },
    };
    for (size_t i = 0; i < GP_COUNT(figures); i++)
        if (strcmp(figures[i].name, metric) == 0)
            return figures[i].value;
    fail_msg("no figure is called %s", metric);
    return 0;
}

static PointsOptions *parse(const char *text)
{
    GpError error;
    void *options;
    if (technique_setting(&points_technique, text, &options, &error))
        fail_msg("%s: %s", text, error.text);
    return options;
}

static bool holds(const Row *row)
{
    PointsOptions *options = parse(row->options);
    PointsModel *model = open_model(row->model, options);
    const PointsError off = draw(model, options);
    const double value = figure(&off, row->metric);
    points_technique.close(model);
    gp_free(options);
    if (value >= row->low && value <= row->high)
        return true;
    print_error("%s: %s: %s is %g, not in [%g, %g]\n", row->name, row->options, row->metric, value,
                row->low, row->high);
    return false;
}

static void check(const Row *rows, size_t count)
{
    int failed = 0;
    for (size_t i = 0; i < count; i++)
        failed += !holds(&rows[i]);
    assert_int_equal(failed, 0);
}

/* --- failures and remedies -------------------------------------------------------------------- */

/* Some 3.5 degrees above a plane, from afar, so that no patch is at a silhouette: discs of 3 x 0.2
 * pixels, and waves a pixel long as they are seen foreshortened. */
static const Camera grazing = { .eye = { 0, 2.4, 39.93 },
                                .at = { 0, 0, 0 },
                                .up = { 0, 1, 0 },
                                .fovy = 0.513,
                                .near = 30,
                                .far = 50 };

static void the_determinant_hides_thin_splats(void **state)
{
    (void)state;
    static const Model plane = { "builtin:plane", 7, 130, &grazing };
    static const Row rows[] = {
        { "printed", &plane, "--method area", "decibels", 0, 18 },
        { "both eigenvalues", &plane, "--method adaptive", "decibels", 21, 99 },
        { "both filters", &plane, "--method ewa", "decibels", 21, 99 },
    };
    check(rows, GP_COUNT(rows));
}

static const Model knot = { "builtin:knot", 0, 6, NULL },
                   fine_knot = { "builtin:knot", 3, 60, NULL };

static void one_filter_is_not_enough(void **state)
{
    (void)state;
    static const Row rows[] = {
        { "low-pass alone, near", &knot, "--method lowpass", "decibels", 0, 20 },
        { "reconstruction alone, far", &fine_knot, "--method reconstruction", "decibels", 0, 25 },
        { "both, near", &knot, "--method ewa", "decibels", 25, 99 },
        { "both, far", &fine_knot, "--method ewa", "decibels", 27, 99 },
    };
    check(rows, GP_COUNT(rows));
}

/* Two sheets face the eye, 0.1 apart: in front blue is 0.5, behind it 0. */
static const char sheets[] = "OFF\n8 4 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n"
                             "-1 -1 -0.1\n1 -1 -0.1\n1 1 -0.1\n-1 1 -0.1\n"
                             "3 0 1 2\n3 0 2 3\n3 4 5 6\n3 4 6 7\n";

static const Camera front = {
    .eye = { 0, 0, 4 }, .at = { 0, 0, 0 }, .up = { 0, 1, 0 }, .fovy = 26, .near = 0.1, .far = 20
};

static void epsilon_is_neither_too_small_nor_too_large(void **state)
{
    (void)state;
    char path[TEMPORARY_PATH], name[TEMPORARY_PATH + 8];
    put_temporary(sheets, sizeof sheets - 1, path);
    snprintf(name, sizeof name, "%s.off", path);
    assert_int_equal(rename(path, name), 0);
    const Model wall = { name, 5, 15.707963267948966, &front };
    const Row rows[] = {
        { "discs", &knot, "--method ewa --epsilon 0", "decibels", 0, 25 },
        { "a surface", &knot, "--method ewa --epsilon 2", "decibels", 28, 99 },
        { "through a wall", &wall, "--method ewa --epsilon 4", "decibels", 0, 25 },
        { "a wall", &wall, "--method ewa --epsilon 1", "decibels", 27, 99 },
    };
    check(rows, GP_COUNT(rows));
    unlink(name);
}

/* Just above a plane, whose points lie below, beside and behind the eye too. */
#define WITHIN(NEAR)                                                                               \
    {                                                                                              \
        .eye = { 0, 0.05, 0 }, .at = { 0, 0.03, -1 }, .up = { 0, 1, 0 }, .fovy = 60, .near = NEAR, \
        .far = 20                                                                                  \
    }

static void nothing_blows_up_at_the_eye_plane(void **state)
{
    (void)state;
    static const Camera near = WITHIN(0.02), cut = WITHIN(0.075);
    static const Model coarse = { "builtin:plane", 5, 6, &near },
                       fine = { "builtin:plane", 7, 6, &near },
                       away = { "builtin:plane", 7, 6, &cut };
    static const Row rows[] = {
        { "discs larger than the eye is high", &coarse, "--method ewa", "area", 10, 40 },
        { "smaller ones", &fine, "--method ewa", "area", -2, 4 },
        { "... whole to below the eye", &fine, "--method ewa", "decibels", 40, 99 },
        { "cut off", &away, "--method ewa", "decibels", 25, 99 },
        { "... whichever filter", &away, "--method adaptive", "decibels", 25, 99 },
    };
    check(rows, GP_COUNT(rows));
}

/* From inside a ball, whose points are turned away from the eye, and half of them behind it. */
static void what_is_behind_the_eye_does_not_show(void **state)
{
    (void)state;
    static const Camera within = { .eye = { 0, 0, 0.2 },
                                   .at = { 0, 0, -1 },
                                   .up = { 0, 1, 0 },
                                   .fovy = 60,
                                   .near = 0.01,
                                   .far = 20 };
    static const Model ball = { "builtin:sphere", 3, 6, &within };
    static const Row rows[] = {
        { "both filters", &ball, "--method ewa --two-sided", "decibels", 40, 99 },
        { "discs", &ball, "--method sprites --two-sided", "decibels", 20, 99 },
    };
    check(rows, GP_COUNT(rows));
}

/* Printed thresholds are of areas, and what is turned away has one too. */
static void filters_are_chosen_for_backs_too(void **state)
{
    (void)state;
    static const Camera within = { .eye = { 0, 0, 0.2 },
                                   .at = { 0, 0, -1 },
                                   .up = { 0, 1, 0 },
                                   .fovy = 60,
                                   .near = 0.8,
                                   .far = 20 };
    static const Model coarse = { "builtin:sphere", 0, 1, &within },
                       ball = { "builtin:sphere", 2, 1, &within };
    static const Row rows[] = {
        { "both filters, coarse", &coarse, "--method ewa --two-sided", "holes", 0, 0 },
        { "by distance", &coarse, "--method distance --two-sided", "holes", 0, 0 },
        { "by areas", &coarse, "--method area --two-sided", "holes", 0, 0 },
        { "both filters", &ball, "--method ewa --two-sided", "decibels", 40, 99 },
        { "by distance", &ball, "--method distance --two-sided", "decibels", 40, 99 },
        { "by areas", &ball, "--method area --two-sided", "decibels", 40, 99 },
    };
    check(rows, GP_COUNT(rows));
}

static void sums_of_bytes_saturate_and_vanish(void **state)
{
    (void)state;
    static const Model ball = { "builtin:sphere", 3, 6, NULL };
    static const Row rows[] = {
        { "bytes", &ball, "--method ewa --sums byte", "decibels", 0, 44 },
        { "halves", &ball, "--method ewa --sums half", "decibels", 50, 99 },
        { "floats", &ball, "--method ewa --sums float", "decibels", 50, 99 },
    };
    check(rows, GP_COUNT(rows));
}

static const Model torus = { "builtin:torus", 0, 6, NULL };

static void radii_too_small_leave_holes(void **state)
{
    (void)state;
    static const Row rows[] = {
        { "narrow Gaussians", &torus, "--method ewa --spread 0.1", "decibels", 0, 25 },
        { "as wide as discs need", &torus, "--method ewa", "decibels", 28, 99 },
        { "pixels", &torus, "--method pixels", "holes", 1000, 20000 },
        { "discs", &torus, "--method sprites", "holes", 0, 0 },
    };
    check(rows, GP_COUNT(rows));
}

/* --- from all round --------------------------------------------------------------------------- */

/* Moves the eye around what it looks at. */
static void look_from(const double way[3], Camera *camera)
{
    double away[3];
    vector_subtract(camera->eye, camera->at, away);
    const double distance = sqrt(vector_dot(away, away) / vector_dot(way, way));
    vector_set(camera->eye, camera->at[0], camera->at[1], camera->at[2]);
    vector_add_scaled(camera->eye, distance, way, camera->eye);
    vector_set(camera->up, 0.1, 1, 0.2); /* along none of the ways */
}

/* Sums over 26 ways and both methods. */
static int holes_all_round(const Model *seen, const char *const texts[2])
{
    PointsOptions *options[2] = { parse(texts[0]), parse(texts[1]) };
    PointsModel *model = open_model(seen, options[0]);
    int holes = 0;
    for (int i = 0; i < 27; i++) {
        const double way[3] = { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 };
        if (i == 13)
            continue;
        look_from(way, &model->view.camera);
        mesh_picture_free(&model->truth);
        for (int k = 0; k < 2; k++) {
            const PointsError off = draw(model, options[k]);
            if (off.holes > 0)
                print_message("# %s %s from %g %g %g: %g holes\n", seen->path, texts[k], way[0],
                              way[1], way[2], off.holes);
            holes += (int)off.holes;
        }
    }
    points_technique.close(model);
    gp_free(options[0]);
    gp_free(options[1]);
    return holes;
}

static void watertight_samplings_have_no_hole_from_all_round(void **state)
{
    (void)state;
    static const Model models[] = { { "builtin:sphere", 2, 6, NULL },
                                    { "builtin:torus", 0, 6, NULL },
                                    { "builtin:knot", 0, 6, NULL } };
    static const char *const options[] = { "--method ewa", "--method adaptive" };
    int holes = 0;
    for (size_t i = 0; i < GP_COUNT(models); i++)
        holes += holes_all_round(&models[i], options);
    assert_int_equal(holes, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_determinant_hides_thin_splats),
        cmocka_unit_test(one_filter_is_not_enough),
        cmocka_unit_test(epsilon_is_neither_too_small_nor_too_large),
        cmocka_unit_test(nothing_blows_up_at_the_eye_plane),
        cmocka_unit_test(what_is_behind_the_eye_does_not_show),
        cmocka_unit_test(filters_are_chosen_for_backs_too),
        cmocka_unit_test(sums_of_bytes_saturate_and_vanish),
        cmocka_unit_test(radii_too_small_leave_holes),
        cmocka_unit_test(watertight_samplings_have_no_hole_from_all_round),
    };
    return cmocka_run_group_tests(tests, device_set_up, device_tear_down);
}
