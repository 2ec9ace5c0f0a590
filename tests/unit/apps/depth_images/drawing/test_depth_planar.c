/* Planar depth images warped as printed: near to the truth from aside, with the view's depth, the
 * same bits on every device; and what the method fails at, each beside its remedy. */
#include "apps/depth_images/drawing/planar.h"
#include "shaders_c/warp/planar.h"
#include "tests/support/depth/formula.h"

#include <string.h>

static const WarpLight light = { .position = { 0.6, 0.8, 0 },
                                 .directional = true,
                                 .color = { 1, 1, 1 },
                                 .ambient = { .2f, .2f, .2f } };

/* A picture of an image as a camera sees it. owns: the caller, frame_free, and planar_close after
 * that */
static Frame draw(const DepthImage *image, const PlanarSetting *setting, const Camera *camera,
                  bool lit, Planar *planar)
{
    const WarpView view = { *camera, FORMULA_SIDE, FORMULA_SIDE, lit ? &light : NULL };
    Frame frame = { .color = NULL };
    const WarpTarget target = formula_target(lit, &frame);
    GpError error = { "" };
    if (planar_open(image, planar, &error) ||
        planar_add(planar, setting, &view, &target, &frame, &error))
        fail_msg("%s", error.text);
    return frame;
}

static FormulaOff off_of(const DepthImage *image, Formula formula, const PlanarSetting *setting,
                         const Camera *camera)
{
    Planar planar;
    Frame frame = draw(image, setting, camera, false, &planar);
    run_list(&frame.list);
    const FormulaOff off = formula_compare(formula, camera, &frame);
    frame_free(&frame);
    planar_close(&planar);
    return off;
}

static const PlanarSetting usual = { .step = 0 };

/* Images and views of both kinds. Depth is that of the nearest texel of the plane's picture. */
static void planes_are_exact_from_aside(void **state)
{
    (void)state;
    for (int way = 0; way < 4; way++) {
        const Camera camera = formula_camera(2, 1, 3.5, way & 1);
        for (int formula = FORMULA_FLAT; formula <= FORMULA_PLANE; formula++) {
            DepthImage image = formula_image((Formula)formula, way >> 1);
            const FormulaOff off = off_of(&image, (Formula)formula, &usual, &camera);
            print_message("# %u of %u missing, %u too much; colour %.4f, depth %.2g off\n",
                          off.missing, off.covered, off.extra, off.color, off.depth);
            assert_true(off.covered > 500 && off.missing < 5 && off.extra == 0);
            assert_true(off.color < 0.02 && off.depth < 4e-3);
            formula_free(&image);
        }
    }
}

static void a_ball_hides_its_own_back(void **state)
{
    (void)state;
    static const double eyes[][3] = {
        { 2, 1, 4 }, { -2.5, 0, 3.5 }, { 0, -2, 4 }, { 0.1, 0.2, 7 }, { 0, 0.1, 2.5 }
    };
    for (int way = 0; way < 4; way++)
        for (size_t i = 0; i < GP_COUNT(eyes); i++) {
            const Camera camera = formula_camera(eyes[i][0], eyes[i][1], eyes[i][2], way & 1);
            DepthImage image = formula_image(FORMULA_BALL, way >> 1);
            const FormulaOff off = off_of(&image, FORMULA_BALL, &usual, &camera);
            print_message(
                "# %u of %u missing, %u too much; colour %.4f, depth %.2g off on average\n",
                off.missing, off.covered, off.extra, off.mean_color, off.mean_depth);
            assert_true(off.missing < off.covered / 3 && off.extra < off.covered / 50);
            assert_true(off.mean_color < 0.02 && off.mean_depth < 4e-3);
            formula_free(&image);
        }
}

static void rubber_sheets_are_cut(void **state)
{
    (void)state;
    const Camera camera = formula_camera(3, 0, 4, false);
    for (int way = 0; way < 2; way++) {
        DepthImage image = formula_image(FORMULA_STEP, way);
        const FormulaOff printed = off_of(&image, FORMULA_STEP, &usual, &camera),
                         cut = off_of(&image, FORMULA_STEP, &(PlanarSetting){ .is_cut = true },
                                      &camera);
        print_message("# too much: %u as printed, %u cut\n", printed.extra, cut.extra);
        assert_true(printed.extra > 500 && cut.extra < 10);
        formula_free(&image);
    }
}

/* The plane stands where the step is high, z = 0.5: an eye on it sees nothing of it as printed,
 * since all is warped to the eye's foot. */
static void an_eye_on_the_plane_moves_it(void **state)
{
    (void)state;
    static const double heights[] = { 1e-3, 0, -0.05 };
    DepthImage image = formula_image(FORMULA_STEP, true);
    for (size_t i = 0; i < GP_COUNT(heights); i++) {
        const Camera camera = { .eye = { 0, 0, 0.5 + heights[i] },
                                .at = { 1, 0, -0.5 },
                                .up = { 0, 1, 0 },
                                .fovy = 40,
                                .near = 0.01,
                                .far = 20 };
        const WarpView view = { camera, FORMULA_SIDE, FORMULA_SIDE, NULL };
        const FormulaOff stays = off_of(&image, FORMULA_STEP, &(PlanarSetting){ .stays = true },
                                        &camera),
                         moves = off_of(&image, FORMULA_STEP, &usual, &camera);
        print_message("# %g before the plane, missing of %u: %u, where it moves %u\n", heights[i],
                      moves.covered, stays.missing, moves.missing);
        assert_true(moves.covered > 1000 && moves.missing < moves.covered / 20);
        assert_true(stays.missing > moves.covered / 2 || heights[i] > 0);
        assert_true(planar_warning(&image, &view) || heights[i] > 0);
    }
    formula_free(&image);
}

static void warnings_name_what_fails(void **state)
{
    (void)state;
    DepthImage image = formula_image(FORMULA_BALL, false);
    const struct {
        Camera camera;
        const char *says;
    } rows[] = { { formula_camera(1, 1, 4, false), NULL },
                 { formula_camera(1, 1, 4, true), NULL },
                 { formula_camera(0, 0.1, 0.5, false), "on the plane" },
                 { formula_camera(0, 0.1, -3, false), "from behind" },
                 { formula_camera(3, 0, 0, true), "along the plane" } };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const WarpView view = { rows[i].camera, 8, 8, NULL };
        const char *warning = planar_warning(&image, &view);
        assert_true(rows[i].says ? warning && strstr(warning, rows[i].says) : !warning);
    }
    formula_free(&image);
}

static void few_entries_of_the_table_are_steps(void **state)
{
    (void)state;
    const Camera camera = formula_camera(2, 1, 3.5, false);
    DepthImage image = formula_image(FORMULA_PLANE, true);
    double color[2];
    for (int i = 0; i < 2; i++)
        color[i] = off_of(&image, FORMULA_PLANE, &(PlanarSetting){ .entries = i ? 8 : 0 }, &camera)
                       .mean_color;
    print_message("# colour off: %.4f, in 8 steps %.4f\n", color[0], color[1]);
    assert_true(color[1] > 3 * color[0]);
    formula_free(&image);
}

/* From all sides, on the plane, among what is shown, along the plane. */
static void every_eye_gives_numbers(void **state)
{
    (void)state;
    for (int way = 0; way < 4; way++) {
        DepthImage image = formula_image(way & 2 ? FORMULA_BALL : FORMULA_STEP, way & 1);
        uint32_t covered = 0;
        for (int i = 0; i < 54; i++) {
            static const double away[] = { 3, 1e-3, 5, 300 };
            const double s = away[i % 4];
            const Camera camera = formula_camera(s * (i % 3 - 1), s * (i / 3 % 3 - 1),
                                                 s * (i / 9 % 3 - 1) + (i & 1 ? 1e-4 : 0.5), i & 2);
            Planar planar;
            Frame frame = draw(&image, &(PlanarSetting){ .is_cut = i & 1, .stays = i >= 27 },
                               &camera, true, &planar);
            run_list(&frame.list);
            covered += formula_check_numbers(&frame);
            frame_free(&frame);
            planar_close(&planar);
        }
        assert_true(covered > 1000);
        formula_free(&image);
    }
}

/* Depth 0 is divided by nothing. One pixel is no cell. */
static void small_images_are_drawn(void **state)
{
    (void)state;
    for (uint32_t side = 1; side <= 2; side++)
        for (uint32_t there = 0; there <= side * side; there++) {
            DepthImage image = formula_image(FORMULA_FLAT, true);
            depth_pixels_free(&image.front);
            assert_int_equal(depth_pixels_make(side, side, false, &image.front), GP_OK);
            for (uint32_t i = 0; i < there; i++)
                image.front.depth[i] = 0;
            const Camera camera = {
                .eye = { 0, 0, 9 }, .up = { 0, 1, 0 }, .fovy = 40, .near = 1, .far = 20
            };
            Planar planar;
            Frame frame = draw(&image, &usual, &camera, true, &planar);
            run_list(&frame.list);
            const uint32_t covered = formula_check_numbers(&frame);
            assert_true(there == 4 ? covered > 100 : covered == 0);
            frame_free(&frame);
            planar_close(&planar);
            formula_free(&image);
        }
}

static void cylinders_are_refused(void **state)
{
    (void)state;
    Planar planar;
    GpError error;
    assert_int_equal(planar_open(&(DepthImage){ .is_cylinder = true }, &planar, &error),
                     GP_ERROR_INVALID);
    assert_string_equal(error.text, "a cylinder is no planar depth image");
}

static void frames_have_the_same_bits_everywhere(void **state)
{
    (void)state;
    static uint8_t texels[4] = { 0, 90, 200, 30 };
    GpSurface *heights;
    const GpSurfaceDesc desc = { .format = GP_R8, .width = 2, .height = 2, .memory = texels };
    assert_int_equal(gp_surface_create(&desc, &heights, NULL), GP_OK);
    const PlanarSetting settings[] = { usual,
                                       { .step = 3, .is_cut = true },
                                       { .detail = { heights, 0.1, { 5, 3 }, true } } };
    for (int way = 0; way < 2; way++)
        for (size_t i = 0; i < GP_COUNT(settings); i++) {
            DepthImage image = formula_image(i & 1 ? FORMULA_BALL : FORMULA_STEP, way);
            const Camera camera = formula_camera(2, 1, 3, way);
            Planar planar;
            Frame frame = draw(&image, &settings[i], &camera, i == 2, &planar);
            run_everywhere(&frame);
            frame_free(&frame);
            planar_close(&planar);
            formula_free(&image);
        }
    gp_surface_destroy(&heights);
}

static void programs_are_within_shader_model_3(void **state)
{
    (void)state;
    const GpProgram *programs[] = { &planar_program, &planar_lit_program, &planar_detail_program,
                                    &planar_detail_lit_program };
    for (size_t i = 0; i < GP_COUNT(programs); i++) {
        GpError error = { "" };
        if (gp_program_check(programs[i], &error))
            fail_msg("%s", error.text);
        assert_int_equal(programs[i]->vertex_profile, GP_VS_3_0);
        assert_int_equal(programs[i]->pixel_profile, GP_PS_3_0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes_are_exact_from_aside),
        cmocka_unit_test(a_ball_hides_its_own_back),
        cmocka_unit_test(rubber_sheets_are_cut),
        cmocka_unit_test(an_eye_on_the_plane_moves_it),
        cmocka_unit_test(warnings_name_what_fails),
        cmocka_unit_test(few_entries_of_the_table_are_steps),
        cmocka_unit_test(every_eye_gives_numbers),
        cmocka_unit_test(small_images_are_drawn),
        cmocka_unit_test(cylinders_are_refused),
        cmocka_unit_test(frames_have_the_same_bits_everywhere),
        cmocka_unit_test(programs_are_within_shader_model_3),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
