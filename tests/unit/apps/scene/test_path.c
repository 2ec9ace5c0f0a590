/* Paths: where things are at a time, between keys that name them and beyond. */
#include "apps/scene/path.h"
#include "tests/support/limited.h"
#include "tests/support/scene_text.h"

#include <math.h>
#include <sys/resource.h>

static ScenePath open_path(const char *text)
{
    char file[TEMPORARY_PATH];
    ScenePath path;
    GpError error = { "" };
    put_temporary(text, strlen(text), file);
    const GpResult result = path_open(file, &path, &error);
    unlink(file);
    if (result)
        fail_msg("%s", error.text);
    return path;
}

/* The camera's fovy at a time. */
static double fovy_at(const ScenePath *path, double time)
{
    json_t *changes = path_at(path, time);
    const double fovy =
        json_number_value(json_object_get(json_object_get(changes, "camera"), "fovy"));
    json_decref(changes);
    return fovy;
}

static void between_keys(void **state)
{
    (void)state;
    ScenePath path = open_path("{ \"interpolation\": \"linear\", \"keys\": ["
                               " { \"time\": 1, \"camera\": { \"fovy\": 10 } },"
                               " { \"time\": 3, \"camera\": { \"fovy\": 20 } },"
                               " { \"time\": 4, \"camera\": { \"fovy\": 40 } } ] }");
    static const double expected[][2] = { { 0, 10 },   { 1, 10 }, { 2, 15 }, { 3, 20 },
                                          { 3.5, 30 }, { 4, 40 }, { 90, 40 } };
    for (size_t i = 0; i < GP_COUNT(expected); i++)
        assert_true(fovy_at(&path, expected[i][0]) == expected[i][1]);
    path_close(&path);
}

/* Through its keys, without a jump or a kink; a straight line stays one. */
static void smooth_curves(void **state)
{
    (void)state;
    ScenePath path = open_path("{ \"keys\": ["
                               " { \"time\": 0, \"camera\": { \"fovy\": 10 } },"
                               " { \"time\": 2, \"camera\": { \"fovy\": 30 } },"
                               " { \"time\": 3, \"camera\": { \"fovy\": 20 } },"
                               " { \"time\": 7, \"camera\": { \"fovy\": 25 } } ] }");
    const double step = 1e-4, at[] = { 0, 2, 3, 7 }, value[] = { 10, 30, 20, 25 };
    for (size_t i = 0; i < GP_COUNT(at); i++)
        assert_true(fovy_at(&path, at[i]) == value[i]);
    for (size_t i = 1; i + 1 < GP_COUNT(at); i++) {
        const double before = (value[i] - fovy_at(&path, at[i] - step)) / step;
        const double after = (fovy_at(&path, at[i] + step) - value[i]) / step;
        const double slope = (value[i + 1] - value[i - 1]) / (at[i + 1] - at[i - 1]);
        assert_true(fabs(before - slope) < 0.01 && fabs(after - slope) < 0.01);
    }
    path_close(&path);
    path = open_path("{ \"keys\": [ { \"time\": 0, \"camera\": { \"fovy\": 10 } },"
                     " { \"time\": 1, \"camera\": { \"fovy\": 12 } },"
                     " { \"time\": 4, \"camera\": { \"fovy\": 18 } } ] }");
    for (double time = 0; time < 4; time += 0.1)
        assert_true(fabs(fovy_at(&path, time) - (10 + 2 * time)) < 1e-12);
    path_close(&path);
}

/* Whose difference, or slope, is beyond all numbers: there is a value all the same. */
static void far_apart(void **state)
{
    (void)state;
    ScenePath path = open_path("{ \"keys\": [ { \"time\": 0, \"camera\": { \"fovy\": 1e308 } },"
                               " { \"time\": 1, \"camera\": { \"fovy\": -1e308 } } ] }");
    assert_true(fovy_at(&path, 0.5) == 1e308);
    assert_true(fovy_at(&path, 1) == -1e308);
    path_close(&path);
}

#define SCENE                                                                                      \
    "{ \"camera\": { \"eye\": [0, 1, 4] }, \"lights\": [ { \"direction\": [0, 1, 0] },"            \
    " { \"direction\": [1, 0, 0] } ], \"objects\": ["                                              \
    " { \"name\": \"a\", \"mesh\": \"builtin:cube\" },"                                            \
    " { \"name\": \"b\", \"mesh\": \"builtin:cube\", \"material\": { \"specular\": 0.5 } } ] }"

static void each_number_has_its_own_keys(void **state)
{
    (void)state;
    ScenePath path = open_path(
        "{ \"interpolation\": \"linear\", \"keys\": ["
        " { \"time\": 0, \"camera\": { \"eye\": [0, 0, 0] }, \"lights\": { \"1\": { \"range\": 2 } "
        "} },"
        " { \"time\": 1, \"objects\": { \"b\": { \"material\": { \"diffuse\": [1, 0, 0] } } } },"
        " { \"time\": 2, \"camera\": { \"eye\": [4, 2, 0] } },"
        " { \"time\": 3, \"objects\": { \"b\": { \"material\": { \"diffuse\": [0, 0, 1],"
        " \"program\": \"toon\" } } } } ] }");
    json_t *scene = json_loads(SCENE, 0, NULL), *changes = path_at(&path, 1.5);
    GpError error = { "" };
    assert_int_equal(path_change(scene, changes, &error), GP_OK);
    json_t *expected = json_loads(
        "{ \"camera\": { \"eye\": [3.0, 1.5, 0.0] }, \"lights\": [ { \"direction\": [0, 1, 0] },"
        " { \"direction\": [1, 0, 0], \"range\": 2.0 } ], \"objects\": ["
        " { \"name\": \"a\", \"mesh\": \"builtin:cube\" },"
        " { \"name\": \"b\", \"mesh\": \"builtin:cube\", \"material\": { \"specular\": 0.5,"
        " \"diffuse\": [0.75, 0.0, 0.25], \"program\": \"toon\" } } ] }",
        0, NULL);
    assert_true(json_equal(scene, expected));
    json_decref(expected);
    json_decref(changes);
    json_decref(scene);
    path_close(&path);
}

static void the_camera_goes_round_what_it_looks_at(void **state)
{
    (void)state;
    Camera camera = { .eye = { 3, 1, 2 }, .at = { 1, 0, 2 }, .up = { 0, 2, 0 } };
    camera_turn(&camera, 90);
    const double expected[] = { 1, 1, 0 };
    for (int i = 0; i < 3; i++)
        assert_true(fabs(camera.eye[i] - expected[i]) < 1e-15);
    camera_turn(&camera, 270);
    assert_true(fabs(camera.eye[0] - 3) < 1e-15 && fabs(camera.eye[2] - 2) < 1e-15);
}

/* Nothing that moves is left where it was. */
static void memory_that_is_missing_is_told(void **state)
{
    (void)state;
    enum { KEYS = 40000 };
    char *text = gp_alloc(KEYS, 64);
    size_t used = (size_t)sprintf(text, "{ \"keys\": [");
    for (int i = 0; i < KEYS; i++)
        used += (size_t)sprintf(text + used, "%s{ \"time\": %d, \"camera\": { \"fovy\": 10 } }",
                                i ? ", " : "", i);
    strcpy(text + used, "] }");
    ScenePath path = open_path(text);
    gp_free(text);
    for (int limited = 0; limited <= limits_hold(); limited++) {
        struct rlimit before, little;
        assert_int_equal(getrlimit(RLIMIT_AS, &before), 0);
        little = before;
        little.rlim_cur = 1 << 20;
        void *held[2000]; /* what is free already */
        int count = 0;
        assert_int_equal(setrlimit(RLIMIT_AS, limited ? &little : &before), 0);
        while (limited && count < 2000 && (held[count] = malloc(100000)))
            count++;
        json_t *changes = path_at(&path, 1.5);
        while (count > 0)
            free(held[--count]);
        assert_int_equal(setrlimit(RLIMIT_AS, &before), 0);
        assert_int_equal(changes == NULL, limited);
        json_decref(changes);
    }
    path_close(&path);
}

static void wrong_paths_are_refused(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "{ }", "keys" },
        { "{ \"keys\": [] }", "at least one" },
        { "{ \"keys\": [ { } ] }", "time" },
        { "{ \"keys\": [ { \"time\": 1 }, { \"time\": 1 } ] }", "after that" },
        { "{ \"keys\": [ { \"time\": 1, \"camera\": 3 } ] }", "an object" },
        { "{ \"keys\": [ { \"time\": 1, \"models\": {} } ] }", "unknown key" },
        { "{ \"rate\": 0, \"keys\": [ { \"time\": 1 } ] }", "rate" },
    };
    for (size_t i = 0; i < GP_COUNT(wrong); i++) {
        char file[TEMPORARY_PATH];
        ScenePath path = { .count = 0 };
        GpError error = { "" };
        put_temporary(wrong[i][0], strlen(wrong[i][0]), file);
        assert_int_equal(path_open(file, &path, &error), GP_ERROR_FORMAT);
        unlink(file);
        if (!strstr(error.text, wrong[i][1]))
            fail_msg("'%s' is not in '%s'", wrong[i][1], error.text);
    }
    static const char *const nothing[] = { "{ \"lights\": { \"2\": {} } }",
                                           "{ \"lights\": { \"x\": {} } }",
                                           "{ \"objects\": { \"c\": {} } }" };
    for (size_t i = 0; i < GP_COUNT(nothing); i++) {
        json_t *scene = json_loads(SCENE, 0, NULL), *changes = json_loads(nothing[i], 0, NULL);
        GpError error = { "" };
        assert_int_equal(path_change(scene, changes, &error), GP_ERROR_FORMAT);
        assert_non_null(strstr(error.text, "the scene has no"));
        json_decref(scene);
        json_decref(changes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(between_keys),
        cmocka_unit_test(smooth_curves),
        cmocka_unit_test(far_apart),
        cmocka_unit_test(each_number_has_its_own_keys),
        cmocka_unit_test(the_camera_goes_round_what_it_looks_at),
        cmocka_unit_test(memory_that_is_missing_is_told),
        cmocka_unit_test(wrong_paths_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
