/* Look-alikes: they move no outline, parallax looks nearer to what is there than bumps, and its
 * places run away at flat angles unless they are limited. */
#include "apps/depth_images/rivals/parallax.h"
#include "tests/support/depth/formula.h"

typedef struct Look {
    uint32_t covered;
    uint64_t outline; /* of what is covered */
    FormulaOff off;
} Look;

static Look look(Formula formula, bool is_parallel, ParallaxKind kind, const Camera *camera)
{
    static float rgba[FORMULA_SIDE * FORMULA_SIDE][4];
    DepthImage image = formula_image(formula, is_parallel);
    const WarpView view = { *camera, FORMULA_SIDE, FORMULA_SIDE, NULL };
    Frame frame = { .color = NULL };
    const WarpTarget target = formula_target(false, &frame);
    Parallax parallax;
    assert_int_equal(parallax_open(&image, &parallax, NULL), GP_OK);
    assert_int_equal(
        parallax_add(&parallax, &(ParallaxSetting){ .kind = kind }, &view, &target, &frame, NULL),
        GP_OK);
    run_list(&frame.list);
    Look seen = { .covered = formula_check_numbers(&frame),
                  .off = formula_compare(formula, camera, &frame) };
    assert_int_equal(gp_surface_read_floats(frame.color, 0, NULL, &rgba[0][0], NULL), GP_OK);
    for (uint32_t i = 0; i < FORMULA_SIDE * FORMULA_SIDE; i++)
        seen.outline = seen.outline * 0x9e3779b97f4a7c15u + (rgba[i][3] > 0);
    parallax_close(&parallax);
    frame_free(&frame);
    formula_free(&image);
    return seen;
}

static void outlines_stay_and_parallax_is_nearer_to_the_truth(void **state)
{
    (void)state;
    const Camera camera = formula_camera(1.2, 0.5, 4.5, false);
    for (int way = 0; way < 2; way++) {
        const Look bump = look(FORMULA_BALL, way, PARALLAX_BUMP, &camera);
        const Look parallax = look(FORMULA_BALL, way, PARALLAX_OFFSET, &camera);
        const Look limited = look(FORMULA_BALL, way, PARALLAX_LIMITED, &camera);
        print_message(
            "# colours off by %.3f, parallax %.3f, limited %.3f; missing %u, %u more of %u\n",
            bump.off.mean_color, parallax.off.mean_color, limited.off.mean_color, bump.off.missing,
            bump.off.extra, bump.off.covered);
        assert_true(bump.outline == parallax.outline && bump.outline == limited.outline);
        assert_true(bump.covered > 1000 &&
                    bump.off.missing + bump.off.extra > bump.off.covered / 20);
        assert_true(parallax.off.mean_color < bump.off.mean_color / 2);
        assert_true(limited.off.mean_color < bump.off.mean_color / 2);
    }
}

static void places_run_away_at_flat_angles_unless_limited(void **state)
{
    (void)state;
    const Camera camera = formula_camera(4, 0.5, 1.2, false);
    for (int way = 0; way < 2; way++) {
        const Look parallax = look(FORMULA_PLANE, way, PARALLAX_OFFSET, &camera);
        const Look limited = look(FORMULA_PLANE, way, PARALLAX_LIMITED, &camera);
        print_message("# colours off by %.3f, limited %.3f\n", parallax.off.mean_color,
                      limited.off.mean_color);
        assert_true(limited.off.mean_color < parallax.off.mean_color);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outlines_stay_and_parallax_is_nearer_to_the_truth),
        cmocka_unit_test(places_run_away_at_flat_angles_unless_limited),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
