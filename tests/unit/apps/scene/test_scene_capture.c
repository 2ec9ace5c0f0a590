/* Scenes as depth images: distances that are known by hand, of both kinds of cameras and each depth
 * buffer; what cannot be captured is told. */
#include "apps/scene/capture.h"
#include "tests/support/devices.h"
#include "tests/support/scene_text.h"

#include <stdio.h>

static GpResult capture(const char *camera, const char *more, DepthImage *image, GpError *error)
{
    char text[2000];
    snprintf(text, sizeof text,
             "{ \"size\": [40, 20], \"background\": [0, 0, 1, 1], \"ambient\": [1, 1, 1],\n"
             "  \"camera\": { \"eye\": [0, 0, 5], \"at\": [0, 0, 0], %s },\n"
             "  %s \"objects\": [ { \"mesh\": \"builtin:quad\",\n"
             "    \"material\": { \"program\": \"unlit\", \"color\": [0, 1, 0, 1] } } ] }\n",
             camera, more);
    Scene scene = load_scene(text);
    GpDevice *device = device_open(&(GpDeviceDesc){ .threads = 1 });
    const GpResult result = scene_capture(device, &scene, false, image, error);
    gp_device_destroy(&device);
    scene_free(&scene);
    return result;
}

/* A square at z = 0, seen from z = 5. */
static void depths_are_distances_along_the_view(void **state)
{
    (void)state;
    static const struct {
        const char *camera, *more;
        double within;
    } rows[] = {
        { "\"fovy\": 40, \"near\": 1, \"far\": 20", "", 5e-6 },
        { "\"fovy\": 40, \"near\": 0.01, \"far\": 200", "", 5e-4 },
        { "\"fovy\": 40, \"near\": 1, \"far\": 20", "\"depth\": { \"format\": \"D32F\" },", 2e-6 },
        { "\"height\": 4, \"near\": 1, \"far\": 20", "", 5e-6 },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        DepthImage image;
        GpError error = { "" };
        if (capture(rows[i].camera, rows[i].more, &image, &error))
            fail_msg("%s", error.text);
        assert_true(image.front.width == 40 && image.front.height == 20 && image.front.normal);
        assert_true(image.plane.eye[2] == 5 && image.plane.is_parallel == (i == 3));
        const size_t middle = 10 * 40 + 20;
        if (fabs((double)image.front.depth[middle] - 5) > rows[i].within)
            fail_msg("%.9g", (double)image.front.depth[middle]);
        assert_true(image.front.color[3 * middle + 1] == 1 && image.front.color[3 * middle] == 0);
        assert_true(image.front.normal[3 * middle + 2] > 0.99F);
        assert_true(isinf(image.front.depth[0]) && isinf(image.front.depth[40 * 20 - 1]));
        depth_pixels_free(&image.front);
    }
}

static void scenes_without_one_view_or_depth_are_refused(void **state)
{
    (void)state;
    DepthImage image;
    GpError error = { "" };
    assert_int_equal(capture("\"fovy\": 40", "\"depth\": false,", &image, &error),
                     GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "without a depth buffer"));
    Scene scene = load_scene("{ \"passes\": [ { \"name\": \"a\" } ] }");
    assert_int_equal(scene_capture(NULL, &scene, false, &image, &error), GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "passes of its own"));
    scene_free(&scene);
}

/* Of three squares behind each other, the middle one of which shows its back, and a ball on the
 * right whose own back is no second layer. */
static void a_second_layer_is_what_faces_the_eye_behind_the_first(void **state)
{
    (void)state;
    static const char text[] =
        "{ \"size\": [60, 40], \"background\": [0, 0, 0, 0], \"ambient\": [1, 1, 1],\n"
        "  \"camera\": { \"eye\": [0, 0, 9], \"at\": [0, 0, 0], \"fovy\": 40, \"near\": 1, "
        "\"far\": 20 },\n"
        "  \"objects\": [\n"
        "  { \"mesh\": \"builtin:quad\", \"transform\": { \"translate\": [-1, 0, -2] },\n"
        "    \"material\": { \"program\": \"unlit\", \"color\": [0, 0, 1, 1] } },\n"
        "  { \"mesh\": \"builtin:quad\", \"transform\": { \"translate\": [-1, 0, 2] },\n"
        "    \"material\": { \"program\": \"unlit\", \"color\": [1, 0, 0, 1] } },\n"
        "  { \"mesh\": \"builtin:quad\", \"transform\": { \"rotate\": [0, 1, 0, 180],\n"
        "    \"translate\": [-1, 0, 0] },\n"
        "    \"material\": { \"program\": \"unlit\", \"color\": [0, 1, 0, 1] } },\n"
        "  { \"mesh\": \"builtin:ball\", \"transform\": { \"translate\": [2, 0, 0] },\n"
        "    \"material\": { \"program\": \"unlit\" } } ] }\n";
    Scene scene = load_scene(text);
    GpDevice *device = device_open(&(GpDeviceDesc){ .threads = 1 });
    DepthImage image;
    GpError error = { "" };
    if (scene_capture(device, &scene, true, &image, &error))
        fail_msg("%s", error.text);
    const size_t left = 20 * 60 + 23, right = 20 * 60 + 48;
    uint32_t front = 0, behind = 0;
    for (size_t i = 0; i < 60 * 40; i++) {
        front += isfinite(image.front.depth[i]) != 0;
        behind += isfinite(image.behind.depth[i]) != 0;
    }
    print_message("# %u pixels, %u behind; depths %g, %g\n", front, behind,
                  (double)image.front.depth[left], (double)image.behind.depth[left]);
    assert_true(fabs((double)image.front.depth[left] - 7) < 1e-4);
    assert_true(fabs((double)image.behind.depth[left] - 11) < 1e-4);
    assert_true(image.front.color[3 * left] == 1 && image.behind.color[3 * left + 2] == 1);
    assert_true(image.behind.color[3 * left] == 0 && image.behind.normal[3 * left + 2] > 0.99F);
    assert_true(isfinite(image.front.depth[right]) && isinf(image.behind.depth[right]));
    assert_true(behind > 50 && behind < front);
    depth_pixels_free(&image.front);
    depth_pixels_free(&image.behind);
    gp_device_destroy(&device);
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depths_are_distances_along_the_view),
        cmocka_unit_test(a_second_layer_is_what_faces_the_eye_behind_the_first),
        cmocka_unit_test(scenes_without_one_view_or_depth_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
