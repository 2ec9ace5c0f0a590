/* A technique that is made up: command, help, chart and --error come by themselves. */
#include "apps/commands/chart/chart.h"
#include "apps/commands/options.h"
#include "apps/commands/technique_command.h"
#include "apps/scene/scene.h"
#include "tests/shaders/blur.h"
#include "tests/support/program.h"

#include <math.h>

/* --- the technique: a scene, blurred along its rows by steps, of which MOST are the truth ---- */

enum { MOST = 6 };

typedef enum BlurBetween { BLUR_BYTES, BLUR_FLOATS } BlurBetween;

typedef struct BlurSetting {
    uint32_t steps;
    BlurBetween between;
} BlurSetting;

typedef struct Blurred {
    Scene scene;
    double *truth; /* [height][width], of blue */
} Blurred;

static const char *const betweens[] = { "bytes", "floats", NULL };

static const SettingField blur_settings[] = {
    { "steps", "N", "How often, 1 to 6 (default: 6)", SETTING_INTEGER, offsetof(BlurSetting, steps),
      .low = 1, .high = MOST },
    { "between", NULL, "What steps are kept in", SETTING_NAME, offsetof(BlurSetting, between),
      .names = betweens },
    { .name = NULL },
};

static const BlurSetting blur_defaults = { .steps = MOST };

static GpResult blur_open(const TechniqueInput *input, void **opened, GpError *error)
{
    Blurred *blurred = gp_alloc(1, sizeof *blurred);
    const SceneOptions options = { .width = input->width, .height = input->height };
    GpResult result = scene_load(input->path, &options, &blurred->scene, error);
    if (result)
        gp_free(blurred);
    else
        *opened = blurred;
    return result;
}

static void blur_close(void *opened)
{
    Blurred *blurred = opened;
    scene_free(&blurred->scene);
    gp_free(blurred->truth);
    gp_free(blurred);
}

static GpResult blur_build(void *opened, const void *setting, GpDevice *device, Frame *frame,
                           GpError *error)
{
    static const float corners[] = { -1, -1, 0, -1, 3, 0, 3, -1, 0 }, black[4] = { 0 };
    static const GpGeometry cover = {
        .vertex_count = 3, .streams = { [GP_POSITION] = { .data = corners, .components = 3 } }
    };
    const Blurred *blurred = opened;
    const BlurSetting *blur = setting;
    const GpSurface *from = blurred->scene.picture;
    const BlurUniforms uniforms = { { 1.0f / (float)from->width, 0 } };
    GpResult result = gp_device_run(device, &blurred->scene.list, error);
    for (uint32_t i = 1; i <= blur->steps; i++, from = frame->color) {
        const bool bytes = i == blur->steps || blur->between == BLUR_BYTES;
        frame->color = frame_surface(frame, bytes ? GP_A8R8G8B8 : GP_A32B32G32R32F, from->width,
                                     from->height, 1);
        frame_pass(frame, "blur", frame->color, NULL, black);
        GpDraw *draw =
            frame_draw(frame, &blur_program, frame_copy(frame, &uniforms, sizeof uniforms), &cover);
        draw->textures[0] = (GpTexture){ from, { .address_u = GP_CLAMP, .address_v = GP_CLAMP } };
    }
    result = result ? result : frame_result(frame, error);
    if (result)
        frame_free(frame);
    return result;
}

static GpResult blur_find_truth(void *opened, int threads, GpError *error)
{
    Blurred *blurred = opened;
    const GpSurface *picture = blurred->scene.picture;
    const size_t width = picture->width, count = width * picture->height;
    double *old = gp_alloc(count, sizeof *old), *now = gp_alloc(count, sizeof *now);
    GpDevice *device;
    GpResult result = gp_device_create(&(GpDeviceDesc){ .threads = threads }, &device, error);
    if (!result)
        result = gp_device_run(device, &blurred->scene.list, error);
    gp_device_destroy(&device);
    for (size_t i = 0; i < count; i++)
        now[i] = picture->level[0].texels[4 * i];
    for (int step = 0; step < MOST; step++) {
        memcpy(old, now, count * sizeof *old);
        for (size_t i = 0; i < count; i++)
            now[i] = (old[i - (i % width > 0)] + old[i] + old[i + ((i + 1) % width > 0)]) / 3;
    }
    blurred->truth = now;
    gp_free(old);
    return result;
}

static GpResult blur_measure(void *opened, const Frame *frame, TechniqueError *measured,
                             GpError *error)
{
    const Blurred *blurred = opened;
    const size_t count = (size_t)frame->color->width * frame->color->height;
    (void)error;
    *measured = (TechniqueError){ .error = 0 };
    for (size_t i = 0; i < count; i++) {
        const double off = fabs(frame->color->level[0].texels[4 * i] - blurred->truth[i]);
        measured->error += off / (double)count;
        measured->metrics[0] = fmax(measured->metrics[0], off);
    }
    return GP_OK;
}

static const TechniqueSweep blur_sweep[] = {
    { "bytes", "--steps 1|2|6" },
    { "floats", "--between floats --steps 1|6" },
    { .method = NULL },
};

static const char *const blur_metrics[] = { "worst", NULL };

static const TechniqueWord blur_words[] = {
    { "codes", "How far a pixel's blue is from the truth, of 255, on average." },
    { "worst", "The same of the pixel that is furthest from it." },
    { "bytes", "What lies between two steps is rounded to whole codes." },
    { "floats", "What lies between two steps is kept as it is." },
    { .word = NULL },
};

static GpResult blur_difference(void *opened, const void *setting, GpDevice *device, Frame *frame,
                                float *off, GpError *error)
{
    const Blurred *blurred = opened;
    (void)setting;
    (void)device;
    (void)error;
    for (size_t i = 0; i < (size_t)frame->color->width * frame->color->height; i++)
        off[i] = (float)(frame->color->level[0].texels[4 * i] - blurred->truth[i]);
    return GP_OK;
}

static const Experiment blur_experiments[] = {
    { .name = "blur",
      .title = "Blur: time against codes",
      .scene = "scene.json",
      .sweep = blur_sweep,
      .error_name = "codes",
      .metrics = blur_metrics,
      .words = blur_words,
      .truth = "The same steps, in double precision.",
      .difference = blur_difference,
      .over = "bluer than in truth",
      .under = "less blue",
      .find_truth = blur_find_truth,
      .measure = blur_measure },
    { .name = NULL },
};

static const Technique blur = {
    .name = "blur",
    .arguments = "SCENE.json",
    .input = "a scene file",
    .summary = "a scene, blurred",
    .help = "Examples:\n  glasspipe blur scenes/cube.json\n\nBlurs.",
    .settings = blur_settings,
    .defaults = &blur_defaults,
    .setting_bytes = sizeof(BlurSetting),
    .experiments = blur_experiments,
    .open = blur_open,
    .close = blur_close,
    .build = blur_build,
};

static const Technique *const made_up[] = { &blur, NULL };

/* --- what comes by itself --------------------------------------------------------------------- */

/* Runs a line as the program would that has this technique; fills out and err; the exit code. */
static int glasspipe(const char *line)
{
    char words[256], title[32], *argv[32];
    int argc = 0;
    snprintf(words, sizeof words, "%s", line);
    for (char *word = strtok(words, " "); word; word = strtok(NULL, " "))
        argv[argc++] = word;
    argv[argc] = NULL;
    snprintf(title, sizeof title, "glasspipe %s", argv[0]);
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        bool is_chart = strcmp(argv[0], "chart") == 0;
        argv[0] = title;
        assert_true(freopen(".out", "w", stdout) && freopen(".err", "w", stderr));
        exit(is_chart ? chart_command(made_up, argc, argv) : technique_command(&blur, argc, argv));
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    read_file(".out", out, sizeof out);
    read_file(".err", err, sizeof err);
    unlink(".out");
    unlink(".err");
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void the_help_is_made_of_the_settings(void **state)
{
    (void)state;
    static const char *const parts[] = {
        "Usage: glasspipe blur [OPTION...] SCENE.json",
        "--steps=N              How often, 1 to 6 (default: 6)",
        "--between=bytes|floats",
        "--error=E",
        "--output=FILE          Write the picture to FILE",
        "--size=WxH",
        "--threads=N",
    };
    assert_int_equal(glasspipe("blur --help"), EXIT_DONE);
    for (size_t i = 0; i < GP_COUNT(parts); i++)
        expect_contains(out, parts[i]);
}

static void the_command_draws_and_tells(void **state)
{
    (void)state;
    char first[256];
    assert_int_equal(glasspipe("blur scene.json -o a.png"), EXIT_DONE);
    expect_matches(out, "^hash A8R8G8B8 64x48 [0-9a-f]{16}\n$");
    expect_contains(err, "wrote a.png");
    strcpy(first, out);
    assert_int_equal(glasspipe("blur -q scene.json --executor reference"), EXIT_DONE);
    assert_string_equal(out, first);
    assert_int_equal(glasspipe("blur scene.json --json --size 32x32 --steps 2 --between floats"),
                     EXIT_DONE);
    json_t *object = parse_output();
    assert_string_equal(json_string_value(json_object_get(object, "setting")),
                        "--steps 2 --between floats");
    assert_int_equal(json_integer_value(json_object_get(object, "width")), 32);
    assert_int_equal(json_integer_value(json_object_get(object, "passes")), 2);
    json_decref(object);
    expect_files("a.png scene.json scene.png");
}

static void mistakes_are_told(void **state)
{
    (void)state;
    static const struct {
        const char *line;
        int code;
        const char *message;
    } wrong[] = {
        { "blur", EXIT_USAGE, "expected a scene file" },
        { "blur scene.json --steps 7", EXIT_USAGE, "--steps: expected a whole number from 1 to 6" },
        { "blur scene.json --between bits", EXIT_USAGE, "--between: expected bytes or floats" },
        { "blur scene.json -o a.nrrd", EXIT_USAGE, "a.nrrd" },
        { "blur missing.json", EXIT_INPUT, "missing.json" },
        { "blur scene.json --error 1 --trust-chart", EXIT_INPUT,
          "`glasspipe chart blur' makes a chart" },
        { "blur scene.json --error 5%", EXIT_USAGE, "codes are no part of anything" },
        { "chart shadow", EXIT_USAGE, "no technique 'shadow' (there are: blur)" },
        { "chart blur --scaling", EXIT_USAGE, "blur has no table of what grows" },
    };
    for (size_t i = 0; i < GP_COUNT(wrong); i++) {
        assert_int_equal(glasspipe(wrong[i].line), wrong[i].code);
        expect_contains(err, wrong[i].message);
        assert_string_equal(out, "");
    }
    expect_files("scene.json");
}

/* More steps are nearer to the truth, and floats nearer than bytes. */
static void a_chart_is_drawn_and_an_error_chooses_from_it(void **state)
{
    (void)state;
    assert_int_equal(glasspipe("chart blur -t 0 -o . --json"), EXIT_DONE);
    json_t *chart = parse_output(), *points = json_object_get(chart, "points");
    assert_int_equal(json_array_size(points), 5);
    double errors[5];
    for (size_t i = 0; i < GP_COUNT(errors); i++)
        errors[i] = json_number_value(json_object_get(json_array_get(points, i), "error"));
    assert_true(errors[0] > errors[1] && errors[1] > errors[2] && errors[2] > errors[4]);
    assert_true(errors[4] < 0.5 && errors[2] < 1);
    assert_string_equal(json_string_value(json_object_get(chart, "technique")), "blur");
    json_decref(chart);
    assert_int_equal(access("blur.svg", R_OK) | access("blur.csv", R_OK), 0);
    assert_int_equal(access("blur_1.png", R_OK) | access("index.html", R_OK), 0);

    char line[128];
    snprintf(line, sizeof line, "blur scene.json --curve blur.json --error %.17g", errors[4]);
    assert_int_equal(glasspipe(line), EXIT_DONE);
    expect_contains(err, "chose --between floats --steps 6 (floats): error ");
    expect_contains(err, " (measured) codes");
    assert_int_equal(glasspipe("blur scene.json --curve blur.json --error 0"), EXIT_DIFFERS);
    expect_contains(err,
                    "not reached: the most exact of all 5 settings, --between floats --steps 6");
    assert_int_equal(glasspipe("blur scene.json --curve blur.json --error 0 --trust-chart"),
                     EXIT_DIFFERS);
    expect_contains(err, "not reached: the most exact of blur.json, --between floats --steps 6");
    assert_int_equal(glasspipe("blur scene.json --curve blur.json --error 9 --steps 2"),
                     EXIT_USAGE);
}

/* Every head of a table, every method and every option on the page, and what pictures show. */
static void a_page_explains_all_its_words(void **state)
{
    (void)state;
    static char page[1 << 20];
    static const char *const said[] = {
        "<dt>exact result</dt><dd>The same steps, in double precision.</dd>",
        "<dt>worst</dt><dd>The same of the pixel that is furthest from it.</dd>",
        "<dt>bytes</dt>",
        "<dt>floats</dt>",
        "<dt><code>--steps</code></dt><dd>How often, 1 to 6 (default: 6).</dd>",
        "<dt><code>--between</code></dt>",
        "Orange: bluer than in truth; blue: less blue.",
    };
    assert_int_equal(glasspipe("chart blur -t 0 -o ."), EXIT_DONE);
    assert_int_equal(access("blur_1_difference.png", R_OK), 0);
    read_file("index.html", page, sizeof page);
    for (size_t i = 0; i < GP_COUNT(said); i++)
        expect_contains(page, said[i]);
    int heads = 0;
    for (const char *at = page; (at = strstr(at, "<th")); at++) {
        char word[128];
        if (sscanf(at, "<th%*[^>]>%63[^<]<", &word[4]) != 1 &&
            sscanf(at, "<th>%63[^<]<", &word[4]) != 1)
            continue; /* the thead itself */
        memcpy(word, "<dt>", 4);
        strcat(word, "</dt>");
        expect_contains(page, word);
        heads++;
    }
    assert_int_equal(heads, 2 * 5); /* of the best, and of all */
}

/* Nobody told the technique how: it has a truth, and that is enough. */
static void an_error_is_kept_without_any_chart(void **state)
{
    (void)state;
    assert_int_equal(glasspipe("blur scene.json --error 1"), EXIT_DONE);
    expect_matches(err, "chose --steps 2 \\(bytes\\): error 0\\.[0-9]+ \\(measured\\) codes");
    expect_contains(err, "looked at 3 settings, 0 of them remembered");
    assert_int_equal(glasspipe("blur scene.json --error 1 --json"), EXIT_DONE);
    expect_contains(err, "looked at 3 settings, 3 of them remembered");
    json_t *object = parse_output(), *told = json_object_get(object, "error");
    assert_true(json_is_true(json_object_get(told, "measured")));
    assert_true(json_is_true(json_object_get(told, "reached")));
    assert_true(json_number_value(json_object_get(told, "error")) <= 1);
    assert_string_equal(json_string_value(json_object_get(told, "unit")), "codes");
    json_decref(object);
}

int main(void)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, enter, leave)
    const struct CMUnitTest tests[] = {
        TEST(the_help_is_made_of_the_settings),
        TEST(the_command_draws_and_tells),
        TEST(mistakes_are_told),
        TEST(a_chart_is_drawn_and_an_error_chooses_from_it),
        TEST(a_page_explains_all_its_words),
        TEST(an_error_is_kept_without_any_chart),
    };
    return cmocka_run_group_tests_name("a made-up technique", tests, NULL, NULL);
}
