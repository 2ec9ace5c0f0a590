/* Micro-structure over depth images, held against rays in double that meet the same heights. */
#include "apps/depth_images/drawing/direct.h"
#include "apps/depth_images/drawing/planar.h"
#include "tests/support/depth/formula.h"

enum { PICTURE = 128, HEIGHTS = 64, SEEN = 96 };

static const double two_pi = 0x1.921fb54442d18p+2;
static const double amplitude = 0.3;
#define WAVES 3 /* across the picture, which is 2 wide, and down */

/* Of copies of the texture, 0 to 1: one wave each. */
static double height_at(double x, double y)
{
    return 0.5 + 0.25 * cos(two_pi * WAVES * (x + 1) / 2) +
           0.25 * cos(two_pi * WAVES * (1 - y) / 2);
}

/* A texture of one wave, with all levels. */
static GpSurface *make_heights(void)
{
    const GpSurfaceDesc desc = {
        .format = GP_R32F, .width = HEIGHTS, .height = HEIGHTS, .levels = GP_MAX_LEVELS
    };
    GpSurface *surface;
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    float *texels = (float *)(void *)surface->level[0].texels;
    for (int i = 0; i < HEIGHTS * HEIGHTS; i++)
        texels[i] = (float)(0.5 + 0.25 * cos(two_pi * (i % HEIGHTS + 0.5) / HEIGHTS) +
                            0.25 * cos(two_pi * (i / HEIGHTS + 0.5) / HEIGHTS));
    gp_surface_build_mips(surface);
    return surface;
}

/* z = 0 between -1 and 1, from z = 2. */
static DepthImage flat_image(void)
{
    DepthImage image = { .plane = { .is_parallel = true,
                                    .eye = { 0, 0, 2 },
                                    .right = { 1, 0, 0 },
                                    .up = { 0, 1, 0 },
                                    .forward = { 0, 0, -1 },
                                    .left = -1,
                                    .bottom = -1,
                                    .width = 2,
                                    .height = 2 } };
    assert_int_equal(depth_pixels_make(PICTURE, PICTURE, true, &image.front), GP_OK);
    for (size_t i = 0; i < PICTURE * PICTURE; i++) {
        image.front.depth[i] = 2;
        image.front.normal[3 * i + 2] = 1;
    }
    return image;
}

static WarpDetail smooth(const GpSurface *heights)
{
    return (WarpDetail){ heights, amplitude, { WAVES, WAVES }, true };
}

/* How far along a ray the heights are met first, by small steps that are then halved. */
static double meet(const double from[3], const double way[3])
{
    double point[3], t = 0;
    const double step = 1.0 / 256;
    for (t = (amplitude - from[2]) / way[2];; t += step) {
        memcpy(point, from, sizeof point);
        vector_add_scaled(point, t, way, point);
        if (point[2] <= amplitude * height_at(point[0], point[1]))
            break;
    }
    for (double half = step / 2; half > 1e-9; half /= 2) {
        memcpy(point, from, sizeof point);
        vector_add_scaled(point, t - half, way, point);
        if (point[2] <= amplitude * height_at(point[0], point[1]))
            t -= half;
    }
    return t;
}

typedef struct Off {
    uint32_t pixels, missing, far; /* far: by more than a tenth of the relief */
    double mean;
} Off;

/* Of depths along the view, over what the middle of the image is hit by. */
static Off off_of(const Camera *camera, const Frame *frame)
{
    static float depth[SEEN * SEEN][4];
    const CameraAxes axes = camera_axes(camera, 1);
    Off off = { 0 };
    run_list(&frame->list);
    assert_int_equal(gp_surface_read_floats(frame->depth, 0, NULL, &depth[0][0], NULL), GP_OK);
    for (int i = 0; i < SEEN * SEEN; i++) {
        const double right = (2 * (i % SEEN + 0.5) / SEEN - 1) * axes.half_width,
                     up = (1 - 2 * (i / SEEN + 0.5) / SEEN) * axes.half_height;
        double way[3], point[3];
        for (int k = 0; k < 3; k++)
            way[k] = axes.forward[k] + right * axes.right[k] + up * axes.up[k];
        if (way[2] > -0.2)
            continue;
        const double t = meet(camera->eye, way);
        memcpy(point, camera->eye, sizeof point);
        vector_add_scaled(point, t, way, point);
        if (fabs(point[0]) > 0.9 || fabs(point[1]) > 0.9)
            continue;
        const double z = (double)depth[i][0], near = camera->near, far = camera->far;
        off.pixels++;
        off.missing += z == 1;
        if (z == 1)
            continue;
        const double miss = fabs(near * far / (far - z * (far - near)) - t);
        off.far += miss > amplitude / 10;
        off.mean += miss;
    }
    off.mean /= off.pixels - off.missing;
    return off;
}

/* By rays; from before the image and from 50 degrees aside, where the waves hide each other. */
static void relief_is_that_of_rays_cast_at_its_heights(void **state)
{
    (void)state;
    GpSurface *heights = make_heights();
    DepthImage image = flat_image();
    Direct direct;
    Planar planar;
    assert_int_equal(direct_open(&image, &direct, NULL), GP_OK);
    assert_int_equal(planar_open(&image, &planar, NULL), GP_OK);
    for (int i = 0; i < 8; i++) {
        const bool is_printed = i & 1, is_bare = i & 2, is_aside = i & 4;
        const Camera camera = { .eye = { is_aside ? 3 : 0.2, is_aside ? 1 : 0, is_aside ? 2.5 : 4 },
                                .up = { 0, 1, 0 },
                                .fovy = 24,
                                .near = 1,
                                .far = 10 };
        Frame frame = { .color = NULL };
        const WarpTarget target = formula_target(false, &frame);
        const WarpView view = { camera, frame.color->width, frame.color->height, NULL };
        const DirectSetting front = { .step = 1, .detail = smooth(is_bare ? NULL : heights) };
        const PlanarSetting printed = { .step = 1, .detail = front.detail };
        assert_int_equal(is_printed ? planar_add(&planar, &printed, &view, &target, &frame, NULL)
                                    : direct_add(&direct, &front, &view, &target, &frame, NULL),
                         GP_OK);
        const Off off = off_of(&camera, &frame);
        print_message("# %s%s%s: of %u pixels %u missing, %u far, %.5f off\n",
                      is_printed ? "planar" : "direct", is_bare ? ", bare" : "",
                      is_aside ? ", aside" : "", off.pixels, off.missing, off.far, off.mean);
        assert_true(off.pixels > SEEN * SEEN / 3);
        if (is_bare)
            assert_true(off.mean > amplitude / 4);
        else
            assert_true(off.missing == 0 && off.far < off.pixels / 50 &&
                        off.mean < 0.02 * amplitude);
        frame_free(&frame);
    }
    direct_close(&direct);
    planar_close(&planar);
    depth_pixels_free(&image.front);
    gp_surface_destroy(&heights);
}

static void normals_lean_as_the_heights_do(void **state)
{
    (void)state;
    GpSurface *heights = make_heights();
    DepthImage image = flat_image();
    const WarpDetail detail = smooth(heights);
    double worst = 1, steepest = 1;
    assert_int_equal(warp_detail_lean(&image, &image.front, &detail, NULL), GP_OK);
    for (size_t i = 0; i < PICTURE * PICTURE; i++) {
        const double x = 2 * ((double)(i % PICTURE) + 0.5) / PICTURE - 1,
                     y = 1 - 2 * ((double)(i / PICTURE) + 0.5) / PICTURE, d = 1e-5;
        double normal[3] = {
            -amplitude * (height_at(x + d, y) - height_at(x - d, y)) / (2 * d),
            -amplitude * (height_at(x, y + d) - height_at(x, y - d)) / (2 * d),
            1,
        };
        const float *found = image.front.normal + 3 * i;
        vector_normalize(normal);
        const double cosine = normal[0] * (double)found[0] + normal[1] * (double)found[1] +
                              normal[2] * (double)found[2];
        worst = fmin(worst, i % PICTURE && i % PICTURE + 1 < PICTURE && i >= PICTURE &&
                                    i + PICTURE < PICTURE * PICTURE
                                ? cosine
                                : 1);
        steepest = fmin(steepest, normal[2]);
    }
    print_message("# cosines: %.6f at worst; normals lean to %.3f\n", worst, steepest);
    assert_true(worst > 0.999 && steepest < 0.85);
    depth_pixels_free(&image.front);
    gp_surface_destroy(&heights);
}

/* Copies so small that many texels fall on a vertex are read from a level that has their mean. */
static void small_copies_are_their_mean(void **state)
{
    (void)state;
    GpSurface *heights = make_heights();
    const DepthPixels pixels = { .width = PICTURE, .height = PICTURE };
    static const struct {
        double repeats;
        uint32_t step;
        float level;
    } rows[] = { { 1, 1, 0 }, { 2, 1, 0 }, { 2, 2, 1 }, { 8, 1, 2 }, { 8, 4, 4 }, { 999, 1, 6 } };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const WarpDetail detail = { heights, 1, { rows[i].repeats, 1 }, true };
        assert_true(warp_detail_uniforms(&detail, &pixels, rows[i].step).level == rows[i].level);
    }
    gp_surface_destroy(&heights);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(relief_is_that_of_rays_cast_at_its_heights),
        cmocka_unit_test(normals_lean_as_the_heights_do),
        cmocka_unit_test(small_copies_are_their_mean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
