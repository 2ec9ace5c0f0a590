/* All that scenes can hold, in one depth buffer: what is before a thing hides it by its share, and
 * what is behind it changes nothing. */
#include "tests/support/devices.h"
#include "tests/support/scene_text.h"

#include <math.h>
#include <stdio.h>

enum { SIDE = 96 };

typedef float Picture[SIDE * SIDE][4];

/* Seen along -z from 9. */
#define SCENE                                                                                      \
    "{ \"size\": [96, 96], \"background\": [%d, %d, %d, 1], \"order\": \"%s\","                    \
    " \"ambient\": [0.4, 0.4, 0.4], \"lights\": [ { \"direction\": [0.3, 0.5, 1] } ],"             \
    " \"camera\": { \"eye\": [0.4, 0.3, 9], \"at\": [0, 0, 0], \"fovy\": 24, \"near\": 1,"         \
    " \"far\": 20 }, \"objects\": [ %s ] }"

static void draw_scene(const char *objects, const char *order, int grey, Picture rgba)
{
    char text[4000];
    snprintf(text, sizeof text, SCENE, grey, grey, grey, order, objects);
    Scene scene = load_scene(text);
    run_list(&scene.list);
    assert_int_equal(gp_surface_read_floats(scene.picture, 0, NULL, &rgba[0][0], NULL), GP_OK);
    scene_free(&scene);
}

static void draw(const char *objects, int grey, Picture rgba)
{
    draw_scene(objects, "depth", grey, rgba);
}

/* Differences are of bytes: each picture is rounded once for each thing that is blended, and what
 * is foretold from three of them has as much again. */
#define ROUNDED(blends) ((1.0 + 2.0 * (blends)) / 255)

/* --- a board among five things ---------------------------------------------------------------- */

/* One of each kind, the nearest first, overlapping on the picture. */
static const char *const things[] = {
    "{ \"name\": \"glass\", \"mesh\": \"builtin:torus\", \"fit\": [0.2, -0.9, 3.6, 1.3],"
    " \"transform\": { \"rotate\": [1, 0.2, 0, 70] },"
    " \"material\": { \"diffuse\": [0.9, 0.5, 0.2] }, \"state\": { \"depth\": { \"write\": false },"
    " \"blend\": { \"op\": \"add\", \"src\": \"constant\", \"dst\": \"inv-constant\" },"
    " \"blend_constant\": [0.4, 0.4, 0.4, 0.4] } }",
    "{ \"volume\": \"builtin:ball:24\", \"transfer\": \"fog\", \"fit\": [-0.6, -0.8, 1.6, 1.8] }",
    "{ \"mesh\": \"builtin:sphere\", \"method\": \"ewa\", \"color\": [0.2, 0.6, 0.4, 1],"
    " \"fit\": [0.5, -0.8, 0, 1.2] }",
    "{ \"depth_image\": \"builtin:torus\", \"pixels\": [64, 64], \"fit\": [-0.4, -0.2, -1.6, 1.6],"
    " \"material\": { \"diffuse\": [0.3, 0.4, 0.9] } }",
    "{ \"mesh\": \"builtin:cone\", \"fit\": [0.3, -1, -3.4, 1.8] }",
};

enum { THINGS = GP_COUNT(things) };

/* Where it stands: before the first, behind the first, and so on. */
static const double places[THINGS + 1] = { 4.8, 2.8, 0.68, -0.75, -2.45, -4.5 };

static void list_objects(char text[3000], int first, int end, const char *more)
{
    size_t used = (size_t)snprintf(text, 3000, "%s", more);
    for (int i = first; i < end; i++)
        used += (size_t)snprintf(text + used, 3000 - used, "%s%s", used ? ", " : "", things[i]);
}

static void expect_board_at(int place)
{
    static Picture board, whole, without, black, white;
    char text[3000], one[300];
    int covered = 0, differing = 0;
    double most = 0, shown = 0;
    snprintf(one, sizeof one,
             "{ \"name\": \"board\", \"mesh\": \"builtin:cube\", \"transform\": { \"scale\": "
             "[0.8, 0.9, 0.02], \"translate\": [0.1, 0, %g] },"
             " \"material\": { \"diffuse\": [0.7, 0.2, 0.3] } }",
             places[place]);
    draw(one, 0, board);
    list_objects(text, 0, THINGS, one);
    draw(text, 0, whole);
    list_objects(text, 0, THINGS, "");
    draw(text, 0, without);
    list_objects(text, 0, place, "");
    draw(text, 0, black);
    draw(text, 1, white);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const bool is_board = board[i][0] > 0;
        covered += is_board;
        for (int c = 0; c < 3; c++) {
            const double through = (double)white[i][c] - (double)black[i][c];
            const double expected = is_board ? (double)black[i][c] + through * (double)board[i][c]
                                             : (double)without[i][c];
            const double off = fabs((double)whole[i][c] - expected);
            most = fmax(most, off);
            differing += !is_board && off > 0;
            shown += is_board ? through : 0;
        }
    }
    print_message("# board %d: %d pixels, %.2f of it seen, off by %.2f/255\n", place, covered,
                  shown / 3 / covered, most * 255);
    assert_true(covered > 700);
    assert_true(place == 0 ? shown >= 3 * covered - 0.5 : shown < 2.95 * covered);
    assert_int_equal(differing, 0);
    assert_true(most <= ROUNDED(place));
}

static void a_board_hides_what_is_behind_it_and_is_hidden_by_what_is_before(void **state)
{
    (void)state;
    for (int place = 0; place <= THINGS; place++)
        expect_board_at(place);
}

/* --- glass in a volume ------------------------------------------------------------------------ */

#define CLOUD "{ \"volume\": \"builtin:ball:24\", \"transfer\": \"fog\", \"fit\": [0, -1, 0, 2]"
#define SHEET                                                                                      \
    "{ \"name\": \"sheet\", \"mesh\": { \"positions\": [[-1.4, -1, %g], [1.4, -1, %g], [1.4, 1, "  \
    "%g], [-1.4, 1, %g]], \"triangles\": [[0, 1, 2], [0, 2, 3]] },"                                \
    " \"material\": { \"diffuse\": [0.5, 0.3, 0.1] }%s }"
#define BLENDED                                                                                    \
    ", \"state\": { \"depth\": { \"write\": false }, \"blend\": { \"op\": \"add\", \"src\": "      \
    "\"constant\", \"dst\": \"inv-constant\" }, \"blend_constant\": [0.25, 0.25, 0.25, 0.25] }"

/* A sheet that lets through three quarters is a quarter of the picture that it makes where it lets
 * nothing through, and three quarters of the one without it, wherever it stands; colours stay below
 * 1, which opaque ones are cut to before a volume lies over them. in: z at x -1.4, 1.4 */
static void expect_blended(double left, double right, const char *objects)
{
    static Picture none, opaque, glass;
    char text[3000], sheet[600];
    double most = 0, sum = 0;
    draw(objects, 0, none);
    snprintf(sheet, sizeof sheet, SHEET, left, right, right, left, "");
    snprintf(text, sizeof text, "%s, %s", objects, sheet);
    draw(text, 0, opaque);
    snprintf(sheet, sizeof sheet, SHEET, left, right, right, left, BLENDED);
    snprintf(text, sizeof text, "%s, %s", objects, sheet);
    draw(text, 0, glass);
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int c = 0; c < 3; c++) {
            const double expected = 0.75 * (double)none[i][c] + 0.25 * (double)opaque[i][c];
            const bool is_sheet = opaque[i][0] != none[i][0] || opaque[i][2] != none[i][2];
            sum += is_sheet;
            most = fmax(most, is_sheet ? fabs((double)glass[i][c] - expected)
                                       : fabs((double)glass[i][c] - (double)none[i][c]));
        }
    print_message("# sheet at %g, %g: off by %.2f/255\n", left, right, most * 255);
    assert_true(sum > 3000);
    assert_true(most <= ROUNDED(0.25));
}

static void glass_is_seen_through_the_part_of_a_volume_that_is_before_it(void **state)
{
    (void)state;
    expect_blended(1.5, 2, CLOUD " }");
    expect_blended(-0.7, 0.9, CLOUD " }");
    expect_blended(0.9, -0.8, CLOUD ", \"lit\": true, \"step\": 0.5 }");
    expect_blended(-1.2, -2, CLOUD " }");
}

static void glass_lies_over_all_that_is_behind_it(void **state)
{
    (void)state;
    char objects[3000];
    list_objects(objects, 1, THINGS, "");
    expect_blended(2.6, 3, objects);
}

static void glass_in_a_volume_has_the_same_bits_everywhere(void **state)
{
    (void)state;
    char text[4000], objects[3000];
    list_objects(objects, 0, THINGS, "");
    snprintf(text, sizeof text, SCENE, 0, 0, 0, "depth", objects);
    Scene scene = load_scene(text);
    run_everywhere(&scene.frame);
    scene_free(&scene);
}

/* Where nothing comes between, opaque things first and the rest sorted is the same as all
 * sorted. */
static void what_is_blended_is_the_same_in_a_pass_of_its_own(void **state)
{
    (void)state;
    static Picture alone, among;
    char text[3000];
    const char *const glass_and_cone[] = { things[0], things[4] };
    /* splats behind the eye are drawn, and not seen */
    static const char unseen[] = "{ \"points\": \"builtin:sphere\", \"method\": \"ewa\","
                                 " \"fit\": [0, 0, 15, 1] }";
    snprintf(text, sizeof text, "%s, %s", glass_and_cone[0], glass_and_cone[1]);
    draw(text, 0, alone);
    snprintf(text, sizeof text, "%s, %s, %s", unseen, glass_and_cone[0], glass_and_cone[1]);
    draw(text, 0, among);
    assert_memory_equal(alone, among, sizeof alone);
}

static void what_is_wrong_is_refused_with_its_reason(void **state)
{
    (void)state;
#define UNLIT                                                                                      \
    "{ \"name\": \"pane\", \"mesh\": \"builtin:quad\", \"material\": { \"program\": \"unlit\" },"  \
    " \"state\": { \"blend\": { \"op\": \"add\", \"src\": \"one\", \"dst\": \"one\" } } }"
#define PANE                                                                                       \
    "{ \"name\": \"pane\", \"mesh\": \"builtin:quad\", \"state\": { \"blend\": { \"op\": "         \
    "\"add\", \"src\": \"one\", \"dst\": \"one\" } } }"
#define BALL "{ \"volume\": \"builtin:ball:8\", \"fit\": [0, -1, 2, 2] }"
    static const struct {
        const char *objects, *order, *reason;
    } rows[] = {
        { UNLIT ", " BALL, "depth",
          "pane is blended, and a volume is before it: expected program phong, not unlit" },
        { PANE ", " BALL ", " BALL, "depth",
          "pane is blended, and two volumes are before it: expected one" },
        { PANE ", " BALL, "depth-near-first", "order: what is blended over splats" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        char text[2000];
        snprintf(text, sizeof text, SCENE, 0, 0, 0, rows[i].order, rows[i].objects);
        check_refused(text, rows[i].reason);
    }
}

static void memory_that_runs_short_is_said(void **state)
{
    (void)state;
    char text[4000], objects[3000];
    snprintf(objects, sizeof objects, "%s, %s", things[0], things[1]);
    snprintf(text, sizeof text, SCENE, 0, 0, 0, "depth", objects);
    check_short_memory(text, 11);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_board_hides_what_is_behind_it_and_is_hidden_by_what_is_before),
        cmocka_unit_test(glass_is_seen_through_the_part_of_a_volume_that_is_before_it),
        cmocka_unit_test(glass_lies_over_all_that_is_behind_it),
        cmocka_unit_test(glass_in_a_volume_has_the_same_bits_everywhere),
        cmocka_unit_test(what_is_blended_is_the_same_in_a_pass_of_its_own),
        cmocka_unit_test(what_is_wrong_is_refused_with_its_reason),
        cmocka_unit_test(memory_that_runs_short_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
