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
    const GpResult result = scene_capture(device, &scene, image, error);
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
    assert_int_equal(scene_capture(NULL, &scene, &image, &error), GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "passes of its own"));
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depths_are_distances_along_the_view),
        cmocka_unit_test(scenes_without_one_view_or_depth_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
