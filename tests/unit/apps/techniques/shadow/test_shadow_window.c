/* The bias window: from the smallest bias without acne to the largest without leaks. For one map,
 * more bias lights more: acne falls and leaks rise with it, so that each end is found by bisection.
 *
 * $GP_TEST_BUNNY_WINDOW asks for the bunny's table too, which takes its time. */
#include "apps/techniques/shadow/technique.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"

#include <math.h>
#include <stdio.h>

static const char *const methods[] = { "--method plain", "--depth d16 --slope 0",
                                       "--depth d24 --slope 0", "--depth d32f --slope 0" };
static const char *const names[] = { "plain r32f", "d16", "d24", "d32f" };
static const int maps[] = { 512, 1024, 2048 };
enum { R32F, D16, D24, D32F, METHODS, MAPS = 3 };

/* A grid of eight steps an octave. */
enum { STEPS = 8, LOWEST = -26 * STEPS, HIGHEST = 0 };

static double bias_of(int step)
{
    return exp2((double)step / STEPS);
}

/* Steps of the ends; empty where low > high. */
typedef struct Window {
    int low, high;
} Window;

typedef struct Search {
    const TechniqueStage *stage;
    const char *method, *fit;
    int map;
} Search;

/* Whether acne, or leaks, are less than 0.1 % of what is seen. */
static bool is_clean(const Search *search, int step, const char *metric)
{
    char options[SETTING_MAX_TEXT];
    TechniqueError measured;
    GpError error = { "" };
    snprintf(options, sizeof options, "%s --fit %s --map %d --bias %.17g", search->method,
             search->fit, search->map, bias_of(step));
    if (technique_stage_measure(search->stage, options, &measured, &error))
        fail_msg("%s: %s", options, error.text);
    const Technique *technique = search->stage->technique;
    return technique_metric(technique, &measured, metric) <
           0.001 * technique_metric(technique, &measured, "covered");
}

/* The first step from which there is no acne, and the last up to which there are no leaks; one
 * beyond the grid where there is none. */
static Window find_window(const Search *search)
{
    int dirty = LOWEST - 1, clean = HIGHEST + 1;
    while (clean - dirty > 1) {
        int middle = dirty + (clean - dirty) / 2;
        *(is_clean(search, middle, "acne") ? &clean : &dirty) = middle;
    }
    Window window = { .low = clean };
    clean = LOWEST - 1, dirty = HIGHEST + 1;
    while (dirty - clean > 1) {
        int middle = clean + (dirty - clean) / 2;
        *(is_clean(search, middle, "leak") ? &clean : &dirty) = middle;
    }
    window.high = clean;
    return window;
}

static void print_window(const char *method, int map, Window window)
{
    if (window.low > window.high)
        print_message("# %-12s %5d  empty: acne below %.2e, leaks above %.2e\n", method, map,
                      bias_of(window.low), bias_of(window.high));
    else
        print_message("# %-12s %5d  %.2e to %.2e\n", method, map, bias_of(window.low),
                      bias_of(window.high));
}

static void find_table(const char *name, const char *scene, const char *fit, uint32_t side,
                       Window windows[METHODS][MAPS])
{
    TechniqueStage stage;
    GpError error = { "" };
    if (technique_stage_open(&shadow_technique, scene, side, side, &stage, &error))
        fail_msg("%s", error.text);
    print_message("# bias without acne and leaks: %s\n", name);
    for (int i = 0; i < METHODS; i++)
        for (int j = 0; j < MAPS; j++) {
            const Search search = { &stage, methods[i], fit, maps[j] };
            windows[i][j] = find_window(&search);
            print_window(names[i], maps[j], windows[i][j]);
        }
    technique_stage_close(&stage);
}

/* What holds for every scene that a map of 2048 can serve; 16 bits apart, which are few. */
static void check_table(Window windows[METHODS][MAPS])
{
    static const int fine[] = { R32F, D24, D32F };
    for (size_t i = 0; i < GP_COUNT(fine); i++)
        for (int j = 0; j < MAPS; j++) {
            const Window *window = &windows[fine[i]][j], *d24 = &windows[D24][j];
            assert_true(j < 2 || window->low <= window->high);    /* some bias serves */
            assert_true(j == 0 || window->low <= window[-1].low); /* smaller texels need less */
            if (window->low > window->high)
                continue;
            /* more bits than 24 change nothing, wherever they are */
            assert_true(abs(window->low - d24->low) <= 2 && abs(window->high - d24->high) <= 2);
        }
}

#define THINGS(range)                                                                              \
    "{'size': [192, 192], "                                                                        \
    "'camera': {'eye': [2.4, 2.6, 3.4], 'at': [0, 0.35, 0], 'fovy': 36}, "                         \
    "'lights': [{'position': [-2, 3, 1.5], 'at': [0, 0.3, 0], "                                    \
    "            'shadow': {'fovy': 60, " range "}}], "                                            \
    "'objects': [{'mesh': 'builtin:plane', 'transform': {'scale': [2, 1, 2]}}, "                   \
    "{'mesh': 'builtin:torus', 'transform': {'rotate': [1, 0, 0, 90]}, 'fit': [0.6, 0, 0.3, 1]}, " \
    "{'mesh': 'builtin:cube', 'fit': [-0.6, 0, -0.3, 0.7]}]}"

/* Texels are coarser than any format's steps: the window is the map's. */
static void texels_make_the_window(void **state)
{
    (void)state;
    Window windows[METHODS][MAPS];
    find_table("objects on a floor, near 0.5", THINGS("'near': 0.5, 'far': 8"), "light", 0,
               windows);
    check_table(windows);
    for (int j = 0; j < MAPS; j++) {
        assert_true(abs(windows[D16][j].low - windows[D24][j].low) <= 1);
        assert_true(abs(windows[D16][j].high - windows[D24][j].high) <= 1);
    }
}

/* What has the same code is lit: a step of the format is a bias of its own. Where depth begins just
 * before the light, that is more than the texels need, and less is left to add. */
static void a_step_of_16_bits_is_a_bias(void **state)
{
    (void)state;
    Window windows[METHODS][MAPS];
    find_table("objects on a floor, near 0.001", THINGS("'near': 0.001, 'far': 8"), "light", 0,
               windows);
    check_table(windows);
    for (int j = 0; j < MAPS; j++) {
        assert_true(windows[D16][j].low <= windows[D16][j].high);
        assert_true(windows[D16][j].low < windows[D24][j].low);
        assert_true(windows[D16][j].high < windows[D24][j].high);
    }
}

/* Still nearer: a step is 0.7 long where things stand, and longer than they are high. */
static void steps_of_16_bits_close_the_window(void **state)
{
    (void)state;
    Window windows[METHODS][MAPS];
    find_table("objects on a floor, near 0.0003", THINGS("'near': 0.0003, 'far': 8"), "light", 0,
               windows);
    check_table(windows);
    for (int j = 0; j < MAPS; j++)
        assert_true(windows[D16][j].low > windows[D16][j].high);
}

static void the_bunny_has_a_window(void **state)
{
    (void)state;
    Window windows[METHODS][MAPS];
    TechniqueStage stage;
    const char *scene = "scenes/shadow_bunny.json";
    if (!getenv("GP_TEST_BUNNY_WINDOW") ||
        technique_stage_open(&shadow_technique, scene, 8, 8, &stage, NULL))
        skip(); /* not asked for, or no data */
    technique_stage_close(&stage);
    find_table("the bunny, fit light", scene, "light", 512, windows);
    find_table("the bunny, fit casters", scene, "casters", 512, windows);
    check_table(windows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texels_make_the_window),
        cmocka_unit_test(a_step_of_16_bits_is_a_bias),
        cmocka_unit_test(steps_of_16_bits_close_the_window),
        cmocka_unit_test(the_bunny_has_a_window),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
