/* Splats in scenes: they, meshes and one another hide each other pixel by pixel, whatever the
 * order. */
#include "tests/support/devices.h"
#include "tests/support/scene_text.h"

#include <math.h>
#include <stdio.h>

#define CAMERA                                                                                     \
    "\"size\": [128, 128], \"background\": [0, 0, 1, 1], \"ambient\": [1, 1, 1],"                  \
    "\"lights\": [ { \"direction\": [0, 0, 1] } ],"                                                \
    "\"camera\": { \"eye\": [0, 0, 4], \"at\": [0, 0, 0], \"fovy\": 40, \"near\": 2, \"far\": 7 "  \
    "},"
#define BALL "{ \"points\": \"builtin:sphere\", \"method\": \"ewa\", \"color\": [1, 0, 0, 1] }"

/* Oblique, through the ball in front of its middle: z = 0.3 x + 0.6. */
#define SHEET                                                                                      \
    "{ \"mesh\": { \"positions\": [[-1.6, -1.6, 0.12], [1.6, -1.6, 1.08], [1.6, 1.6, 1.08],"       \
    " [-1.6, 1.6, 0.12]], \"triangles\": [[0, 1, 2], [0, 2, 3]] },"                                \
    " \"material\": { \"diffuse\": [0, 1, 0], \"specular\": 0 } }"

static uint64_t draw(const char *text)
{
    Scene scene = load_scene(text);
    run_list(&scene.list);
    const uint64_t hash = hash_targets(&scene.list);
    scene_free(&scene);
    return hash;
}

/* --- depth ------------------------------------------------------------------------------------ */

enum { SIDE = 128 };

#define NONE HUGE_VAL

/* Distance forwards of the ball of radius 1, and of the sheet, at a pixel; how far from the ball's
 * middle its ray passes. */
typedef struct Truth {
    double ball, sheet, aside;
} Truth;

static Truth truth_at(uint32_t i, uint32_t j)
{
    const double half = tan(20 * 3.14159265358979323846 / 180);
    const double x = ((i + 0.5) / SIDE * 2 - 1) * half, y = (1 - (j + 0.5) / SIDE * 2) * half;
    const double a = x * x + y * y + 1, root = 16 - 15 * a;
    Truth truth = { NONE, 3.4 / (1 + 0.3 * x), 4 * sqrt(1 - 1 / a) };
    if (root > 0)
        truth.ball = (4 - sqrt(root)) / a;
    if (fabs(truth.sheet * x) > 1.6 || fabs(truth.sheet * y) > 1.6)
        truth.sheet = NONE;
    return truth;
}

/* A depth buffer's value in 0..1. */
static double depth_at(const GpSurface *depth, uint32_t i, uint32_t j)
{
    const uint8_t *texel =
        gp_surface_texel(depth->level, gp_format_info(depth->format)->bytes, i, j);
    if (depth->format == GP_D32F) {
        float value;
        memcpy(&value, texel, sizeof value);
        return (double)value;
    }
    uint32_t bits = 0;
    memcpy(&bits, texel, depth->format == GP_D16 ? 2 : 4);
    return depth->format == GP_D16 ? bits / 65535.0 : (bits >> 8) / 16777215.0;
}

/* Points are 0.05 apart and their Gaussians 0.03 wide: the mean over them is off by 0.03 along the
 * surface at most, which is so much along the view where that is 45 degrees steep, and twice at 63;
 * but never by all of it, since points lie on all sides. Sums of halves are good to one part in
 * 2048. What is steeper, and pixels that the rim covers in part, which are 0.023 wide, are left
 * out. */
#define SURFACE_ERROR (0.03 + 4.0 / 2048)
#define STEEP         0.89
#define BESIDE        1.035

static double distance_of(double depth)
{
    return 14.0 / (7 - depth * 5); /* near 2, far 7 */
}

/* Of 1/distance: what moving the sheet's corners by a 256th of a pixel does. */
#define SNAPPED (0.3 * 0.023 / 256 / (2.5 * 2.5))

typedef struct Check {
    double ball_error, sheet_error;
    int wrong, mixed, ball, sheet;
} Check;

static Check check_pixels(const Scene *scene)
{
    Check check = { .wrong = 0 };
    for (uint32_t j = 0; j < SIDE; j++)
        for (uint32_t i = 0; i < SIDE; i++) {
            const Truth truth = truth_at(i, j);
            const uint8_t *bgra = scene->picture->level[0].texels + 4 * (size_t)(j * SIDE + i);
            const double distance = distance_of(depth_at(scene->depth, i, j));
            const bool sees_ball = bgra[2] > 127, sees_sheet = bgra[1] > 127 && !sees_ball;
            if ((truth.aside > STEEP && truth.aside < BESIDE) ||
                fmin(truth.ball, truth.sheet) == NONE)
                continue;
            if (fabs(truth.ball - truth.sheet) > SURFACE_ERROR)
                check.wrong += truth.ball < truth.sheet ? !sees_ball : !sees_sheet;
            check.mixed += bgra[2] > 16 && bgra[2] < 239;
            if (sees_ball) {
                check.ball++;
                check.ball_error =
                    fmax(check.ball_error, fabs(distance - fmin(truth.ball, truth.sheet)));
            } else {
                check.sheet++;
                check.sheet_error = fmax(check.sheet_error, fabs(1 / distance - 1 / truth.sheet));
            }
        }
    return check;
}

static void a_mesh_passes_through_a_splatted_ball_pixel_by_pixel(void **state)
{
    (void)state;
    /* a step of depth, in 1/distance, is (1/near - 1/far) of the format's steps */
    static const struct {
        const char *format;
        double step;
    } formats[] = { { "d16", 0x1p-16 }, { "d24s8", 0x1p-22 }, { "d32f", 0x1p-22 } };
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        char text[2000];
        snprintf(text, sizeof text,
                 "{ " CAMERA " \"depth\": { \"format\": \"%s\" }, \"objects\": [ " BALL ", " SHEET
                 " ] }",
                 formats[f].format);
        Scene scene = load_scene(text);
        run_list(&scene.list);
        const Check check = check_pixels(&scene);
        print_message("# %s: %d pixels of the ball within %.4f, %d of the sheet, %d wrong\n",
                      formats[f].format, check.ball, check.ball_error, check.sheet, check.wrong);
        assert_int_equal(check.wrong, 0);
        assert_int_equal(check.mixed, 0); /* the ball is whole where it goes into the sheet */
        assert_true(check.ball > 1000 && check.sheet > 1000);
        assert_true(check.ball_error < SURFACE_ERROR);
        assert_true(check.sheet_error < 2 * formats[f].step + SNAPPED);
        scene_free(&scene);
    }
}

/* --- order ------------------------------------------------------------------------------------ */

static void the_order_of_objects_counts_for_nothing(void **state)
{
    (void)state;
#define BEHIND                                                                                     \
    "{ \"points\": \"builtin:sphere\", \"method\": \"adaptive\", \"transform\": { \"scale\": 0.7," \
    " \"translate\": [0.9, 0.2, 0.6] }, \"color\": [1, 1, 0, 1] }"
    const uint64_t first = draw("{ " CAMERA "\"objects\": [ " BALL ", " SHEET ", " BEHIND " ] }");
    assert_true(draw("{ " CAMERA "\"objects\": [ " SHEET ", " BALL ", " BEHIND " ] }") == first);
    assert_true(draw("{ " CAMERA "\"objects\": [ " BALL ", " BEHIND ", " SHEET " ] }") == first);
    assert_true(draw("{ " CAMERA "\"objects\": [ " BALL ", " SHEET " ] }") != first);
}

static void what_a_mesh_hides_leaves_nothing(void **state)
{
    (void)state;
#define HIDDEN                                                                                     \
    "{ \"points\": \"builtin:sphere\", \"method\": \"ewa\", \"transform\": { \"scale\": 0.3,"      \
    " \"translate\": [0, 0, -1] } }"
    Scene without = load_scene("{ " CAMERA "\"objects\": [ " SHEET " ] }");
    Scene with = load_scene("{ " CAMERA "\"objects\": [ " HIDDEN ", " SHEET " ] }");
    assert_int_equal(with.list.pass_count, 4);
    run_list(&without.list);
    run_list(&with.list);
    const size_t bytes = (size_t)SIDE * SIDE * 4;
    assert_memory_equal(with.picture->level[0].texels, without.picture->level[0].texels, bytes);
    assert_memory_equal(with.depth->level[0].texels, without.depth->level[0].texels, bytes);
    scene_free(&with);
    scene_free(&without);
}

static void every_device_draws_the_same_bits(void **state)
{
    (void)state;
    static const char *const methods[] = { "adaptive", "ewa",  "reconstruction",
                                           "lowpass",  "area", "distance" };
    for (size_t i = 0; i < GP_COUNT(methods); i++) {
        char text[2000];
        snprintf(text, sizeof text,
                 "{ " CAMERA "\"objects\": [ " SHEET
                 ", { \"mesh\": \"builtin:ball\", \"subdivide\": "
                 "1, \"method\": \"%s\" } ] }",
                 methods[i]);
        Scene scene = load_scene(text);
        run_everywhere(&scene.frame);
        scene_free(&scene);
    }
}

/* --- what is said of them --------------------------------------------------------------------- */

static void passes_of_a_scene_have_splats_of_their_own(void **state)
{
    (void)state;
    Scene scene = load_scene(
        "{ \"passes\": [ { \"name\": \"a\", \"objects\": [ " BALL " ] }, { \"name\": \"b\","
        " \"size\": [64, 32], \"objects\": [ " SHEET ", " BALL " ] } ], \"picture\": \"a\" }");
    static const char *const names[] = { "a", "a-visibility", "a-splats", "a-surface",
                                         "b", "b-visibility", "b-splats", "b-surface" };
    assert_int_equal(scene.list.pass_count, GP_COUNT(names));
    for (size_t i = 0; i < GP_COUNT(names); i++)
        assert_string_equal(scene.list.passes[i].name, names[i]);
    assert_ptr_equal(scene.picture, scene.list.passes[3].color[0].surface);
    assert_int_equal(scene.list.passes[7].color[0].surface->width, 64);
    scene_free(&scene);
}

static void what_splats_cannot_have_is_refused(void **state)
{
    (void)state;
#define SPLATS(more)                                                                               \
    "\"objects\": [ { \"points\": \"builtin:grid\", \"method\": \"ewa\"" more " } ] }"
    static const char *const rows[][2] = {
        { "{ \"camera\": { \"height\": 2 }, " SPLATS(""),
          "objects[0]: splats are seen by a persp" },
        { "{ \"depth\": false, " SPLATS(""),
          "objects[0]: splats and other objects hide each other" },
        { "{ \"viewport\": { \"box\": [0, 0, 9, 9] }, " SPLATS(""),
          "splats fill the whole target" },
        { "{ \"targets\": [ {}, {} ], " SPLATS(""), "splats are drawn to one colour target" },
        { "{ " SPLATS(", \"material\": {}"), "objects[0].material: splats have none of their own" },
        { "{ " SPLATS(", \"size\": 1"), "objects[0].size: splats have none of their own" },
        { "{ " SPLATS(", \"subdivide\": 1"), "only a mesh can be subdivided" },
        { "{ " SPLATS(", \"transform\": { \"scale\": [1, 2, 1] }"), "splats stay round" },
        { "{ \"objects\": [ { \"mesh\": \"builtin:cube\", \"sample\": 9 } ] }",
          "objects[0].sample: of splats: expected a method" },
        { "{ \"objects\": [ { \"points\": \"builtin:grid\", \"method\": \"ternary\" } ] }",
          "expected one of adaptive, ewa, reconstruction, lowpass, area, distance" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        check_refused(rows[i][0], rows[i][1]);
}

static void memory_that_runs_short_is_told(void **state)
{
    (void)state;
    static const char text[] = "{ \"size\": [32, 32], \"objects\": [ { \"mesh\": \"builtin:cube\","
                               " \"method\": \"adaptive\" }, { \"mesh\": \"builtin:cube\","
                               " \"sample\": 50, \"method\": \"lowpass\" } ] }";
    check_short_memory(text, 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mesh_passes_through_a_splatted_ball_pixel_by_pixel),
        cmocka_unit_test(the_order_of_objects_counts_for_nothing),
        cmocka_unit_test(what_a_mesh_hides_leaves_nothing),
        cmocka_unit_test(every_device_draws_the_same_bits),
        cmocka_unit_test(passes_of_a_scene_have_splats_of_their_own),
        cmocka_unit_test(what_splats_cannot_have_is_refused),
        cmocka_unit_test(memory_that_runs_short_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
