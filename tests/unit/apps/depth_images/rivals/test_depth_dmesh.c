/* Depth meshes: rubber sheets, and the cut that is their remedy; simplified ones, with as good a
 * picture. */
#include "apps/depth_images/rivals/dmesh.h"
#include "tests/support/depth/formula.h"

/* A picture as a camera sees it. in/out triangles: NULL: not asked for */
static FormulaOff off_of(Formula formula, bool is_parallel, const DmeshDetail *detail,
                         const Camera *camera, uint32_t *triangles)
{
    DepthImage image = formula_image(formula, is_parallel);
    const WarpView view = { *camera, FORMULA_SIDE, FORMULA_SIDE, NULL };
    Frame frame = { .color = NULL };
    const WarpTarget target = formula_target(false, &frame);
    Dmesh dmesh;
    GpError error = { "" };
    const GpResult result = dmesh_open_detailed(&image, detail, &dmesh, &error);
    if (result == GP_ERROR_UNSUPPORTED) {
        print_message("# skipped: %s\n", error.text);
        skip();
    }
    assert_int_equal(result, GP_OK);
    assert_int_equal(dmesh_add(&dmesh, &(DmeshSetting){ NULL }, &view, &target, &frame, NULL),
                     GP_OK);
    run_list(&frame.list);
    const FormulaOff off = formula_compare(formula, camera, &frame);
    if (triangles)
        *triangles = dmesh.triangle_count;
    dmesh_close(&dmesh);
    frame_free(&frame);
    formula_free(&image);
    return off;
}

static void rubber_sheets_are_cut(void **state)
{
    (void)state;
    const Camera camera = formula_camera(3, 0, 4, false);
    for (int way = 0; way < 2; way++) {
        const FormulaOff whole =
            off_of(FORMULA_STEP, way, &(DmeshDetail){ .cut = -1 }, &camera, NULL);
        const FormulaOff cut = off_of(FORMULA_STEP, way, NULL, &camera, NULL);
        print_message("# too much: %u, cut %u; missing %u, %u\n", whole.extra, cut.extra,
                      whole.missing, cut.missing);
        assert_true(whole.extra > 500 && cut.extra == 0);
        assert_true(whole.missing == 0 && cut.missing < cut.covered / 20);
    }
}

static void a_few_triangles_are_as_good(void **state)
{
    (void)state;
    const Camera camera = formula_camera(0.6, 0.3, 4.5, false);
    uint32_t all, few;
    const FormulaOff whole = off_of(FORMULA_BALL, false, NULL, &camera, &all);
    const FormulaOff simple =
        off_of(FORMULA_BALL, false, &(DmeshDetail){ .share = 0.2 }, &camera, &few);
    print_message("# %u triangles %.2g deep, %u triangles %.2g deep; missing %u, %u\n", all,
                  whole.mean_depth, few, simple.mean_depth, whole.missing, simple.missing);
    assert_in_range(few, all / 5 - 2, all / 5 + 2);
    assert_true(simple.mean_depth < 2e-3 && simple.mean_color < 0.02);
    assert_in_range(simple.missing, 0, whole.missing + 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rubber_sheets_are_cut),
        cmocka_unit_test(a_few_triangles_are_as_good),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
