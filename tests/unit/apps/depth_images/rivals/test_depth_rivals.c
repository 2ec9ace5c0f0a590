/* What is drawn instead of warping, held to the same facts: planes come out exactly, a step and a
 * ball as near as each method can; nothing breaks from any eye; and every device draws the same
 * bits. */
#include "apps/depth_images/rivals/displacement.h"
#include "apps/depth_images/rivals/dmesh.h"
#include "apps/depth_images/rivals/parallax.h"
#include "apps/depth_images/rivals/relief.h"
#include "apps/depth_images/rivals/relief_texture.h"
#include "tests/support/depth/formula.h"

/* Draws a picture of an image, then frees what the method kept of it. */
typedef void DrawRival(const DepthImage *image, const WarpView *view, const WarpTarget *target,
                       bool everywhere, Frame *frame);

static void run(bool everywhere, const Frame *frame)
{
    if (everywhere)
        run_everywhere(frame);
    else
        run_list(&frame->list);
}

/* A method's drawing function, by its names. */
#define DRAW_RIVAL(rival, name, Kept, Setting, ...)                                                \
    static void draw_##rival(const DepthImage *image, const WarpView *view,                        \
                             const WarpTarget *target, bool everywhere, Frame *frame)              \
    {                                                                                              \
        Kept kept;                                                                                 \
        GpError error = { "" };                                                                    \
        if (name##_open(image, &kept, &error) ||                                                   \
            name##_add(&kept, &(Setting){ __VA_ARGS__ }, view, target, frame, &error))             \
            fail_msg("%s", error.text);                                                            \
        run(everywhere, frame);                                                                    \
        name##_close(&kept);                                                                       \
    }

DRAW_RIVAL(relief, relief, Relief, ReliefSetting, .steps = 0)
DRAW_RIVAL(dmesh, dmesh, Dmesh, DmeshSetting, .name = NULL)
DRAW_RIVAL(displacement, displacement, Displacement, DisplacementSetting, .steps = 0)
DRAW_RIVAL(relief_texture, relief_texture, ReliefTexture, ReliefTextureSetting, .cut = 0)
DRAW_RIVAL(parallax, parallax, Parallax, ParallaxSetting, .kind = PARALLAX_OFFSET)
DRAW_RIVAL(limited, parallax, Parallax, ParallaxSetting, .kind = PARALLAX_LIMITED)
DRAW_RIVAL(bump, parallax, Parallax, ParallaxSetting, .kind = PARALLAX_BUMP)

/* How far off a method may be: depth as a share of itself, of which the view's buffer has steps of
 * 3e-6; on the mean where surfaces bend. */
static const struct {
    const char *name;
    DrawRival *draw;
    bool follows;            /* depth; else a polygon is all that there is */
    double flat, ball_depth; /* from aside; flat: largest on planes */
    double color;            /* largest on planes */
    uint32_t around;         /* pixels of the ball that may be wrong: a crescent of it was hidden */
} rivals[] = {
    { "relief", draw_relief, true, 1e-5, 1e-3, 0.01, 250 },
    { "dmesh", draw_dmesh, true, 2e-5, 1e-3, 0.01, 400 },
    { "displacement", draw_displacement, true, 1e-5, 1e-3, 0.01, 250 },
    { "relief texture", draw_relief_texture, true, 1e-4, 3e-3, 0.01, 400 },
    { "parallax", draw_parallax, false, 1e-4, 0.2, 0.01, 1000 },
    { "limited parallax", draw_limited, false, 1e-4, 0.2, 0.01, 1000 },
    { "bump", draw_bump, false, 1e-4, 0.2, 0.01, 1000 },
};

static const WarpLight light = { .position = { 0.6, 0.8, 0 },
                                 .directional = true,
                                 .color = { 1, 1, 1 },
                                 .ambient = { 0.2f, 0.2f, 0.2f } };

static FormulaOff off_of(DrawRival *draw, Formula formula, bool is_parallel, const Camera *camera)
{
    DepthImage image = formula_image(formula, is_parallel);
    const WarpView view = { *camera, FORMULA_SIDE, FORMULA_SIDE, NULL };
    Frame frame = { .color = NULL };
    const WarpTarget target = formula_target(false, &frame);
    draw(&image, &view, &target, false, &frame);
    const FormulaOff off = formula_compare(formula, camera, &frame);
    frame_free(&frame);
    formula_free(&image);
    return off;
}

static void planes_come_out_exactly(void **state)
{
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < GP_COUNT(rivals); i++)
        for (int way = 0; way < 8; way++) {
            const Formula formula = way & 4 ? FORMULA_FLAT : FORMULA_PLANE;
            if (!rivals[i].follows && formula == FORMULA_PLANE)
                continue;
            const Camera camera = formula_camera(1.5, 1, 4.5, way & 2);
            const FormulaOff off = off_of(rivals[i].draw, formula, way & 1, &camera);
            print_message(
                "# %s, %s of a %s source, %s view: %.2g deep, %.3f colour, %u missing of %u\n",
                rivals[i].name, way & 4 ? "flat" : "leaning", way & 1 ? "parallel" : "perspective",
                way & 2 ? "parallel" : "perspective", off.depth, off.color, off.missing,
                off.covered);
            failed += off.depth > rivals[i].flat || off.color > rivals[i].color ||
                      off.missing > 0 || off.covered < 1000;
        }
    assert_int_equal(failed, 0);
}

static void balls_come_out_round(void **state)
{
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < GP_COUNT(rivals); i++)
        for (int way = 0; way < 2; way++) {
            const Camera camera = formula_camera(0.6, 0.3, 4.5, false);
            const FormulaOff off = off_of(rivals[i].draw, FORMULA_BALL, way, &camera);
            print_message("# %s, %s source: %.2g deep, %.3f colour, %u missing, %u more of %u\n",
                          rivals[i].name, way ? "parallel" : "perspective", off.mean_depth,
                          off.mean_color, off.missing, off.extra, off.covered);
            failed += off.mean_depth > rivals[i].ball_depth ||
                      off.missing + off.extra > rivals[i].around || off.covered < 1000;
        }
    assert_int_equal(failed, 0);
}

/* From all round, on the picture's plane, at the source's eye, inside the ball, and far away. */
static void no_eye_breaks_anything(void **state)
{
    (void)state;
    static const double eyes[][3] = {
        { 0, 0, 5 },       { 3, 0, 0 }, { 0, 4, 0 },    { 0, -4, 0 }, { -3, 1, -3 },   { 0, 0, -5 },
        { 0.1, 0.2, 0.3 }, { 0, 0, 1 }, { 0, 0, 1e-3 }, { 2, 0, 5 },  { 0.5, 0, 0.5 }, { 15, 8, 9 }
    };
    for (size_t i = 0; i < GP_COUNT(rivals); i++)
        for (size_t k = 0; k < 4 * GP_COUNT(eyes); k++) {
            const double *eye = eyes[k / 4];
            DepthImage image = formula_image(k & 1 ? FORMULA_BALL : FORMULA_STEP, k & 2);
            const WarpView view = { formula_camera(eye[0], eye[1], eye[2], k % 3 == 0),
                                    FORMULA_SIDE, FORMULA_SIDE, &light };
            Frame frame = { .color = NULL };
            const WarpTarget target = formula_target(true, &frame);
            rivals[i].draw(&image, &view, &target, false, &frame);
            formula_check_numbers(&frame);
            frame_free(&frame);
            formula_free(&image);
        }
}

/* One pixel, four, none that shows anything, no normals, one at the eye. */
static void small_images_are_drawn(void **state)
{
    (void)state;
    const Camera camera = formula_camera(0.5, 0.4, 4.5, false);
    const WarpView view = { camera, FORMULA_SIDE, FORMULA_SIDE, &light };
    for (size_t i = 0; i < GP_COUNT(rivals); i++)
        for (uint32_t way = 0; way < 8; way++) {
            DepthImage image = formula_image(FORMULA_FLAT, way & 1);
            formula_free(&image);
            const uint32_t side = way / 2 == 0 ? 1 : 2;
            assert_int_equal(depth_pixels_make(side, side, false, &image.front), GP_OK);
            for (uint32_t k = 0; k < side * side && way / 2 != 2; k++)
                image.front.depth[k] = k == 3 && way / 2 == 3 ? 0 : 5;
            Frame frame = { .color = NULL };
            const WarpTarget target = formula_target(true, &frame);
            rivals[i].draw(&image, &view, &target, false, &frame);
            const uint32_t covered = formula_check_numbers(&frame);
            assert_true(way / 2 == 2 ? covered == 0 : true);
            frame_free(&frame);
            formula_free(&image);
        }
}

static void every_device_draws_the_same_bits(void **state)
{
    (void)state;
    const Camera camera = formula_camera(1.5, 1, 4, false);
    for (size_t i = 0; i < GP_COUNT(rivals); i++)
        for (int lit = 0; lit < 2; lit++) {
            DepthImage image = formula_image(lit ? FORMULA_BALL : FORMULA_STEP, lit);
            const WarpView view = { camera, FORMULA_SIDE, FORMULA_SIDE, lit ? &light : NULL };
            Frame frame = { .color = NULL };
            const WarpTarget target = formula_target(false, &frame);
            rivals[i].draw(&image, &view, &target, true, &frame);
            assert_true(formula_check_numbers(&frame) > 500);
            frame_free(&frame);
            formula_free(&image);
        }
}

static void cylinders_and_too_large_images_are_refused(void **state)
{
    (void)state;
    const DepthImage cylinder = { .is_cylinder = true };
    const DepthImage large = { .front = { .width = GP_MAX_SIZE, .height = 1 } };
    Relief relief;
    Dmesh dmesh;
    Displacement displacement;
    ReliefTexture relief_texture;
    Parallax parallax;
    GpError error = { "" };
    assert_int_equal(relief_open(&cylinder, &relief, &error), GP_ERROR_UNSUPPORTED);
    assert_string_equal(error.text, "relief mapping of a cylinder: expected a planar depth image");
    assert_int_equal(dmesh_open(&cylinder, &dmesh, &error), GP_ERROR_UNSUPPORTED);
    assert_int_equal(displacement_open(&cylinder, &displacement, &error), GP_ERROR_UNSUPPORTED);
    assert_int_equal(parallax_open(&cylinder, &parallax, &error), GP_ERROR_UNSUPPORTED);
    assert_int_equal(relief_texture_open(&large, &relief_texture, &error), GP_ERROR_UNSUPPORTED);
    assert_string_equal(error.text, "relief texture mapping of a depth image of 8192 x 1: expected "
                                    "at most 8191 pixels a side");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes_come_out_exactly),
        cmocka_unit_test(balls_come_out_round),
        cmocka_unit_test(no_eye_breaks_anything),
        cmocka_unit_test(small_images_are_drawn),
        cmocka_unit_test(every_device_draws_the_same_bits),
        cmocka_unit_test(cylinders_and_too_large_images_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
