/* Volumes of scenes: in their place, cut by what is in them, and refused with a reason. */
#include "tests/support/devices.h"
#include "tests/support/scene_text.h"

#include <math.h>
#include <stdio.h>

enum { SIDE = 64 };

#define BALL "\"volume\": \"builtin:ball:24\", \"transfer\": \"bonsai\""

static void draw(const char *text, float rgba[SIDE * SIDE][4])
{
    Scene scene = load_scene(text);
    run_list(&scene.list);
    assert_int_equal(gp_surface_read_floats(scene.picture, 0, NULL, &rgba[0][0], NULL), GP_OK);
    scene_free(&scene);
}

/* The largest difference of two pictures, and the sum of the first. */
static double difference(const char *one, const char *other, double *sum)
{
    static float a[SIDE * SIDE][4], b[SIDE * SIDE][4];
    double most = 0;
    draw(one, a);
    draw(other, b);
    *sum = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int c = 0; c < 3; c++) {
            most = fmax(most, fabs((double)a[i][c] - (double)b[i][c]));
            *sum += (double)a[i][c];
        }
    return most;
}

#define SCENE(camera, objects)                                                                     \
    "{ \"size\": [64, 64], \"background\": [0, 0, 0, 1], \"lights\": [ { \"direction\": [0, 0, "   \
    "1] } ],\n  \"camera\": { " camera " },\n  \"objects\": [ " objects " ] }"
#define NEAR_EYE                                                                                   \
    "\"eye\": [30, 18, 50], \"at\": [11.5, 11.5, 11.5], \"fovy\": 40, \"near\": 1, \"far\": 200"

/* The world turned about y by a quarter, half as large, and moved: (x, y, z) is at
 * (z / 2 + 7, y / 2 - 3, 2 - x / 2). */
static void a_volume_and_its_camera_move_together(void **state)
{
    (void)state;
    double sum;
    const double off = difference(
        SCENE(NEAR_EYE, "{ " BALL ", \"lit\": true }"),
        SCENE("\"eye\": [32, 6, -13], \"at\": [12.75, 2.75, -3.75], \"fovy\": 40, \"near\": 0.5, "
              "\"far\": 100",
              "{ " BALL ", \"lit\": true, \"transform\": { \"scale\": 0.5, \"rotate\": [0, 1, 0, "
              "90], \"translate\": [7, -3, 2] } }"),
        &sum);
    assert_true(sum > 100);
    assert_true(off <= 1.5 / 255);
}

static void fit_is_a_transform(void **state)
{
    (void)state;
    double sum;
    const double off = difference(
        SCENE(NEAR_EYE, "{ " BALL ", \"fit\": [11.5, 6, 11.5, 11.5] }"),
        SCENE(NEAR_EYE, "{ " BALL ", \"transform\": { \"scale\": 0.5, \"translate\": [5.75, 6, "
                        "5.75] } }"),
        &sum);
    assert_true(sum > 50);
    assert_true(off <= 1.5 / 255);
}

/* Rays along z, on a wall that they meet at z = 11.5, in the middle; and one before all. */
static void walls_hide_what_is_behind_them(void **state)
{
    (void)state;
#define ALONG                                                                                      \
    "\"eye\": [11.5, 11.5, 60], \"at\": [11.5, 11.5, 0], \"height\": 30, \"near\": 1, \"far\": "   \
    "100"
#define WALL(z)                                                                                    \
    "{ \"mesh\": \"builtin:cube\", \"transform\": { \"scale\": [20, 20, 0.5], \"translate\": "     \
    "[11.5, 11.5, " #z "] } }"
    double sum, half, whole;
    assert_true(difference(SCENE(ALONG, WALL(40)), SCENE(ALONG, WALL(40) ", { " BALL " }"), &sum) ==
                0);
    half = difference(SCENE(ALONG, WALL(11)), SCENE(ALONG, WALL(11) ", { " BALL " }"), &sum);
    whole = difference(SCENE(ALONG, WALL(-10)), SCENE(ALONG, WALL(-10) ", { " BALL " }"), &sum);
    assert_true(half > 0.05 && whole > half + 0.01);
}

/* Of two, the nearer lies over the farther, whichever is first in the file. */
static void the_farthest_is_drawn_first(void **state)
{
    (void)state;
#define NEARER  "{ " BALL ", \"transform\": { \"translate\": [6, 4, 30] } }"
#define FARTHER "{ " BALL ", \"lit\": true }"
    double sum;
    assert_true(difference(SCENE("\"eye\": [30, 18, 90], \"at\": [11.5, 11.5, 11.5], \"fovy\": 40, "
                                 "\"near\": 1, \"far\": 200",
                                 NEARER ", " FARTHER),
                           SCENE("\"eye\": [30, 18, 90], \"at\": [11.5, 11.5, 11.5], \"fovy\": 40, "
                                 "\"near\": 1, \"far\": 200",
                                 FARTHER ", " NEARER),
                           &sum) == 0);
    assert_true(sum > 100);
}

static void what_is_wrong_is_refused_with_its_place(void **state)
{
    (void)state;
    static const RefusedObject rows[] = {
        { "\"volume\": \"builtin:cat\"", ": objects[0].volume: " },
        { "\"volume\": \"nowhere.nrrd\"", ": objects[0].volume: " },
        { "\"volume\": 3", ": objects[0].volume: expected a string" },
        { BALL ", \"mesh\": \"builtin:cube\"",
          ": objects[0]: expected a mesh, points, a volume or a depth image" },
        { "\"volume\": \"builtin:ball:8\", \"transfer\": \"none.txt\"", ": objects[0].transfer: " },
        { BALL ", \"step\": 0", ": objects[0].step: expected a number in [0.05, 16]" },
        { BALL ", \"material\": { \"program\": \"phong\" }",
          ": objects[0].material: volumes have none of their own" },
        { BALL ", \"transform\": { \"scale\": [1, 2, 1] }",
          ": objects[0].transform: volumes keep their shape: expected one scale above 0" },
        { BALL ", \"transform\": { \"scale\": [-1, -1, -1] }",
          ": objects[0].transform: volumes keep their shape: expected one scale above 0" },
    };
    check_refused_objects(rows, GP_COUNT(rows));
}

static void memory_that_runs_short_is_said(void **state)
{
    (void)state;
    static const char text[] = SCENE(NEAR_EYE, "{ " BALL " }, { " BALL " }");
    check_short_memory(text, 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_volume_and_its_camera_move_together),
        cmocka_unit_test(fit_is_a_transform),
        cmocka_unit_test(walls_hide_what_is_behind_them),
        cmocka_unit_test(the_farthest_is_drawn_first),
        cmocka_unit_test(what_is_wrong_is_refused_with_its_place),
        cmocka_unit_test(memory_that_runs_short_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
