/* --error: what is chosen keeps it, on scenes made at random, whatever the chart says. The judge
 * opens the scene, finds the truth and draws the setting afresh.
 *
 * A few small ones; `make check` sets GP_TEST_PROMISES to a seed, and then there are forty,
 * large. */
#include "apps/charts/promise.h"
#include "apps/techniques/registry.h"
#include "tests/support/folder.h"
#include "tests/support/random_scene.h"
#include "tests/support/technique/technique_case.h"

#include <math.h>

enum { LEVELS = 5, THREADS = 2 };

/* Seed and number of scenes, and how large they are. */
typedef struct Round {
    uint64_t seed;
    int scenes, least, most; /* sides of pictures, or voxels: least and most of the sweep */
} Round;

static bool is_long(void)
{
    return getenv("GP_TEST_PROMISES") != NULL;
}

static Round round_of(int scenes, int least, int most)
{
    const char *seed = getenv("GP_TEST_PROMISES");
    if (!seed)
        return (Round){ 1, scenes, least, most };
    print_message("# GP_TEST_PROMISES=%s\n", seed);
    return (Round){ strtoull(seed, NULL, 10), 40, 256, 2048 };
}

static GpDevice *new_device(void)
{
    GpDevice *device;
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = THREADS }, &device, NULL), GP_OK);
    return device;
}

/* --- charts that are wrong -------------------------------------------------------------------- */

/* All settings of a sweep with times and errors out of the air. */
static Chart random_chart(Random *random, const Experiment *experiment)
{
    Chart chart = { .points = gp_alloc(CHART_MAX_POINTS, sizeof *chart.points) };
    SettingText *texts = gp_alloc(CHART_MAX_POINTS, sizeof *texts);
    for (const TechniqueSweep *row = experiment->sweep; row->method; row++) {
        const size_t count = technique_expand(row->options, texts, CHART_MAX_POINTS);
        for (size_t i = 0; i < count; i++) {
            ChartPoint *point = &chart.points[chart.count++];
            snprintf(point->method, sizeof point->method, "%s", row->method);
            snprintf(point->options, sizeof point->options, "%s", texts[i]);
            point->time.ms = random_int(random, 1, 100);
            point->time.low_ms = 0.8 * point->time.ms;
            point->time.high_ms = 1.3 * point->time.ms;
            point->measured.error = exp(random_int(random, 0, 120) / 10.0);
            point->measured.whole = 1e5;
        }
    }
    gp_free(texts);
    return chart;
}

/* --- the judge -------------------------------------------------------------------------------- */

/* A scene of its own, with its truth. */
typedef struct Judge {
    const Technique *technique;
    const Experiment *experiment;
    void *scene;
    GpDevice *device;
    double least[2]; /* of the sweep: in the unit, in per cent; negative: not looked for */
} Judge;

static void judge_open(Judge *judge, const char *path)
{
    GpError error = { "" };
    judge->device = new_device();
    if (technique_open(judge->technique, path, 0, 0, &judge->scene, &error) ||
        judge->experiment->find_truth(judge->scene, THREADS, &error))
        fail_msg("%s: %s", path, error.text);
}

static void judge_close(Judge *judge)
{
    judge->technique->close(judge->scene);
    gp_device_destroy(&judge->device);
}

/* The error of a setting in its unit and in per cent; infinite where it does not go with the
 * scene. */
static void judge_error(const Judge *judge, const char *options, double errors[2])
{
    TechniqueError measured;
    Frame frame = { .color = NULL };
    GpError error = { "" };
    GpResult result =
        technique_build(judge->technique, judge->scene, options, judge->device, &frame, &error);
    errors[0] = errors[1] = HUGE_VAL;
    if (result == GP_ERROR_INVALID)
        return;
    if (result || gp_device_run(judge->device, &frame.list, &error) ||
        judge->experiment->measure(judge->scene, &frame, &measured, &error))
        fail_msg("%s: %s", options, error.text);
    frame_free(&frame);
    errors[0] = measured.error;
    errors[1] = measured.error > 0 ? 100 * measured.error / measured.whole : 0;
}

static double least_of_sweep(Judge *judge, bool per_cent)
{
    if (judge->least[0] >= 0)
        return judge->least[per_cent];
    SettingText *texts = gp_alloc(CHART_MAX_POINTS, sizeof *texts);
    judge->least[0] = judge->least[1] = HUGE_VAL;
    for (const TechniqueSweep *row = judge->experiment->sweep; row->method; row++) {
        const size_t count = technique_expand(row->options, texts, CHART_MAX_POINTS);
        for (size_t i = 0; i < count; i++) {
            double errors[2];
            judge_error(judge, texts[i], errors);
            for (int k = 0; k < 2; k++)
                judge->least[k] = fmin(judge->least[k], errors[k]);
        }
    }
    gp_free(texts);
    return judge->least[per_cent];
}

/* --- promises --------------------------------------------------------------------------------- */

/* Asks for an error and judges what is chosen. */
static void expect_promise(const PromiseJob *job, Judge *judge, Measured *measured,
                           const char *what)
{
    Promise promise;
    GpError error = { "" };
    if (promise_choose(job, measured, &promise, &error))
        fail_msg("%s: %s", what, error.text);
    const char *options = promise.chosen.options;
    double errors[2];
    judge_error(judge, options, errors);
    const double found = errors[job->per_cent];
    const double told = job->per_cent ? chart_per_cent(&promise.measured) : promise.measured.error;
    if (found != told)
        fail_msg("%s: %s: error %.17g, not the %.17g that was told", what, options, found, told);
    if (promise.is_kept != (found <= job->most))
        fail_msg("%s: %s: error %g, %g was asked for, and %s said", what, options, found, job->most,
                 promise.is_kept ? "kept" : "not reached");
    if (promise.is_kept)
        return;
    const double least = least_of_sweep(judge, job->per_cent);
    if (least <= job->most || least < found)
        fail_msg("%s: not reached with %g, but the sweep has %g, and %g was asked for", what, found,
                 least, job->most);
}

/* Five levels, in the experiment's unit and in per cent, from none at all to what anything
 * holds. */
static void expect_promises(const Technique *technique, const Experiment *experiment,
                            const char *path, Random *random)
{
    static const double per_cents[LEVELS] = { 0, 0.05, 0.3, 2, 12 };
    Judge judge = { .technique = technique, .experiment = experiment, .least = { -1 } };
    void *scene;
    GpError error = { "" };
    GpDevice *device = new_device();
    judge_open(&judge, path);
    if (technique_open(technique, path, 0, 0, &scene, &error))
        fail_msg("%s", error.text);
    Chart chart = random_chart(random, experiment);
    Measured measured = { .settings = json_object() };
    for (int i = 0; i < LEVELS; i++) {
        char what[128];
        const bool has_chart = random_int(random, 0, 1), per_cent = random_int(random, 0, 1);
        const PromiseJob job = { .technique = technique,
                                 .experiment = experiment,
                                 .chart = has_chart ? &chart : NULL,
                                 .scene = scene,
                                 .setting = technique->defaults,
                                 .extension = technique->volume ? "nrrd" : "png",
                                 .device = device,
                                 .most = per_cents[i] * (per_cent ? 1 : 10),
                                 .per_cent = per_cent };
        snprintf(what, sizeof what, "%s, level %d%s%s", path, i, per_cent ? ", per cent" : "",
                 has_chart ? ", with a chart" : "");
        expect_promise(&job, &judge, &measured, what);
    }
    measured_close(&measured);
    chart_free(&chart);
    judge_close(&judge);
    technique->close(scene);
    gp_device_destroy(&device);
}

static void shadows_keep_their_error_on_any_scene(void **state)
{
    (void)state;
    static const TechniqueSweep small_maps[] = {
        { "plain", "--method plain --filter nearest --map 64|256 --bias 0.001|0.004" },
        { "16 bits", "--fit light --depth d16 --map 64|256" },
        { "fit, near sides", "--casters near --depth d32f --map 64|256|512" },
        { "fit to the eye", "--fit eye --casters near --depth d32f --map 64|256|512" },
        { "adaptive", "--fit adaptive --casters near --depth d32f --map 64|128" },
        { "soft", "--method plain --filter soft --map 64|256" },
        { .method = NULL },
    };
    const Technique *technique = technique_find(technique_registry, "shadow");
    const Round round = round_of(5, 16, 64);
    Experiment experiment = technique->experiments[0];
    if (!is_long())
        experiment.sweep = small_maps;
    for (int i = 0; i < round.scenes; i++) {
        Random random = { round.seed + (uint64_t)i };
        char text[4096], name[32];
        random_scene(&random, round.least, round.most, is_long(), text, sizeof text);
        snprintf(name, sizeof name, "scene%d.json", i);
        expect_promises(technique, &experiment, put_text(name, text), &random);
    }
}

/* The mechanism with all methods; in short, volumes that are found quickly. */
static void volumes_keep_their_error_on_any_model(void **state)
{
    (void)state;
    static const TechniqueSweep surfaces[] = {
        { "conservative", "--method conservative --size 8|16|24" },
        { "thin", "--method thin --size 8|16|24" },
        { "sheets", "--method sheets --blend add|or --size 8|16" },
        { .method = NULL },
    };
    static const TechniqueSweep solids[] = {
        { "xor", "--kind solid --method xor --size 8|16|24" },
        { "slices", "--kind solid --method slices --size 8|16" },
        { .method = NULL },
    };
    const Technique *technique = technique_find(technique_registry, "voxelize");
    const Round round = round_of(2, 0, 0);
    for (int i = 0; i < round.scenes; i++) {
        Random random = { round.seed + 1000 + (uint64_t)i };
        const char *model = random_model(&random, is_long());
        for (int solid = 0; solid < 2; solid++) {
            Experiment experiment = technique->experiments[solid];
            if (!is_long() || i > 2) /* all sizes of the sweeps take a minute a model */
                experiment.sweep = solid ? solids : surfaces;
            expect_promises(technique, &experiment, model, &random);
        }
    }
}

/* What is known without drawing changes how many are drawn, and nothing else. */
static void what_is_ruled_out_would_not_have_been_chosen(void **state)
{
    (void)state;
    static const TechniqueSweep sweep[] = {
        { "thin", "--method thin --size 8|16|24" },
        { "conservative", "--method conservative --size 8|16|24" },
        { "slices", "--method slices --size 8|16" },
        { .method = NULL },
    };
    static const double most[] = { 0, 20, 25, 30, 60, 200 };
    const Technique *technique = technique_find(technique_registry, "voxelize");
    GpDevice *device = new_device();
    uint32_t ruled_out = 0;
    void *scene;
    assert_int_equal(technique_open(technique, "builtin:torus", 0, 0, &scene, NULL), GP_OK);
    for (size_t i = 0; i < GP_COUNT(most); i++) {
        Promise promises[2];
        for (int all = 0; all < 2; all++) {
            Experiment experiment = technique->experiments[0];
            experiment.sweep = sweep;
            if (all)
                experiment.least_error = NULL;
            const PromiseJob job = { .technique = technique,
                                     .experiment = &experiment,
                                     .scene = scene,
                                     .setting = technique->defaults,
                                     .extension = "nrrd",
                                     .device = device,
                                     .most = most[i] };
            Measured measured = { .settings = json_object() };
            assert_int_equal(promise_choose(&job, &measured, &promises[all], NULL), GP_OK);
            measured_close(&measured);
        }
        assert_string_equal(promises[0].chosen.options, promises[1].chosen.options);
        assert_true(promises[0].measured.error == promises[1].measured.error);
        assert_int_equal(promises[0].is_kept, promises[1].is_kept);
        assert_int_equal(promises[0].tried, promises[1].tried);
        assert_int_equal(promises[0].drawn + promises[0].ruled_out, promises[1].drawn);
        ruled_out += promises[0].ruled_out;
    }
    assert_true(ruled_out > 10);
    technique->close(scene);
    gp_device_destroy(&device);
}

/* Where half of a light is enough to know, the errors are those of all of it. */
static void the_truth_for_errors_alone_has_the_same_errors(void **state)
{
    (void)state;
    static const char scene[] =
        "{ \"size\": [48, 40], \"camera\": { \"eye\": [2, 1.5, 3], \"at\": [0, 0, 0], \"fovy\": 40 "
        "},"
        "  \"lights\": [ { \"position\": [1, 2, 1], \"at\": [0, 0, 0], \"size\": 0.7 } ],"
        "  \"objects\": [ { \"mesh\": \"builtin:plane\" },"
        "                 { \"mesh\": \"builtin:torus\", \"fit\": [0, 0.5, 0, 1] } ] }";
    static const char *const options[] = { "--map 32", "--map 256", "--bias 0",
                                           "--method plain --filter soft --map 128" };
    const Technique *technique = technique_find(technique_registry, "shadow");
    double errors[2][GP_COUNT(options)][2];
    for (int alone = 0; alone < 2; alone++) {
        Experiment experiment = technique->experiments[0];
        if (alone)
            experiment.find_truth = experiment.find_truth_error;
        Judge judge = { .technique = technique, .experiment = &experiment };
        judge_open(&judge, put_text("area.json", scene));
        for (size_t i = 0; i < GP_COUNT(options); i++)
            judge_error(&judge, options[i], errors[alone][i]);
        judge_close(&judge);
    }
    for (size_t i = 0; i < GP_COUNT(options); i++)
        assert_true(errors[0][i][0] == errors[1][i][0] && errors[0][i][1] == errors[1][i][1]);
    assert_true(errors[0][0][0] > 5);
}

/* --- what is remembered ----------------------------------------------------------------------- */

static const char cube[] =
    "{ \"size\": [24, 20], \"lights\": [ { \"direction\": [1, 2, 1] } ],\n"
    "  \"camera\": { \"eye\": [2, 1.5, 3], \"at\": [0, 0, 0], \"fovy\": 40 },\n"
    "  \"objects\": [ { \"mesh\": \"builtin:plane\" }, { \"mesh\": \"%s\" } ] }\n";

static const char tetrahedron[] =
    "OFF\n4 4 0\n0 0 0\n%g 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

static uint64_t key_of(const char *path, uint32_t width, const void *setting)
{
    const Technique *technique = technique_find(technique_registry, "shadow");
    const TechniqueInput input = { .path = path,
                                   .width = width,
                                   .height = width,
                                   .setting = setting ? setting : technique->defaults };
    return measured_key(technique, technique->experiments, &input);
}

static void the_key_changes_with_all_that_a_measurement_depends_on(void **state)
{
    (void)state;
    char text[1024], model[256];
    snprintf(model, sizeof model, tetrahedron, 1.0);
    put_text("a.off", model);
    snprintf(text, sizeof text, cube, "a.off"); /* beside the scene */
    const uint64_t key = key_of(put_text("a.json", text), 0, NULL);
    assert_true(key_of(put_text("b.json", text), 0, NULL) == key);
    assert_true(key_of(in_folder("a.json"), 32, NULL) != key);
    snprintf(text, sizeof text, cube, "builtin:cube");
    assert_true(key_of(put_text("b.json", text), 0, NULL) != key);
    snprintf(model, sizeof model, tetrahedron, 1.5);
    put_text("a.off", model);
    assert_true(key_of(in_folder("a.json"), 0, NULL) != key);
}

static void settings_aside_are_in_the_key_and_pictures_of_volumes_are_not(void **state)
{
    (void)state;
    static const struct {
        const char *name, *value;
        bool counts;
    } cases[] = { { "xform", "2 1 1 1", true },
                  { "with", "builtin:cube", true },
                  { "twist", "30", true },
                  { "zoom", "2", false },
                  { "size", "64", false } };
    const Technique *technique = technique_find(technique_registry, "voxelize");
    void *setting = gp_alloc(1, technique->setting_bytes);
    const TechniqueInput usual = { .path = "builtin:knot", .setting = technique->defaults },
                         own = { .path = "builtin:knot", .setting = setting };
    const uint64_t key = measured_key(technique, technique->experiments, &usual);
    assert_true(measured_key(technique, technique->experiments + 1, &usual) != key);
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        memcpy(setting, technique->defaults, technique->setting_bytes);
        assert_int_equal(
            setting_set(technique->settings, setting, cases[i].name, cases[i].value, NULL), GP_OK);
        const bool differs = measured_key(technique, technique->experiments, &own) != key;
        assert_int_equal(differs, cases[i].counts);
    }
    gp_free(setting);
}

static void what_was_measured_is_not_drawn_again(void **state)
{
    (void)state;
    const Technique *technique = technique_find(technique_registry, "shadow");
    char text[1024], path[400];
    snprintf(text, sizeof text, cube, "builtin:cube");
    snprintf(path, sizeof path, "%s", put_text("a.json", text));
    GpDevice *device = new_device();
    Promise first, second;
    for (int run = 0; run < 2; run++) {
        void *scene;
        Measured measured;
        assert_int_equal(technique_open(technique, path, 0, 0, &scene, NULL), GP_OK);
        const PromiseJob job = { .technique = technique,
                                 .experiment = technique->experiments,
                                 .scene = scene,
                                 .setting = technique->defaults,
                                 .extension = "png",
                                 .device = device,
                                 .most = 2 };
        measured_open(folder, "shadow", 7, &measured);
        assert_int_equal(promise_choose(&job, &measured, run ? &second : &first, NULL), GP_OK);
        assert_int_equal(measured_write(&measured, NULL), GP_OK);
        measured_close(&measured);
        technique->close(scene);
    }
    gp_device_destroy(&device);
    assert_true(first.drawn > 0);
    assert_int_equal(second.drawn, 0);
    assert_int_equal(second.tried, first.tried);
    assert_string_equal(second.chosen.options, first.chosen.options);
    assert_true(second.measured.error == first.measured.error);
    assert_int_equal(folder_count(false), 2);
}

static void a_broken_file_is_measured_again(void **state)
{
    (void)state;
    static const char *const broken[] = { "", "[]", "{\"--map 1\": 3}",
                                          "{\"--map 1\": [\"a\", 2]}" };
    TechniqueError error;
    put_text("light-0000000000000007.json", "{\"--map 1\": [3, \"inf\"]}");
    Measured measured;
    measured_open(folder, "light", 7, &measured);
    assert_true(measured_find(&measured, "--map 1", &error) && error.error == 3);
    assert_true(isinf(error.whole));
    assert_false(measured_find(&measured, "--map 2", &error));
    measured_close(&measured);
    for (size_t i = 0; i < GP_COUNT(broken); i++) {
        put_text("light-0000000000000007.json", broken[i]);
        measured_open(folder, "light", 7, &measured);
        assert_false(measured_find(&measured, "--map 1", &error));
        measured_close(&measured);
    }
}

/* --- what is proposed ------------------------------------------------------------------------- */

static ChartPoint point(const char *options, double low, double ms, double high, double error)
{
    ChartPoint made = { .method = "m",
                        .time = { .ms = ms, .low_ms = low, .high_ms = high },
                        .measured = { .error = error, .whole = 1000 } };
    snprintf(made.options, sizeof made.options, "%s", options);
    return made;
}

/* b is hardly slower than a, and so more exact for nothing; d is beaten by c, whose time it
 * shares. */
static void settings_whose_times_overlap_are_ordered_by_error(void **state)
{
    (void)state;
    ChartPoint points[] = { point("a", 9, 10, 12, 500), point("b", 10.5, 11, 13, 100),
                            point("c", 19, 20, 22, 30), point("d", 18, 19, 20, 90),
                            point("e", 40, 50, 60, 30), point("f", 70, 80, 90, 0) };
    static const struct {
        double most;
        bool per_cent;
        const char *first;
    } cases[] = { { 600, false, "b" }, { 100, false, "b" }, { 99, false, "c" }, { 29, false, "f" },
                  { 5, true, "c" },    { 3, true, "c" },    { 2.9, true, "f" } };
    const Chart chart = { .points = points, .count = GP_COUNT(points) };
    static const TechniqueSweep sweep[] = { { "g", "--g 1|2" },
                                            { "u", "--u 1|2" },
                                            { NULL, NULL } };
    static const char *const usual[] = { "u", NULL };
    const Experiment experiment = { .sweep = sweep, .usual = usual };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        Candidates all;
        assert_int_equal(
            candidates_list(&experiment, &chart, cases[i].most, cases[i].per_cent, &all, NULL),
            GP_OK);
        assert_string_equal(all.list[all.first].options, cases[i].first);
        assert_int_equal(all.count, 10);
        const char *const order[] = { "b", "c", "f", "e", "d", "a", "--u 1", "--u 2" };
        for (size_t k = 0; k < GP_COUNT(order); k++)
            assert_string_equal(all.list[k].options, order[k]);
        gp_free(all.list);
    }
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(shadows_keep_their_error_on_any_scene),
        IN_FOLDER(volumes_keep_their_error_on_any_model),
        IN_FOLDER(what_is_ruled_out_would_not_have_been_chosen),
        IN_FOLDER(the_truth_for_errors_alone_has_the_same_errors),
        IN_FOLDER(the_key_changes_with_all_that_a_measurement_depends_on),
        IN_FOLDER(settings_aside_are_in_the_key_and_pictures_of_volumes_are_not),
        IN_FOLDER(what_was_measured_is_not_drawn_again),
        IN_FOLDER(a_broken_file_is_measured_again),
        IN_FOLDER(settings_whose_times_overlap_are_ordered_by_error),
    };
    return cmocka_run_group_tests_name("promises", tests, NULL, NULL);
}
