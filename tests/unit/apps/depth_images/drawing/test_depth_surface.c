/* Depth images drawn straight: near to the truth from everywhere, whole at the seam, the same bits
 * on every device; and their failures, each beside its remedy. */
#include "apps/depth_images/drawing/surface.h"
#include "tests/support/depth/around.h"

enum { IMAGE = 128 };

static Frame draw(const DepthSurface *surfaces, uint32_t count, const SurfaceSetting *setting,
                  const Camera *camera, GpFormat format)
{
    Frame frame = { .color = NULL };
    const WarpView view = around_view(camera, format != GP_A8R8G8B8);
    around_target(&frame, format);
    for (uint32_t i = 0; i < count; i++)
        surface_draw(&surfaces[i], setting, &view, true, &frame);
    return frame;
}

static void open_all(const DepthModel *model, const SurfaceDetail *detail, DepthSurface *surfaces)
{
    GpError error = { "" };
    for (uint32_t i = 0; i < model->count; i++)
        if (surface_open(&model->images[i], detail, &surfaces[i], &error))
            fail_msg("%s", error.text);
}

static void close_all(DepthModel *model, DepthSurface *surfaces)
{
    for (uint32_t i = 0; i < model->count; i++)
        surface_close(&surfaces[i]);
    depth_model_free(model);
}

static DepthCompared compare(const DepthShape *shape, const DepthSurface *surfaces, uint32_t count,
                             const SurfaceSetting *setting, const Camera *camera)
{
    Frame frame = draw(surfaces, count, setting, camera, GP_A8R8G8B8);
    const DepthCompared compared = around_compare(shape, camera, &frame);
    frame_free(&frame);
    return compared;
}

/* How far from its own pixel a triangle takes its colours, in pixels of the image, at most. */
static double drift_in(const DepthImage *image, const SurfaceVertex *const corner[3])
{
    double most = 0;
    for (int i = 0; i < 64; i++) {
        const double a = (i % 8) / 7.0, b = (1 - a) * (i / 8) / 7.0, share[3] = { a, b, 1 - a - b };
        double point[3] = { 0 }, colored[2] = { 0 }, place[2], depth;
        for (int c = 0; c < 3; c++) {
            for (int k = 0; k < 3; k++)
                point[k] += share[c] * (double)corner[c]->position[k];
            colored[0] += share[c] * (double)corner[c]->texcoord[0] * image->front.width;
            colored[1] += share[c] * (double)corner[c]->texcoord[1] * image->front.height;
        }
        assert_true(depth_plane_place(&image->plane, &image->front, point, place, &depth));
        most = fmax(most, hypot(place[0] - colored[0], place[1] - colored[1]));
    }
    return most;
}

/* Of a floor to the horizon, where a pixel is wide far away and narrow near by, so that places in
 * the picture are no linear function of those in a triangle: merging takes both as one no farther
 * than a pixel. */
static void colors_of_a_perspective_floor_drift_by_a_pixel_at_most(void **state)
{
    (void)state;
    DepthImage image = { .plane = { .eye = { 0, 1, 0 },
                                    .right = { 1, 0, 0 },
                                    .up = { 0, 1, 0 },
                                    .forward = { 0, 0, -1 },
                                    .left = -1,
                                    .bottom = -1,
                                    .width = 2,
                                    .height = 2 } };
    DepthSurface surface;
    double most = 0;
    assert_int_equal(depth_pixels_make(IMAGE, IMAGE, false, &image.front), GP_OK);
    for (size_t y = IMAGE / 2 + 4; y < IMAGE; y++)
        for (size_t x = 0; x < IMAGE; x++)
            image.front.depth[y * IMAGE + x] = (float)(1 / ((2 * (double)y + 1) / IMAGE - 1));
    assert_int_equal(surface_open(&image, NULL, &surface, NULL), GP_OK);
    const SurfaceLevel *level = &surface.levels[0];
    for (uint32_t i = 0; i < level->mesh.index_count; i += 3) {
        const uint32_t *index = level->mesh.indices + i;
        const SurfaceVertex *v = level->vertices, *const corner[3] = { v + index[0], v + index[1],
                                                                       v + index[2] };
        most = fmax(most, drift_in(&image, corner));
    }
    print_message("# %u triangles of %d, %.3f pixels at most\n", level->mesh.index_count / 3,
                  2 * (IMAGE - 1) * (IMAGE / 2 - 5), most);
    assert_true(level->mesh.index_count / 3 < IMAGE * IMAGE / 4);
    assert_true(most > 0.01 && most < 1);
    surface_close(&surface);
    depth_pixels_free(&image.front);
}

static void every_side_is_near_the_truth(void **state)
{
    (void)state;
    static const struct {
        double azimuth, elevation, psnr;
    } eyes[] = { { 0, 0, 35 },    { 0.7, 10, 35 },  { 90, -20, 33 }, { 181, 5, 35 },
                 { 270, 30, 30 }, { 330, -35, 30 }, { 45, 0.01, 35 } };
    DepthShape shape = depth_shape_vase();
    DepthModel model = depth_shape_capture(&shape, 2 * IMAGE, IMAGE, 0, false);
    DepthSurface surface;
    open_all(&model, NULL, &surface);
    for (size_t i = 0; i < GP_COUNT(eyes); i++) {
        const Camera camera = around_camera(&shape, eyes[i].azimuth, eyes[i].elevation, 4);
        const DepthCompared c =
            compare(&shape, &surface, 1, &(SurfaceSetting){ .both_sides = true }, &camera);
        print_message("# %g, %g: %.1f dB, %u of %u missing, %u more, %.4f off\n", eyes[i].azimuth,
                      eyes[i].elevation, c.psnr, c.missing, c.covered, c.extra, c.depth);
        assert_true(c.psnr >= eyes[i].psnr);
        assert_true(c.missing + c.extra <= c.covered / 25);
        assert_true(c.depth < 0.01);
    }
    close_all(&model, &surface);
    depth_shape_close(&shape);
}

/* Azimuth 0 is in the middle of the picture, where a column that is not there leaves a gap. */
static void the_seam_is_closed(void **state)
{
    (void)state;
    uint32_t missing[2];
    DepthShape shape = depth_shape_vase();
    const Camera camera = around_camera(&shape, 0, 0, 3);
    for (int gap = 0; gap < 2; gap++) {
        DepthModel model = depth_shape_capture(&shape, IMAGE, IMAGE, 0, false);
        DepthSurface surface;
        for (uint32_t y = 0; y < IMAGE && gap; y++)
            model.images[0].front.depth[y * IMAGE] = DEPTH_NOTHING;
        open_all(&model, NULL, &surface);
        missing[gap] =
            compare(&shape, &surface, 1, &(SurfaceSetting){ .step = 1 }, &camera).missing;
        close_all(&model, &surface);
    }
    print_message("# missing: %u, without the seam's column %u\n", missing[0], missing[1]);
    assert_true(missing[1] > missing[0] + 80);
    depth_shape_close(&shape);
}

/* Figure 12a: from above one looks into a cylinder that has no cap. */
static void caps_close_what_is_seen_from_above(void **state)
{
    (void)state;
    DepthShape shape = depth_shape_open("builtin:cube", 20, 0);
    DepthModel model = depth_shape_capture(&shape, 2 * IMAGE, IMAGE, IMAGE, false);
    DepthSurface surfaces[3];
    const Camera camera = around_camera(&shape, 20, 70, 3.5 * shape.radius);
    open_all(&model, NULL, surfaces);
    const SurfaceSetting usual = { .step = 0 };
    const DepthCompared without = compare(&shape, surfaces, 1, &usual, &camera);
    const DepthCompared with = compare(&shape, surfaces, 2, &usual, &camera);
    print_message("# missing of %u: %u without a cap, %u with it; %.1f and %.1f dB\n",
                  without.covered, without.missing, with.missing, without.psnr, with.psnr);
    assert_true(without.missing > without.covered / 50);
    assert_true(with.missing < without.missing / 4 && with.psnr > 30);
    close_all(&model, surfaces);
    depth_shape_close(&shape);
}

/* A ring that stands: rays towards the axis pass by its hole's edge. Of each half's own cylinder,
 * as the paper has it, nothing is lost. */
static void a_hole_is_kept_by_pieces(void **state)
{
    (void)state;
    DepthShape ring = depth_shape_open("builtin:torus", 20, 80);
    DepthModel model = depth_shape_capture(&ring, 2 * IMAGE, IMAGE, IMAGE, false);
    DepthSurface surfaces[12];
    const Camera camera = around_camera(&ring, 60, 20, 3.5 * ring.radius);
    const SurfaceSetting usual = { .step = 0 };
    open_all(&model, NULL, surfaces);
    const DepthCompared one = compare(&ring, surfaces, 3, &usual, &camera);
    close_all(&model, surfaces);

    DepthModel pieces[4];
    for (int i = 0; i < 4; i++) {
        DepthShape piece = depth_shape_piece(&ring, i);
        pieces[i] = depth_shape_capture(&piece, 2 * IMAGE, IMAGE, IMAGE, false);
        open_all(&pieces[i], NULL, &surfaces[3 * i]);
        depth_shape_close(&piece);
    }
    const DepthCompared four = compare(&ring, surfaces, 12, &usual, &camera);
    print_message("# one cylinder: %u of %u missing, %.1f dB; four: %u, %.1f dB\n", one.missing,
                  one.covered, one.psnr, four.missing, four.psnr);
    for (int i = 0; i < 4; i++)
        close_all(&pieces[i], &surfaces[3 * i]);
    assert_true(four.missing < one.missing / 2);
    depth_shape_close(&ring);
}

/* How much a picture changes where the step does: mean over all covered pixels, of 255. */
static void levels_change_gently(void **state)
{
    (void)state;
    DepthShape shape = depth_shape_vase();
    DepthModel model = depth_shape_capture(&shape, 2 * IMAGE, IMAGE, 0, true);
    DepthSurface surface;
    open_all(&model, NULL, &surface);
    double distance = 2, last = 0;
    for (uint32_t step = 2; step <= 8; step *= 2) {
        Camera camera = around_camera(&shape, 30, 15, distance);
        WarpView view = around_view(&camera, false);
        while (surface_step(&surface, &view) < step) {
            distance *= 1.01;
            view.camera = camera = around_camera(&shape, 30, 15, distance);
        }
        double sum = 0;
        uint32_t covered = 0;
        static float rgba[2][AROUND_SIDE * AROUND_SIDE][4];
        for (int i = 0; i < 2; i++) {
            const SurfaceSetting fixed = { .step = i ? step : step / 2 };
            Frame frame = draw(&surface, 1, &fixed, &camera, GP_A8R8G8B8);
            run_list(&frame.list);
            assert_int_equal(gp_surface_read_floats(frame.color, 0, NULL, &rgba[i][0][0], NULL),
                             GP_OK);
            frame_free(&frame);
        }
        for (int i = 0; i < AROUND_SIDE * AROUND_SIDE; i++) {
            covered += rgba[0][i][3] > 0 || rgba[1][i][3] > 0;
            for (int k = 0; k < 3; k++)
                sum += fabs((double)rgba[0][i][k] - (double)rgba[1][i][k]) / 3;
        }
        last = 255 * sum / covered;
        print_message("# at %.1f to step %u: %.1f of 255, %u pixels\n", distance, step, last,
                      covered);
        assert_true(covered > 0 && last > 0 && last < 16);
    }
    close_all(&model, &surface);
    depth_shape_close(&shape);
}

static void no_eye_makes_a_nan(void **state)
{
    (void)state;
    DepthShape shape = depth_shape_vase();
    DepthModel model = depth_shape_capture(&shape, IMAGE, IMAGE, 32, true);
    DepthSurface surfaces[3];
    open_all(&model, NULL, surfaces);
    for (int i = 0; i < 40; i++) {
        const double distance = (double[]){ 0.01, 0.5, 1, 1.02, 2, 30 }[i % 6];
        Camera camera = around_camera(&shape, 47 * i, -90 + 12 * (i % 16), distance);
        if (i % 5 == 0) { /* parallel rays */
            camera.fovy = 0;
            camera.height = 3;
        }
        Frame frame =
            draw(surfaces, 3, &(SurfaceSetting){ .both_sides = i % 2 }, &camera, GP_A32B32G32R32F);
        around_finite(&frame);
        frame_free(&frame);
    }
    close_all(&model, surfaces);
    depth_shape_close(&shape);
}

static void every_device_draws_the_same_bits(void **state)
{
    (void)state;
    DepthShape shape = depth_shape_open("builtin:sphere", 20, 0);
    DepthModel model = depth_shape_capture(&shape, 64, 64, 32, true);
    DepthSurface surfaces[3];
    open_all(&model, NULL, surfaces);
    const Camera camera = around_camera(&shape, 100, 40, 3.5 * shape.radius);
    for (int lit = 0; lit < 2; lit++) {
        Frame frame = draw(surfaces, 3, &(SurfaceSetting){ .step = lit ? 2 : 1 }, &camera,
                           lit ? GP_A32B32G32R32F : GP_A8R8G8B8);
        run_everywhere(&frame);
        frame_free(&frame);
    }
    close_all(&model, surfaces);
    depth_shape_close(&shape);
}

/* Of nothing, of one pixel, of four. */
static void the_smallest_images_are_drawn(void **state)
{
    (void)state;
    DepthShape shape = depth_shape_vase();
    const Camera camera = around_camera(&shape, 30, 20, 3);
    for (uint32_t side = 1; side <= 2; side++)
        for (int empty = 0; empty < 2; empty++) {
            DepthModel model = depth_shape_capture(&shape, side, side, side, true);
            DepthSurface surfaces[3];
            for (uint32_t i = 0; i < side * side && empty; i++)
                model.images[0].front.depth[i] = DEPTH_NOTHING;
            open_all(&model, NULL, surfaces);
            Frame frame = draw(surfaces, 3, &(SurfaceSetting){ .both_sides = true }, &camera,
                               GP_A32B32G32R32F);
            around_finite(&frame);
            frame_free(&frame);
            close_all(&model, surfaces);
        }
    depth_shape_close(&shape);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colors_of_a_perspective_floor_drift_by_a_pixel_at_most),
        cmocka_unit_test(every_side_is_near_the_truth),
        cmocka_unit_test(the_seam_is_closed),
        cmocka_unit_test(caps_close_what_is_seen_from_above),
        cmocka_unit_test(a_hole_is_kept_by_pieces),
        cmocka_unit_test(levels_change_gently),
        cmocka_unit_test(no_eye_makes_a_nan),
        cmocka_unit_test(every_device_draws_the_same_bits),
        cmocka_unit_test(the_smallest_images_are_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
