/* What only receives shadows, in scenes turned every way. */
#include "apps/scene/casters.h"
#include "tests/support/limited.h"
#include "tests/support/random.h"
#include "tests/support/scene_text.h"

#include <math.h>
#include <stdio.h>
#include <sys/resource.h>

/* --- scenes ----------------------------------------------------------------------------------- */

static const double straight[4] = { 0, 1, 0, 0 }; /* no turn */

static void turn_point(const double turn[4], double x, double y, double z, double out[3])
{
    const double point[3] = { x, y, z };
    double m[4][4];
    matrix_rotation(turn, turn[3], m);
    for (int k = 0; k < 3; k++)
        out[k] = vector_dot(m[k], point);
}

static size_t add_object(char *text, size_t used, const char *mesh, const double turn[4],
                         const char *scale, double x, double y, double z)
{
    double at[3];
    turn_point(turn, x, y, z, at);
    return used + (size_t)sprintf(text + used,
                                  ", { \"mesh\": %s, \"transform\": { \"scale\": %s, \"rotate\": "
                                  "[%.17g, %.17g, %.17g, %.17g], \"translate\": [%.17g, %.17g, "
                                  "%.17g] } }",
                                  mesh, scale, turn[0], turn[1], turn[2], turn[3], at[0], at[1],
                                  at[2]);
}

/* A floor, a wall, a cube, a ball and a sheet over the floor, in that order, far from the
 * origin. */
enum { FLOOR, WALL, CUBE, BALL, SHEET };

static const char wall[] =
    "{ \"positions\": [[-4, 0, -5], [4, 0, -5], [4, 3, -5], [-4, 3, -5], [0, 1, -5]], "
    "\"triangles\": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]] }";

/* An open room, of which the floor and two walls hang together, and a box, in one mesh. */
static const char room[] =
    "{ \"positions\": [[-4, 0, -4], [4, 0, -4], [4, 0, 4], [-4, 0, 4], [-4, 5, -4], [4, 5, -4], "
    "[-4, 5, 4], [0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1], [0, 1, 0], [1, 1, 0], [1, 1, 1], "
    "[0, 1, 1]], \"triangles\": [[0, 2, 1], [0, 3, 2], [0, 1, 5], [0, 5, 4], [0, 4, 6], [0, 6, 3], "
    "[7, 8, 9], [7, 9, 10], [11, 13, 12], [11, 14, 13], [7, 11, 12], [7, 12, 8], [8, 12, 13], "
    "[8, 13, 9], [9, 13, 14], [9, 14, 10], [10, 14, 11], [10, 11, 7]] }";

static Scene load(const double turn[4], bool has_room)
{
    char text[8192];
    const size_t begin = (size_t)sprintf(text, "{ \"size\": [8, 8], \"objects\": [ ");
    size_t used = begin;
    if (has_room) {
        used = add_object(text, used, room, turn, "1", 70, 30, -50);
    } else {
        used = add_object(text, used, "\"builtin:plane\"", turn, "[4, 1, 5]", 70, 30, -50);
        used = add_object(text, used, wall, turn, "1", 70, 30, -50);
        used = add_object(text, used, "\"builtin:cube\"", turn, "0.7", 71, 30.7, -49);
        used = add_object(text, used, "\"builtin:ball\"", turn, "0.6", 68, 30.6, -52);
        used = add_object(text, used, "\"builtin:plane\"", turn, "0.5", 69, 31.5, -50);
    }
    text[begin] = ' '; /* the first comma */
    strcpy(text + used, " ] }");
    return load_scene(text);
}

/* Triangles of an object that cast under a light at, or towards, a place of the turned scene. */
static uint32_t count_casting(const Scene *scene, const double turn[4], const double light[4],
                              uint32_t object)
{
    SceneLight source = { .directional = light[3] == 0 };
    Frame frame = { .color = NULL };
    turn_point(turn, light[0], light[1], light[2], source.position);
    const SceneCasters casters = scene_casters(scene, &source, &frame);
    const uint32_t count = casters.objects[object].index_count / 3;
    assert_int_equal(caster_casts(&casters, object), count > 0);
    uint32_t vertices = 0, vertex;
    CasterVertices list = caster_vertices(&casters, object);
    while (caster_next_vertex(&list, &vertex))
        vertices++;
    const GpGeometry *geometry = &scene->list.passes[0].draws[object].geometry;
    assert_int_equal(vertices,
                     count == geometry->index_count / 3 ? geometry->vertex_count : 3 * count);
    frame_free(&frame);
    return count;
}

static const double above[4] = { 75, 40, -40, 1 }, below[4] = { 75, 20, -40, 1 };
static const double behind[4] = { 70, 33, -60, 1 }, sun[4] = { 0.3, 0.5, 0.4, 0 };
static const double low_sun[4] = { 0.3, 0.01, 0.4, 0 }, level_sun[4] = { 0.3, 0, 0.4, 0 };

/* --- facts ------------------------------------------------------------------------------------ */

static void check_pieces(const double turn[4])
{
    Scene scene = load(turn, false);
    const double *const lights[] = { above, sun, low_sun };
    for (size_t i = 0; i < GP_COUNT(lights); i++) {
        assert_int_equal(count_casting(&scene, turn, lights[i], FLOOR), 0);
        assert_int_equal(count_casting(&scene, turn, lights[i], WALL), 0);
        assert_int_equal(count_casting(&scene, turn, lights[i], CUBE), 12);
        assert_int_equal(count_casting(&scene, turn, lights[i], BALL), 224);
        assert_int_equal(count_casting(&scene, turn, lights[i], SHEET), 2); /* things below it */
    }
    assert_int_equal(count_casting(&scene, turn, below, FLOOR), 2);
    assert_int_equal(count_casting(&scene, turn, below, WALL), 0);
    assert_int_equal(count_casting(&scene, turn, behind, WALL), 4);
    assert_int_equal(count_casting(&scene, turn, behind, FLOOR), 0);
    assert_int_equal(count_casting(&scene, turn, level_sun, FLOOR), 2); /* on neither side */
    scene_free(&scene);
}

static void check_room(const double turn[4])
{
    Scene scene = load(turn, true);
    assert_int_equal(count_casting(&scene, turn, above, 0),
                     12); /* the box alone, with its bottom */
    assert_int_equal(count_casting(&scene, turn, below, 0), 18);
    assert_int_equal(count_casting(&scene, turn, behind, 0), 18); /* a wall of the room casts */
    scene_free(&scene);
}

static void pieces_under_everything_only_receive(void **state)
{
    (void)state;
    check_pieces(straight);
    check_room(straight);
}

static void so_they_do_whichever_way_they_lie(void **state)
{
    (void)state;
    Random random = { 11 };
    for (int i = 0; i < 60; i++) {
        double turn[4];
        for (int k = 0; k < 3; k++)
            turn[k] = (double)random_float(&random, -1, 1);
        turn[3] = (double)random_float(&random, -180, 180);
        check_pieces(turn);
        check_room(turn);
    }
}

/* Millionths of the scene's distance are rounding, thousandths are not. */
static void what_reaches_below_a_floor_is_shaded_by_it(void **state)
{
    (void)state;
    static const char *const depths[] = { "29.9", "30.5999", "30.59999" };
    for (size_t i = 0; i < GP_COUNT(depths); i++) {
        char text[1024];
        sprintf(
            text,
            "{ \"size\": [8, 8], \"objects\": [ { \"mesh\": \"builtin:plane\", \"transform\": { "
            "\"scale\": 9, \"translate\": [0, 30, 0] } }, { \"mesh\": \"builtin:cube\", "
            "\"transform\": { \"scale\": 0.6, \"translate\": [0, %s, 0] } } ] }",
            depths[i]);
        Scene scene = load_scene(text);
        assert_int_equal(count_casting(&scene, straight, above, 0), i < 2 ? 2 : 0);
        scene_free(&scene);
    }
}

/* Another picture would be drawn, as if all cast. */
static void memory_that_is_missing_is_told(void **state)
{
    (void)state;
    enum { BALLS = 600 };
    static char text[BALLS * 32 + 64];
    size_t used = (size_t)sprintf(text, "{ \"size\": [8, 8], \"objects\": [ ");
    for (int i = 0; i < BALLS; i++)
        used += (size_t)sprintf(text + used, "%s{ \"mesh\": \"builtin:ball\" }", i ? ", " : "");
    strcpy(text + used, " ] }");
    Scene scene = load_scene(text);
    const SceneLight light = { .position = { 9, 9, 9 } };
    for (int limited = 0; limited <= limits_hold(); limited++) {
        Frame frame = { .color = NULL };
        GpError error;
        struct rlimit before, little;
        assert_non_null(frame_alloc(&frame, 1, 1)); /* and room for what is the frame's */
        assert_int_equal(getrlimit(RLIMIT_AS, &before), 0);
        little = before;
        little.rlim_cur = 1 << 20;
        assert_int_equal(setrlimit(RLIMIT_AS, limited ? &little : &before), 0);
        scene_casters(&scene, &light, &frame);
        assert_int_equal(setrlimit(RLIMIT_AS, &before), 0);
        assert_int_equal(frame_result(&frame, &error), limited ? GP_ERROR_MEMORY : GP_OK);
        frame_free(&frame);
    }
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_under_everything_only_receive),
        cmocka_unit_test(so_they_do_whichever_way_they_lie),
        cmocka_unit_test(what_reaches_below_a_floor_is_shaded_by_it),
        cmocka_unit_test(memory_that_is_missing_is_told),
    };
    return cmocka_run_group_tests_name("casters", tests, NULL, NULL);
}
