/* Cylindrical depth images warped as printed: near to the truth and to the same image drawn
 * straight, in an order that needs no depth test; what an eye inside and parallel rays get. */
#include "apps/depth_images/drawing/cylinder.h"
#include "tests/support/depth/around.h"

enum { IMAGE = 128 };

typedef struct Warps {
    DepthModel model;
    CylinderWarp made[3];
} Warps;

/* warps: stays where it is */
static void open_warps(const DepthShape *shape, uint32_t caps, Warps *warps)
{
    GpError error = { "" };
    warps->model = depth_shape_capture(shape, 2 * IMAGE, IMAGE, caps, true);
    for (uint32_t i = 0; i < warps->model.count; i++)
        if (cylinder_open(&warps->model.images[i], &warps->made[i], &error))
            fail_msg("%s", error.text);
}

static void close_warps(Warps *warps)
{
    for (uint32_t i = 0; i < warps->model.count; i++)
        cylinder_close(&warps->made[i]);
    depth_model_free(&warps->model);
}

static Frame draw(const Warps *warps, uint32_t step, const Camera *camera, GpFormat format)
{
    GpError error = { "" };
    Frame frame = { .color = NULL };
    const WarpView view = around_view(camera, format != GP_A8R8G8B8);
    const WarpTarget target = around_target(&frame, format);
    for (uint32_t i = 0; i < warps->model.count; i++)
        if (cylinder_add(&warps->made[i], &(CylinderSetting){ .step = step }, &view, &target,
                         &frame, &error))
            fail_msg("%s", error.text);
    return frame;
}

static bool has_pass(const Frame *frame, const char *name)
{
    for (uint32_t i = 0; i < frame->list.pass_count; i++)
        if (strcmp(frame->list.passes[i].name, name) == 0)
            return true;
    return false;
}

static void every_side_is_near_the_truth(void **state)
{
    (void)state;
    static const double eyes[][2] = { { 0, 0 },    { 0.7, 10 },  { 90, -12 }, { 181, 5 },
                                      { 270, 12 }, { 359.5, 3 }, { 45, 0.01 } };
    DepthShape shape = depth_shape_vase();
    Warps warps;
    open_warps(&shape, 0, &warps);
    for (size_t i = 0; i < GP_COUNT(eyes); i++) {
        const Camera camera = around_camera(&shape, eyes[i][0], eyes[i][1], 4);
        Frame frame = draw(&warps, 0, &camera, GP_A8R8G8B8);
        assert_true(has_pass(&frame, "cylinder-warp"));
        const DepthCompared c = around_compare(&shape, &camera, &frame);
        print_message("# %g, %g: %.1f dB, %u of %u missing, %u more, %.4f off\n", eyes[i][0],
                      eyes[i][1], c.psnr, c.missing, c.covered, c.extra, c.depth);
        assert_true(c.psnr >= 27);
        assert_true(c.missing + c.extra <= c.covered / 25);
        assert_true(c.depth < 0.02);
        frame_free(&frame);
    }
    close_warps(&warps);
    depth_shape_close(&shape);
}

/* Pixels of the first pass whose point is not the nearest of all that fall on them, among those
 * covered.
 * in   wrong: the order is that of an eye elsewhere */
static uint32_t hidden_wrongly(const Warps *warps, const Camera *camera, bool wrong)
{
    Frame ordered = draw(warps, 1, camera, GP_A8R8G8B8),
          tested = draw(warps, 1, camera, GP_A8R8G8B8);
    GpSurface *targets[2];
    uint32_t count = 0;
    for (int i = 0; i < 2; i++) {
        Frame *frame = i ? &tested : &ordered;
        GpPass *pass = (GpPass *)(uintptr_t)&frame->list.passes[1];
        GpDraw *draws = (GpDraw *)(uintptr_t)pass->draws;
        targets[i] = pass->color[1].surface;
        for (uint32_t k = 0; i == 0 && wrong && k < pass->draw_count / 2; k++) {
            const GpDraw swap = draws[k];
            draws[k] = draws[pass->draw_count - 1 - k];
            draws[pass->draw_count - 1 - k] = swap;
        }
        /* the nearest is the largest: what a depth test would keep */
        for (uint32_t k = 0; i == 1 && k < pass->draw_count; k++)
            draws[k].state.blend[1] = (GpBlend){ .op = GP_BLEND_MAX, .src = GP_ONE, .dst = GP_ONE };
        run_list(&frame->list);
    }
    const uint32_t pixels = targets[0]->width * targets[0]->height;
    float(*near)[4] = gp_alloc(2 * pixels, sizeof *near);
    for (int i = 0; i < 2; i++)
        assert_int_equal(
            gp_surface_read_floats(targets[i], 0, NULL, near[(uint32_t)i * pixels], NULL), GP_OK);
    for (uint32_t i = 0; i < pixels; i++)
        count += near[i][0] < near[pixels + i][0] - 1e-3f;
    gp_free(near);
    frame_free(&ordered);
    frame_free(&tested);
    return count;
}

static void the_order_hides_what_is_behind(void **state)
{
    (void)state;
    DepthShape shape = depth_shape_vase();
    Warps warps;
    open_warps(&shape, 0, &warps);
    for (int i = 0; i < 6; i++) {
        const Camera camera = around_camera(&shape, 61 * i, 13 * i - 30, i % 2 ? 2.5 : 5);
        const uint32_t right = hidden_wrongly(&warps, &camera, false);
        const uint32_t wrong = hidden_wrongly(&warps, &camera, true);
        print_message("# %u pixels wrong, in the other order %u\n", right, wrong);
        assert_int_equal(right, 0);
        assert_true(wrong > 50);
    }
    close_warps(&warps);
    depth_shape_close(&shape);
}

/* The paper's three cases: of a cube, whose top only a cap has. */
static void caps_are_drawn_on_their_side(void **state)
{
    (void)state;
    static const struct {
        double elevation;
        uint32_t passes;
    } eyes[] = { { 0, 3 }, { 60, 4 }, { -60, 4 } };
    DepthShape shape = depth_shape_open("builtin:cube", 20, 0);
    Warps warps;
    open_warps(&shape, IMAGE, &warps);
    for (size_t i = 0; i < GP_COUNT(eyes); i++) {
        const Camera camera = around_camera(&shape, 20, eyes[i].elevation, 4 * shape.radius);
        Frame frame = draw(&warps, 0, &camera, GP_A8R8G8B8);
        assert_int_equal(frame.list.pass_count, eyes[i].passes);
        const DepthCompared c = around_compare(&shape, &camera, &frame);
        print_message("# at %g: %u of %u missing, %.1f dB\n", eyes[i].elevation, c.missing,
                      c.covered, c.psnr);
        assert_true(c.missing < c.covered / 20);
        frame_free(&frame);
    }
    close_warps(&warps);
    depth_shape_close(&shape);
}

static void what_has_no_plane_is_drawn_straight_and_said(void **state)
{
    (void)state;
    DepthShape shape = depth_shape_vase();
    Warps warps;
    open_warps(&shape, 0, &warps);
    for (int i = 0; i < 4; i++) {
        Camera camera = around_camera(&shape, 30, i == 2 ? 90 : 10, i == 1 ? 0.5 : 3);
        if (i == 3) {
            camera.fovy = 0;
            camera.height = 3;
        }
        const WarpView view = around_view(&camera, false);
        const char *warning = cylinder_warning(&warps.model.images[0], &view);
        Frame frame = draw(&warps, 0, &camera, GP_A32B32G32R32F);
        assert_true(has_pass(&frame, "cylinder-warp") == (i == 0));
        assert_true((warning == NULL) == (i == 0));
        if (warning)
            assert_non_null(strstr(warning, i == 3 ? "parallel" : "inside"));
        assert_true(around_finite(&frame) > 0 || i == 1); /* from inside all turns away */
        frame_free(&frame);
    }
    close_warps(&warps);
    depth_shape_close(&shape);
}

/* Relief of one height all over is the image on a cylinder that is so much wider; of waves, it is
 * not. */
static void relief_moves_points(double outwards)
{
    static float rgba[3][AROUND_SIDE * AROUND_SIDE][4];
    DepthShape shape = depth_shape_vase();
    Warps warps[2];
    GpSurface *heights = NULL;
    const GpSurfaceDesc desc = { .format = GP_R32F, .width = 8, .height = 8 };
    assert_int_equal(gp_surface_create(&desc, &heights, NULL), GP_OK);
    open_warps(&shape, 0, &warps[0]);
    warps[1].model = depth_shape_capture(&shape, 2 * IMAGE, IMAGE, 0, true);
    warps[1].model.images[0].cylinder.radius += outwards;
    assert_int_equal(cylinder_open(&warps[1].model.images[0], &warps[1].made[0], NULL), GP_OK);
    for (int inside = 0; inside < 2; inside++) {
        const Camera camera = around_camera(&shape, 30, inside ? 90 : 8, 4);
        for (int i = 0; i < 3; i++) {
            Frame frame = { .color = NULL };
            const WarpView view = around_view(&camera, false);
            const WarpTarget target = around_target(&frame, GP_A8R8G8B8);
            CylinderSetting setting = { .step = 1 };
            if (i != 1)
                setting.detail =
                    (WarpDetail){ heights, i ? 4 * outwards : outwards, { 6, 5 }, false };
            gp_surface_clear_color(heights, (float[4]){ 1, 1, 1, 1 });
            for (uint32_t k = 0; k < 8 && i == 2; k++)
                memset(gp_surface_texel(&heights->level[0], 4, k, k), 0, 4);
            assert_int_equal(
                cylinder_add(&warps[i == 1].made[0], &setting, &view, &target, &frame, NULL),
                GP_OK);
            run_list(&frame.list);
            assert_int_equal(gp_surface_read_floats(frame.color, 0, NULL, &rgba[i][0][0], NULL),
                             GP_OK);
            frame_free(&frame);
        }
        uint32_t off = 0, waves = 0;
        for (int i = 0; i < AROUND_SIDE * AROUND_SIDE; i++) {
            off += fabsf(rgba[0][i][0] - rgba[1][i][0]) > 0.02f;
            waves += fabsf(rgba[2][i][0] - rgba[1][i][0]) > 0.02f;
        }
        print_message("# %u pixels off; with waves %u\n", off, waves);
        assert_true(off < 20 && waves > 500);
    }
    gp_surface_destroy(&heights);
    close_warps(&warps[0]);
    close_warps(&warps[1]);
    depth_shape_close(&shape);
}

static void relief_moves_points_outwards(void **state)
{
    (void)state;
    relief_moves_points(0.0625);
    relief_moves_points(0.25);
}

static void no_eye_makes_a_nan(void **state)
{
    (void)state;
    DepthShape shape = depth_shape_vase();
    Warps warps;
    open_warps(&shape, 32, &warps);
    for (int i = 0; i < 36; i++) {
        const double radii[] = { 1e-9, 0.4, 1, 1.0005, 1.002, 30 };
        const Camera camera = around_camera(&shape, 47 * i, i < 12 ? 0 : -90 + 10 * (i % 19),
                                            radii[i % 6] * shape.radius);
        Frame frame = draw(&warps, i % 3 == 0 ? 4 : 0, &camera, GP_A32B32G32R32F);
        around_finite(&frame);
        frame_free(&frame);
    }
    close_warps(&warps);
    depth_shape_close(&shape);
}

static void every_device_draws_the_same_bits(void **state)
{
    (void)state;
    DepthShape shape = depth_shape_open("builtin:cube", 20, 30);
    Warps warps;
    open_warps(&shape, 32, &warps);
    for (int i = 0; i < 3; i++) { /* the last one straight */
        const Camera camera = around_camera(&shape, 100, i == 2 ? 90 : 40, 3.5 * shape.radius);
        Frame frame = draw(&warps, 4, &camera, i == 1 ? GP_A8R8G8B8 : GP_A32B32G32R32F);
        run_everywhere(&frame);
        frame_free(&frame);
    }
    close_warps(&warps);
    depth_shape_close(&shape);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_side_is_near_the_truth),
        cmocka_unit_test(the_order_hides_what_is_behind),
        cmocka_unit_test(caps_are_drawn_on_their_side),
        cmocka_unit_test(what_has_no_plane_is_drawn_straight_and_said),
        cmocka_unit_test(relief_moves_points_outwards),
        cmocka_unit_test(no_eye_makes_a_nan),
        cmocka_unit_test(every_device_draws_the_same_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
