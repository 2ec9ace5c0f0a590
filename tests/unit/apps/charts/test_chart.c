/* Charts: the run of a small technique whose errors are known beforehand, which points are on the
 * front, and which is chosen. */
#include "apps/bench/data.h"
#include "apps/charts/chart_file.h"
#include "apps/charts/chart_run.h"
#include "apps/frame/timing.h"
#include "shaders_c/bench/scaled_color.h"
#include "tests/support/folder.h"
#include "tests/support/random.h"

#include <math.h>

/* --- a technique: layers of light, of which white is the truth -------------------------------- */

typedef struct Light {
    int method;
    uint32_t layers;
    double scale;
} Light;

typedef struct Scene {
    uint32_t width, height;
    bool true_known;
} Scene;

static int open_scenes;

static const char *const light_methods[] = { "plain", "half", NULL };

static const SettingField light_settings[] = {
    { "method", NULL, "How", SETTING_NAME, offsetof(Light, method), .names = light_methods },
    { "layers", "N", "How often", SETTING_INTEGER, offsetof(Light, layers), .low = 1, .high = 8 },
    { "scale", "X", "How bright", SETTING_NUMBER, offsetof(Light, scale), .low = 0, .high = 1 },
    { .name = NULL },
};

static const Light light_defaults = { .layers = 1, .scale = 1 };

static GpResult open_light(const TechniqueInput *input, void **scene, GpError *error)
{
    if (strcmp(input->path, "missing.json") == 0)
        return gp_fail(error, GP_ERROR_IO, "%s: is missing", input->path);
    assert_memory_equal(input->setting, &light_defaults, sizeof light_defaults);
    Scene *opened = gp_alloc(1, sizeof *opened);
    *opened = (Scene){ .width = input->width ? input->width : 24,
                       .height = input->height ? input->height : 16 };
    *scene = opened;
    open_scenes++;
    return GP_OK;
}

static void close_light(void *scene)
{
    gp_free(scene);
    open_scenes--;
}

static void corner_white(int quad, int corner, BenchCorner *out)
{
    (void)quad, (void)corner;
    for (int c = 0; c < 4; c++)
        out->value[c] = 1;
}

/* Seven layers do not go with any scene; scenes 1 pixel wide go with no setting. */
static GpResult build_light(void *scene, const void *setting, GpDevice *device, Frame *frame,
                            GpError *error)
{
    assert_non_null(device);
    const Scene *opened = scene;
    const Light *light = setting;
    if (light->layers == 7 || opened->width == 1)
        return gp_fail(error, GP_ERROR_INVALID, "not with %u layers", light->layers);
    ScaledColorUniforms uniforms = { .scale =
                                         (float)(light->scale / (light->method == 1 ? 2 : 1)) };
    frame->color = frame_surface(frame, GP_A8R8G8B8, opened->width, opened->height, 1);
    frame_pass(frame, "light", frame->color, NULL, bench_black);
    GpGeometry quads = bench_quads(frame, (int)light->layers, GP_COLOR, corner_white);
    frame_draw(frame, &scaled_color_program, frame_copy(frame, &uniforms, sizeof uniforms), &quads);
    return GP_OK;
}

static GpResult find_true_light(void *scene, int threads, GpError *error)
{
    Scene *opened = scene;
    assert_int_equal(threads, 2);
    assert_false(opened->true_known);
    opened->true_known = true;
    return opened->height == 1 ? gp_fail(error, GP_ERROR_INVALID, "too flat") : GP_OK;
}

static GpResult measure_light(void *scene, const Frame *frame, TechniqueError *measured,
                              GpError *error)
{
    const Scene *opened = scene;
    assert_true(opened->true_known);
    const uint8_t *texel = frame->color->level[0].texels;
    measured->error = 255 - texel[0];
    measured->metrics[0] = texel[0];
    measured->metrics[1] = opened->width;
    return opened->height == 2 ? gp_fail(error, GP_ERROR_MEMORY, "too dark") : GP_OK;
}

static const TechniqueSweep light_sweep[] = {
    { "plain", "--method plain --layers 1|7|8 --scale 1|0.4" },
    { "half, \"dim\"", "--method half --scale 0.2|1" },
    { NULL, NULL },
};

static const char *const light_metrics[] = { "red", "width", NULL };

static const Experiment light_experiments[] = {
    { .name = "light",
      .title = "Light",
      .scene = "scenes/light.json",
      .sweep = light_sweep,
      .error_name = "darkness, codes",
      .metrics = light_metrics,
      .find_truth = find_true_light,
      .measure = measure_light },
    { .name = NULL },
};

static const Technique light = {
    .name = "light",
    .settings = light_settings,
    .defaults = &light_defaults,
    .setting_bytes = sizeof(Light),
    .experiments = light_experiments,
    .open = open_light,
    .close = close_light,
    .build = build_light,
};

/* --- running ---------------------------------------------------------------------------------- */

static GpDevice *two_threads(void)
{
    GpDevice *device;
    GpError error = { "" };
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &device, &error), GP_OK);
    return device;
}

static GpResult run(const char *scene, uint32_t width, uint32_t height, const char *pictures,
                    Chart *chart, GpError *error)
{
    GpDevice *device = two_threads();
    const ChartJob job = { .technique = &light,
                           .experiment = light_experiments,
                           .scene = scene,
                           .width = width,
                           .height = height,
                           .folder = pictures,
                           .device = device };
    GpResult result = chart_run(&job, chart, error);
    gp_device_destroy(&device);
    assert_int_equal(open_scenes, 0);
    return result;
}

static void a_sweep_that_is_no_setting_fails_and_is_not_left_out(void **state)
{
    (void)state;
    static const TechniqueSweep sweep[] = { { "plain", "--method plain" },
                                            { "wrong", "--colour 1" },
                                            { .method = NULL } };
    Experiment experiment = light_experiments[0];
    experiment.sweep = sweep;
    GpDevice *device = two_threads();
    const ChartJob job = { .technique = &light,
                           .experiment = &experiment,
                           .scene = "scenes/light.json",
                           .device = device };
    Chart chart = { .points = NULL };
    GpError error = { "" };
    assert_int_equal(chart_run(&job, &chart, &error), GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "--colour"));
    gp_device_destroy(&device);
}

static void a_run_measures_all_settings_that_go_with_the_scene_in_order(void **state)
{
    (void)state;
    static const struct {
        const char *method, *options;
        double error;
    } expected[] = {
        { "plain", "--method plain --layers 1 --scale 1", 0 },
        { "plain", "--method plain --layers 1 --scale 0.4", 153 },
        { "plain", "--method plain --layers 8 --scale 1", 0 },
        { "plain", "--method plain --layers 8 --scale 0.4", 153 },
        { "half, \"dim\"", "--method half --scale 0.2", 229 },
        { "half, \"dim\"", "--method half --scale 1", 127 },
    };
    Chart chart = { .points = NULL };
    GpError error = { "" };
    assert_int_equal(run("scenes/light.json", 0, 0, NULL, &chart, &error), GP_OK);
    assert_string_equal(error.text, "");
    assert_string_equal(chart.technique, "light");
    assert_string_equal(chart.title, "Light");
    assert_string_equal(chart.scene, "scenes/light.json");
    assert_string_equal(chart.error_name, "darkness, codes");
    assert_int_equal(chart.metric_count, 2);
    assert_string_equal(chart.metrics[1], "width");
    assert_true(chart.machine[0] && chart.isa[0]);
    assert_int_equal(chart.threads, 2);
    assert_int_equal(chart.width, 24);
    assert_int_equal(chart.height, 16);
    assert_int_equal(chart.count, GP_COUNT(expected));
    for (size_t i = 0; i < GP_COUNT(expected); i++) {
        const ChartPoint *point = &chart.points[i];
        assert_string_equal(point->method, expected[i].method);
        assert_string_equal(point->options, expected[i].options);
        assert_true(point->measured.error == expected[i].error);
        assert_true(point->measured.metrics[0] == 255 - expected[i].error);
        assert_true(point->measured.metrics[1] == 24);
        assert_true(point->time.frames >= 5 && point->time.min_ms > 0 &&
                    point->time.min_ms <= point->time.ms);
        assert_string_equal(point->picture, "");
    }
    assert_true(chart.points[0].best || chart.points[2].best);
    assert_false(chart.points[4].best && chart.points[4].time.ms > chart.points[0].time.ms);
    chart_free(&chart);
}

static void pictures_are_of_the_front_and_older_ones_go(void **state)
{
    (void)state;
    Chart chart = { .points = NULL };
    GpError error = { "" };
    put_text("light_bulb_6.png", "old");
    put_text("light_bulb_99.png", "not ours");
    if (run("some/bulb.json", 5, 3, folder, &chart, &error))
        fail_msg("%s", error.text);
    assert_int_equal(chart.width, 5);
    int pictures = 0;
    for (uint32_t i = 0; i < chart.count; i++) {
        const ChartPoint *point = &chart.points[i];
        assert_int_equal(point->best, point->picture[0] != '\0');
        if (!point->best)
            continue;
        char magic[5];
        assert_int_equal(get_text(point->picture, magic, sizeof magic), 4);
        assert_memory_equal(magic, "\x89PNG", 4);
        pictures++;
    }
    assert_in_range(pictures, 1, 5); /* darkness has but five values */
    assert_int_equal(folder_count(false), pictures + 1);
    chart_free(&chart);
}

static void a_run_that_cannot_be_leaves_no_chart_and_no_open_scene(void **state)
{
    (void)state;
    static const struct {
        const char *scene;
        uint32_t width, height;
        const char *folder, *message;
        GpResult result;
    } wrong[] = {
        { "missing.json", 0, 0, NULL, "missing.json: is missing", GP_ERROR_IO },
        { "a.json", 3, 1, NULL, "too flat", GP_ERROR_INVALID },
        { "a.json", 1, 3, NULL, "a.json: no setting goes with this scene", GP_ERROR_INVALID },
        { "a.json", 4, 2, NULL, "too dark", GP_ERROR_MEMORY },
        { "a.json", 2, 3, "/no such folder", "/no such folder", GP_ERROR_IO },
    };
    for (size_t i = 0; i < GP_COUNT(wrong); i++) {
        Chart chart = { .count = 77 };
        GpError error = { "" };
        assert_int_equal(
            run(wrong[i].scene, wrong[i].width, wrong[i].height, wrong[i].folder, &chart, &error),
            wrong[i].result);
        assert_non_null(strstr(error.text, wrong[i].message));
        assert_int_equal(chart.count, 77);
        assert_null(chart.points);
    }
}

/* How long a frame takes does not decide in the cases here. */
static void frames_are_as_many_as_the_plan_wants(void **state)
{
    (void)state;
    double *each = gp_alloc(TIMING_MAX_FRAMES, sizeof *each);
    GpDevice *device = two_threads();
    Frame frame = { .color = NULL };
    RunStatistics statistics;
    Timing timing;
    Scene scene = { .width = 2, .height = 2 };
    const TimingPlan seven = { .least_frames = 7, .most_seconds = 1e9 }, none = { 0 };
    assert_int_equal(build_light(&scene, &light_defaults, device, &frame, NULL), GP_OK);
    assert_int_equal(run_first(device, &frame.list, &statistics, NULL), GP_OK);
    assert_int_equal(timing_run(device, &frame.list, &none, each, &statistics, &timing, NULL),
                     GP_OK);
    assert_int_equal(timing.frames, 1);
    assert_true(timing.ms == statistics.first_ms && timing.cpu_ms == statistics.first_cpu_ms);
    assert_int_equal(timing_run(device, &frame.list, &seven, each, &statistics, &timing, NULL),
                     GP_OK);
    assert_int_equal(timing.frames, 7);
    assert_true(timing.min_ms == each[0] && timing.ms == each[3]);
    frame_free(&frame);
    gp_device_destroy(&device);
    gp_free(each);
    assert_true(timing_median((double[]){ 3, 1, 2 }, 3) == 2);
    assert_true(timing_median((double[]){ 4, 1, 9, 2 }, 4) == 3);
}

/* --- the front -------------------------------------------------------------------------------- */

enum { MOST_POINTS = 40 };

/* Points on a coarse grid, so that times and errors are often equal; some are no numbers. */
static Chart random_chart(Random *random)
{
    Chart chart = { .count = (uint32_t)random_int(random, 0, MOST_POINTS) };
    chart.points = gp_alloc(MOST_POINTS, sizeof *chart.points);
    for (uint32_t i = 0; i < chart.count; i++) {
        ChartPoint *point = &chart.points[i];
        point->time.ms = random_int(random, 1, 20);
        point->measured.error = random_int(random, 0, 20);
        if (random_int(random, 0, 15) == 0)
            point->measured.error = (double)NAN;
        if (random_int(random, 0, 15) == 0)
            point->time.ms = (double)NAN;
    }
    return chart;
}

/* Least error that can be had in a time, least time in which an error can be had. */
static double least_error(const Chart *chart, double ms)
{
    double least = HUGE_VAL;
    for (uint32_t i = 0; i < chart->count; i++)
        if (chart->points[i].time.ms <= ms)
            least = fmin(least, chart->points[i].measured.error);
    return least;
}

static double least_time(const Chart *chart, double error)
{
    double least = HUGE_VAL;
    for (uint32_t i = 0; i < chart->count; i++)
        if (chart->points[i].measured.error <= error)
            least = fmin(least, chart->points[i].time.ms);
    return least;
}

static void the_front_has_the_least_error_in_its_time_and_the_least_time_for_its_error(void **state)
{
    (void)state;
    Random random = { 1 };
    for (int round = 0; round < 2000; round++) {
        Chart chart = random_chart(&random);
        const ChartPoint *best[MOST_POINTS];
        chart_mark_best(&chart);
        uint32_t marked = 0;
        for (uint32_t i = 0; i < chart.count; i++) {
            const ChartPoint *point = &chart.points[i];
            bool expected = point->measured.error == least_error(&chart, point->time.ms) &&
                            point->time.ms == least_time(&chart, point->measured.error);
            assert_int_equal(point->best, expected);
            marked += expected;
        }
        assert_int_equal(chart_list_best(&chart, best), marked);
        for (uint32_t i = 0; i < marked; i++)
            assert_true(best[i]->best && (i == 0 || best[i - 1]->time.ms <= best[i]->time.ms));
        chart_free(&chart);
    }
}

static void the_chosen_point_is_the_fastest_that_is_near_enough(void **state)
{
    (void)state;
    Random random = { 2 };
    for (int round = 0; round < 2000; round++) {
        Chart chart = random_chart(&random);
        double error = random_int(&random, -1, 21), ms = least_time(&chart, error);
        const ChartPoint *chosen = chart_choose(&chart, error);
        assert_int_equal(chosen != NULL, isfinite(ms));
        if (chosen)
            assert_true(chosen->time.ms == ms && chosen->measured.error <= error &&
                        chosen->measured.error == least_error(&chart, ms));
        assert_null(chart_choose(&chart, (double)NAN));
        chart_free(&chart);
    }
}

/* --- names ------------------------------------------------------------------------------------ */

static void files_are_called_after_technique_and_scene(void **state)
{
    (void)state;
    static const char *const names[][2] = {
        { "scenes/light.json", "light" },    { "light.json", "light_light" },
        { "a/b.c/bulb.json", "light_bulb" }, { "bulb", "light_bulb" },
        { ".json", "light_.json" },          { "\xff\xc3\xa9.json", "light_???" },
    };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        char name[64];
        chart_name(light_experiments, names[i][0], name, sizeof name);
        assert_string_equal(name, names[i][1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sweep_that_is_no_setting_fails_and_is_not_left_out),
        cmocka_unit_test(a_run_measures_all_settings_that_go_with_the_scene_in_order),
        cmocka_unit_test_setup_teardown(pictures_are_of_the_front_and_older_ones_go, folder_set_up,
                                        folder_tear_down),
        cmocka_unit_test(a_run_that_cannot_be_leaves_no_chart_and_no_open_scene),
        cmocka_unit_test(frames_are_as_many_as_the_plan_wants),
        cmocka_unit_test(
            the_front_has_the_least_error_in_its_time_and_the_least_time_for_its_error),
        cmocka_unit_test(the_chosen_point_is_the_fastest_that_is_near_enough),
        cmocka_unit_test(files_are_called_after_technique_and_scene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
