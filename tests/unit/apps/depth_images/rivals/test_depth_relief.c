/* Relief mapping: what it fails at, each beside its remedy. */
#include "apps/depth_images/rivals/relief.h"
#include "tests/support/depth/formula.h"

/* A picture of an image as a camera sees it. owns: the caller, frame_free */
static Frame draw(const DepthImage *image, const ReliefSetting *setting, const Camera *camera)
{
    const WarpView view = { *camera, FORMULA_SIDE, FORMULA_SIDE, NULL };
    Frame frame = { .color = NULL };
    const WarpTarget target = formula_target(false, &frame);
    Relief relief;
    GpError error = { "" };
    if (relief_open(image, &relief, &error) ||
        relief_add(&relief, setting, &view, &target, &frame, &error))
        fail_msg("%s", error.text);
    run_list(&frame.list);
    relief_close(&relief);
    return frame;
}

static FormulaOff off_of(Formula formula, bool is_parallel, const ReliefSetting *setting,
                         const Camera *camera)
{
    DepthImage image = formula_image(formula, is_parallel);
    Frame frame = draw(&image, setting, camera);
    const FormulaOff off = formula_compare(formula, camera, &frame);
    frame_free(&frame);
    formula_free(&image);
    return off;
}

/* From aside there is nothing between the step's two planes, and room to see through. */
static void walls_hang_from_edges_as_printed_but_not_from_thin_surfaces(void **state)
{
    (void)state;
    const Camera camera = formula_camera(3, 0, 4, false);
    for (int way = 0; way < 2; way++) {
        const FormulaOff printed =
            off_of(FORMULA_STEP, way, &(ReliefSetting){ .thickness = -1 }, &camera);
        const FormulaOff usual = off_of(FORMULA_STEP, way, &(ReliefSetting){ .steps = 0 }, &camera);
        const FormulaOff thin =
            off_of(FORMULA_STEP, way, &(ReliefSetting){ .steps = 255, .thickness = 1e-3 }, &camera);
        print_message("# too much: %u as printed, %u, %u if thin; missing: %u, %u, %u\n",
                      printed.extra, usual.extra, thin.extra, printed.missing, usual.missing,
                      thin.missing);
        assert_true(printed.extra > 500);
        assert_true(usual.extra < printed.extra / 2 && thin.extra < printed.extra / 10);
        assert_true(printed.missing + usual.missing + thin.missing == 0);
    }
}

/* A bar one pixel wide that stands before a plane: few steps go past it. */
static void few_steps_go_past_what_is_thin(void **state)
{
    (void)state;
    static const uint32_t steps[] = { 4, 16, 64, 255 };
    const Camera camera = formula_camera(3, 0, 4, false);
    DepthImage image = formula_image(FORMULA_FLAT, true);
    uint32_t bar[GP_COUNT(steps)] = { 0 };
    for (uint32_t y = 0; y < FORMULA_IMAGE; y++) {
        const uint32_t i = y * FORMULA_IMAGE + FORMULA_IMAGE / 2;
        image.front.depth[i] = 4;
        for (uint32_t k = 0; k < 3; k++)
            image.front.color[3 * i + k] = k == 0;
    }
    for (size_t s = 0; s < GP_COUNT(steps); s++) {
        static float rgba[FORMULA_SIDE * FORMULA_SIDE][4];
        Frame frame = draw(&image, &(ReliefSetting){ .steps = steps[s], .thickness = -1 }, &camera);
        assert_int_equal(gp_surface_read_floats(frame.color, 0, NULL, &rgba[0][0], NULL), GP_OK);
        for (uint32_t i = 0; i < FORMULA_SIDE * FORMULA_SIDE; i++)
            bar[s] += rgba[i][0] > 0.5f && rgba[i][1] < 0.25f && rgba[i][2] < 0.25f;
        frame_free(&frame);
        print_message("# %u steps: %u pixels of the bar\n", steps[s], bar[s]);
    }
    assert_true(bar[0] < bar[2] / 2 && bar[2] > 0 && bar[3] >= bar[2]);
    formula_free(&image);
}

/* The last step is along a line, so that planes need no halves. */
static void halves_bring_nearer_what_bends(void **state)
{
    (void)state;
    const Camera camera = formula_camera(0.1, 0.1, 3, false);
    const FormulaOff coarse =
        off_of(FORMULA_BALL, false, &(ReliefSetting){ .steps = 4, .halvings = 1, .thickness = 0.2 },
               &camera);
    const FormulaOff fine =
        off_of(FORMULA_BALL, false,
               &(ReliefSetting){ .steps = 4, .halvings = 10, .thickness = 0.2 }, &camera);
    print_message("# %.2g and %.2g deep\n", coarse.mean_depth, fine.mean_depth);
    assert_true(fine.mean_depth < 0.96 * coarse.mean_depth);
}

/* A mesh before it, and one behind it. */
static void its_depth_is_that_of_the_view(void **state)
{
    (void)state;
    const Camera camera = formula_camera(1, 0.5, 4.5, false);
    DepthImage image = formula_image(FORMULA_BALL, false);
    Frame alone = draw(&image, &(ReliefSetting){ .steps = 0 }, &camera);
    const uint32_t covered = formula_check_numbers(&alone);
    frame_free(&alone);
    for (int behind = 0; behind < 2; behind++) {
        const WarpView view = { camera, FORMULA_SIDE, FORMULA_SIDE, NULL };
        Frame frame = { .color = NULL };
        const WarpTarget target = formula_target(false, &frame);
        Relief relief;
        GpPass *below = (GpPass *)&frame.list.passes[0];
        const double distance = behind ? 8 : 2;
        below->depth.depth_value = (float)(camera.far * (distance - camera.near) /
                                           (distance * (camera.far - camera.near)));
        assert_int_equal(relief_open(&image, &relief, NULL), GP_OK);
        assert_int_equal(
            relief_add(&relief, &(ReliefSetting){ .steps = 0 }, &view, &target, &frame, NULL),
            GP_OK);
        run_list(&frame.list);
        assert_int_equal(formula_check_numbers(&frame), behind ? covered : 0);
        frame_free(&frame);
        relief_close(&relief);
    }
    formula_free(&image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_hang_from_edges_as_printed_but_not_from_thin_surfaces),
        cmocka_unit_test(few_steps_go_past_what_is_thin),
        cmocka_unit_test(halves_bring_nearer_what_bends),
        cmocka_unit_test(its_depth_is_that_of_the_view),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
