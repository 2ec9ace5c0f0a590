/* Depth images of pictures: planes whose depths are known, cameras that make no sense, steps of 8
 * bits, height maps; and, where the data is, two views of one room that must tell of the same
 * walls. */
#include "apps/base/vector.h"
#include "apps/depth_images/making/height_map.h"
#include "apps/depth_images/making/rgbd.h"
#include "pipeline/io/file.h"
#include "pipeline/io/image/image_file.h"
#include "tests/support/folder.h"
#include "tests/support/unit.h"

enum { W = 40, H = 30 };

static const char camera_text[] =
    "{ \"intrinsics\": { \"fx\": 50, \"fy\": 60, \"cx\": 18.5, \"cy\": 14 }, \"depth_unit_m\": "
    "0.01,\n"
    "  \"camera_axes\": \"x right, y down, z forward\",\n"
    "  \"frames\": { \"a\": { \"camera_to_world\":\n"
    "    [[0, 0, 1, 5], [1, 0, 0, 6], [0, 1, 0, 7], [0, 0, 0, 1]] } } }\n";

static RgbdCamera read_camera(void)
{
    RgbdCamera camera;
    GpError error = { "" };
    if (rgbd_camera_read(put_text("camera.json", camera_text), NULL, &camera, &error))
        fail_msg("%s", error.text);
    return camera;
}

static const char *put_image(const char *name, uint32_t width, uint32_t height, uint32_t channels,
                             GpImageType type, void *data)
{
    const GpImage image = { width, height, channels, type, data };
    GpError error = { "" };
    const char *path = in_folder(name);
    if (gp_image_write(path, &image, NULL, &error))
        fail_msg("%s", error.text);
    return path;
}

/* x right is the world's y, y down its z, z forward its x. */
static void pixels_are_where_the_lens_sees_them(void **state)
{
    (void)state;
    const RgbdCamera camera = read_camera();
    const DepthPlane plane = rgbd_plane(&camera, W, H);
    const DepthPixels pixels = { .width = W, .height = H };
    static const int places[][2] = { { 0, 0 }, { 39, 0 }, { 18, 14 }, { 7, 29 } };
    assert_true(!plane.is_parallel && camera.unit == 0.01);
    for (size_t i = 0; i < GP_COUNT(places); i++) {
        double point[3];
        depth_plane_point(&plane, &pixels, places[i][0] + 0.5, places[i][1] + 0.5, 2, point);
        assert_true(fabs(point[0] - 5 - 2) < 1e-12);
        assert_true(fabs(point[1] - 6 - 2 * (places[i][0] - 18.5) / 50) < 1e-12);
        assert_true(fabs(point[2] - 7 - 2 * (places[i][1] - 14.0) / 60) < 1e-12);
    }
}

/* A wall that leans: depths of 16 bits, of which one is nothing; its normal is found, and colours
 * are kept. */
static void depths_are_codes_times_the_unit_and_0_is_nothing(void **state)
{
    (void)state;
    const RgbdCamera camera = read_camera();
    uint16_t codes[W * H];
    uint8_t colors[3 * W * H];
    for (int i = 0; i < W * H; i++) {
        /* z = 300 + 0.5 x across: z (1 - 0.5 (i - cx) / fx) = 300 */
        codes[i] = (uint16_t)(30000 / (1 - 0.5 * (i % W - 18.5) / 50) / 100 * 100 + 0.5);
        for (int k = 0; k < 3; k++)
            colors[3 * i + k] = (uint8_t)(i + k);
    }
    codes[77] = 0;
    char color[400], depth[400];
    strcpy(color, put_image("a.ppm", W, H, 3, GP_IMAGE_U8, colors));
    strcpy(depth, put_image("a.pgm", W, H, 1, GP_IMAGE_U16, codes));
    DepthImage image;
    GpError error = { "" };
    if (rgbd_read(color, depth, &camera, &image, &error))
        fail_msg("%s", error.text);
    for (uint32_t i = 0; i < W * H; i++) {
        if (i == 77) {
            assert_true(isinf(image.front.depth[i]));
            continue;
        }
        assert_true(image.front.depth[i] == (float)(codes[i] * 0.01));
        assert_true(image.front.color[3 * i + 1] == (float)((i + 1) & 255) / 255);
    }
    /* Towards the camera, and leaning: across (-0.5, 1) to the wall's way (1, 0.5). */
    const float *normal = image.front.normal + 3 * (15 * W + 20);
    assert_true(fabs((double)normal[0] + 1 / sqrt(1.25)) < 0.01);
    assert_true(fabs((double)normal[1] - 0.5 / sqrt(1.25)) < 0.01 &&
                fabs((double)normal[2]) < 0.01);
    depth_pixels_free(&image.front);
}

/* Of a ramp of 400 depths 8 bits keep 101, with steps between them; 16 keep all. */
static void eight_bits_keep_stairs_and_sixteen_a_slope(void **state)
{
    (void)state;
    static uint16_t fine[400];
    static uint8_t coarse[400], colors[1200];
    for (int i = 0; i < 400; i++) {
        fine[i] = (uint16_t)(25600 + 64 * i);
        coarse[i] = (uint8_t)(fine[i] / 256);
    }
    RgbdCamera camera = read_camera();
    char color[400], path[400];
    strcpy(color, put_image("a.ppm", 400, 1, 3, GP_IMAGE_U8, colors));
    uint32_t equal[2] = { 0 };
    for (int bits = 0; bits < 2; bits++) {
        DepthImage image;
        GpError error = { "" };
        strcpy(path, put_image("a.pgm", 400, 1, 1, bits ? GP_IMAGE_U16 : GP_IMAGE_U8,
                               bits ? (void *)fine : coarse));
        camera.unit = bits ? 1.0 / 256 : 1;
        if (rgbd_read(color, path, &camera, &image, &error))
            fail_msg("%s", error.text);
        for (int i = 1; i < 400; i++)
            equal[bits] += image.front.depth[i] == image.front.depth[i - 1];
        assert_true(fabsf(image.front.depth[399] - image.front.depth[0] - 99.75F) < 0.8F);
        depth_pixels_free(&image.front);
    }
    assert_int_equal(equal[0], 300);
    assert_int_equal(equal[1], 0);
}

static void cameras_that_make_no_sense_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *from, *to, *expected;
    } rows[] = {
        { "\"fx\": 50, ", "", "intrinsics.fx: " },
        { "\"fy\": 60", "\"fy\": 0", "intrinsics.fy: expected a number" },
        { "y down", "y up", "camera_axes: expected \"x right, y down, z forward\"" },
        { "\"a\": {", "\"a\": 7, \"b\": {", "frames: expected one frame" },
        { "[0, 0, 1, 5], ", "", "camera_to_world: expected four rows" },
        { "[0, 0, 1, 5]", "[0, 0, -1, 5]", "camera_to_world: expected a turn" },
        { "[1, 0, 0, 6]", "[2, 0, 0, 6]", "camera_to_world: expected a turn" },
        { "0.01", "-1", "depth_unit_m: expected a number" },
        { "\"cx\"", "\"cz\"", "intrinsics.cx" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        char text[1000];
        const char *at = strstr(camera_text, rows[i].from);
        assert_non_null(at);
        snprintf(text, sizeof text, "%.*s%s%s", (int)(at - camera_text), camera_text, rows[i].to,
                 at + strlen(rows[i].from));
        RgbdCamera camera = { .fx = 77 };
        GpError error = { "" };
        const GpResult result = rgbd_camera_read(put_text("c.json", text), NULL, &camera, &error);
        if (result != GP_ERROR_FORMAT || !strstr(error.text, rows[i].expected) || camera.fx != 77)
            fail_msg("\"%s\" instead of \"%s\"", error.text, rows[i].expected);
    }
    RgbdCamera camera;
    GpError error = { "" };
    put_text("c.json", camera_text);
    assert_int_equal(rgbd_camera_read(in_folder("c.json"), "b", &camera, &error), GP_ERROR_FORMAT);
    assert_non_null(strstr(error.text, "frames.b"));
}

static void pictures_that_do_not_agree_are_refused(void **state)
{
    (void)state;
    const RgbdCamera camera = read_camera();
    static uint8_t bytes[3 * W * H];
    char color[400], depth[400];
    DepthImage image;
    GpError error = { "" };
    strcpy(color, put_image("a.ppm", W, H, 3, GP_IMAGE_U8, bytes));
    strcpy(depth, put_image("a.pgm", W, H - 1, 1, GP_IMAGE_U8, bytes));
    assert_int_equal(rgbd_read(color, depth, &camera, &image, &error), GP_ERROR_FORMAT);
    assert_non_null(strstr(error.text, "a.pgm: 40x29 pixels; "));
    assert_int_equal(rgbd_read(color, color, &camera, &image, &error), GP_ERROR_FORMAT);
    assert_non_null(strstr(error.text, "3 channels; expected depths alone"));
    float below = -1;
    strcpy(color, put_image("b.ppm", 1, 1, 3, GP_IMAGE_U8, bytes));
    strcpy(depth, put_image("b.pfm", 1, 1, 1, GP_IMAGE_F32, &below));
    assert_int_equal(rgbd_read(color, depth, &camera, &image, &error), GP_ERROR_FORMAT);
    assert_non_null(strstr(error.text, "pixel (0, 0): expected a depth from 0 on"));
    assert_int_equal(rgbd_read(color, in_folder("none.pgm"), &camera, &image, &error), GP_ERROR_IO);
}

/* --- height maps ------------------------------------------------------------------------------ */

/* A ramp to the right, with and without normals of its own; colours of twice the size. */
static void height_maps_are_reliefs_about_the_origin(void **state)
{
    (void)state;
    uint8_t map[8 * 4 * 4], grey[8 * 4], colors[16 * 8 * 3];
    for (int i = 0; i < 32; i++) {
        grey[i] = map[4 * i + 3] = (uint8_t)(30 * (i % 8));
        map[4 * i] = 255;
        map[4 * i + 1] = map[4 * i + 2] = 128;
    }
    for (int i = 0; i < 16 * 8; i++)
        for (int k = 0; k < 3; k++)
            colors[3 * i + k] = (uint8_t)(i % 16 * 10);
    char color[400], paths[2][400];
    strcpy(color, put_image("c.ppm", 16, 8, 3, GP_IMAGE_U8, colors));
    strcpy(paths[0], put_image("map.png", 8, 4, 4, GP_IMAGE_U8, map));
    strcpy(paths[1], put_image("grey.pgm", 8, 4, 1, GP_IMAGE_U8, grey));
    for (int own = 0; own < 2; own++) {
        DepthImage image;
        GpError error = { "" };
        if (height_map_read(color, paths[own], 2, 0.5, &image, &error))
            fail_msg("%s", error.text);
        assert_true(image.plane.is_parallel && image.plane.height == 1);
        for (uint32_t i = 0; i < 32; i++) {
            double point[3];
            depth_plane_point(&image.plane, &image.front, i % 8 + 0.5, i / 8 + 0.5,
                              (double)image.front.depth[i], point);
            assert_true(fabs(point[0] - ((i % 8 + 0.5) / 4 - 1)) < 1e-7);
            assert_true(fabs(point[1] - (0.5 - (i / 8 + 0.5) / 4)) < 1e-7);
            assert_true(fabs(point[2] - 0.5 * 30 * (i % 8) / 255) < 1e-7);
            assert_true(fabs((double)image.front.color[3 * i] - (20 * (i % 8) + 5) / 255.0) < 1e-6);
        }
        /* Own ones lean to +x; found ones are square to the ramp, which rises by 0.0588 every
         * 0.25. */
        const double slope = 0.5 * 30 / 255 / 0.25;
        const float *n = image.front.normal + 3 * 11;
        if (own == 0)
            assert_true(n[0] > 0.99F);
        else
            assert_true(fabs((double)n[0] + slope / sqrt(1 + slope * slope)) < 1e-6 && n[2] > 0.9F);
        depth_pixels_free(&image.front);
    }
    GpError error = { "" };
    DepthImage image;
    assert_int_equal(height_map_read(color, in_folder("none.tga"), 2, 0.5, &image, &error),
                     GP_ERROR_IO);
}

/* What is no number is at the ground, as all depths are finite. */
static void heights_that_are_no_numbers_are_the_ground(void **state)
{
    (void)state;
    float heights[4] = { 0.25f, (float)NAN, -(float)NAN, (float)INFINITY };
    uint8_t white[12] = { 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255 };
    char color[400], map[400];
    strcpy(color, put_image("w.ppm", 2, 2, 3, GP_IMAGE_U8, white));
    strcpy(map, put_image("nan.exr", 2, 2, 1, GP_IMAGE_F32, heights));
    DepthImage image;
    GpError error = { "" };
    if (height_map_read(color, map, 2, 0.5, &image, &error))
        fail_msg("%s", error.text);
    const float expected[4] = { 0.375f, 0.5f, 0.5f, 0 };
    for (int i = 0; i < 4; i++)
        assert_true(image.front.depth[i] == expected[i]);
    depth_pixels_free(&image.front);
}

/* --- two views of one room -------------------------------------------------------------------- */

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool read_room(const char *number, DepthImage *image)
{
    char name[3][80], path[3][400];
    RgbdCamera camera;
    GpError error = { "" };
    snprintf(name[0], sizeof name[0], "images/livingroom_%02d_color.ppm", atoi(number));
    snprintf(name[1], sizeof name[1], "images/livingroom_%02d_depth.pgm", atoi(number));
    snprintf(name[2], sizeof name[2], "images/livingroom_cameras.json");
    for (int i = 0; i < 3; i++)
        if (gp_data_find(name[i], path[i], sizeof path[i], &error))
            return false;
    if (rgbd_camera_read(path[2], number, &camera, &error) ||
        rgbd_read(path[0], path[1], &camera, image, &error))
        fail_msg("%s", error.text);
    return true;
}

static void two_views_of_a_room_tell_of_the_same_walls(void **state)
{
    (void)state;
    DepthImage from, to;
    if (!read_room("0", &from))
        skip();
    assert_true(read_room("40", &to));
    const uint32_t w = from.front.width, h = from.front.height;
    double *errors = gp_alloc((size_t)w * h, sizeof *errors);
    size_t count = 0;
    for (uint32_t i = 0; i < w * h; i++) {
        double point[3], place[2], depth;
        if (isinf(from.front.depth[i]))
            continue;
        depth_plane_point(&from.plane, &from.front, i % w + 0.5, i / w + 0.5,
                          (double)from.front.depth[i], point);
        if (!depth_plane_place(&to.plane, &to.front, point, place, &depth) || !(place[0] >= 0) ||
            !(place[1] >= 0) || place[0] >= w || place[1] >= h)
            continue;
        const float there = to.front.depth[(size_t)place[1] * w + (size_t)place[0]];
        if (isfinite(there))
            errors[count++] = fabs(depth - (double)there);
    }
    qsort(errors, count, sizeof *errors, ascending);
    const double median = errors[count / 2];
    print_message("# %zu pixels seen by both, median error of depth %.2f mm\n", count,
                  1000 * median);
    assert_true(count > w * h / 3 && median < 0.0025 && median > 0.001);
    gp_free(errors);
    depth_pixels_free(&from.front);
    depth_pixels_free(&to.front);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(pixels_are_where_the_lens_sees_them),
        TEST(depths_are_codes_times_the_unit_and_0_is_nothing),
        TEST(eight_bits_keep_stairs_and_sixteen_a_slope),
        TEST(cameras_that_make_no_sense_are_refused),
        TEST(pictures_that_do_not_agree_are_refused),
        TEST(height_maps_are_reliefs_about_the_origin),
        TEST(heights_that_are_no_numbers_are_the_ground),
        TEST(two_views_of_a_room_tell_of_the_same_walls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
