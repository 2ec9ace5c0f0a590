/* Windows of pictures: the bits that the whole has there, whatever draws them. */
#include "apps/frame/window.h"
#include "apps/scene/scene.h"
#include "apps/techniques/shadow/shadowed.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <glob.h>
#include <stdio.h>
#include <string.h>

static GpResult load(const char *path, uint32_t width, uint32_t height, const GpRect *window,
                     Scene *scene, GpError *error)
{
    SceneOptions options = { .width = width, .height = height };
    if (window)
        options.window = *window;
    return shadowed_scene_load(path, &options, scene, error);
}

static void load_and_run(const char *path, uint32_t width, uint32_t height, const GpRect *window,
                         const GpDeviceDesc *device, Scene *scene)
{
    GpError error = { "" };
    if (load(path, width, height, window, scene, &error))
        fail_msg("%s", error.text);
    if (device)
        run_list_on(device, &scene->list);
    else
        run_list(&scene->list);
}

/* Texels of two surfaces inside a rectangle that both have. */
static void assert_same(const char *what, const GpSurface *a, const GpSurface *b,
                        const GpRect *rect)
{
    const size_t bytes = gp_format_info(a->format)->bytes;
    const size_t row = (size_t)(rect->x1 - rect->x0) * bytes;
    assert_int_equal(a->format, b->format);
    for (int32_t y = rect->y0; y < rect->y1; y++) {
        const uint32_t x = (uint32_t)rect->x0;
        if (memcmp(gp_surface_texel(&a->level[0], bytes, x, (uint32_t)y),
                   gp_surface_texel(&b->level[0], bytes, x, (uint32_t)y), row) != 0)
            fail_msg("%s: row %d of the window [%d, %d) x [%d, %d) has other bits", what, y,
                     rect->x0, rect->x1, rect->y0, rect->y1);
    }
}

enum { WIDTH = 300, HEIGHT = 260 };

static const GpRect windows[] = { { 128, 128, 256, HEIGHT }, { 256, 0, WIDTH, 128 } };

/* --- what is drawn ---------------------------------------------------------------------------- */

static void every_scene_by_windows(void **state)
{
    (void)state;
    glob_t scenes;
    assert_int_equal(glob("scenes/*.json", 0, NULL, &scenes), 0);
    for (size_t i = 0; i < scenes.gl_pathc; i++) {
        Scene whole, part;
        GpError error = { "" };
        if (load(scenes.gl_pathv[i], WIDTH, HEIGHT, NULL, &whole, &error)) {
            printf("# %s: skipped: %s\n", scenes.gl_pathv[i], error.text);
            continue;
        }
        run_list(&whole.list);
        for (size_t k = 0; k < GP_COUNT(windows); k++) {
            load_and_run(scenes.gl_pathv[i], WIDTH, HEIGHT, &windows[k], NULL, &part);
            assert_same(scenes.gl_pathv[i], whole.picture, part.picture, &windows[k]);
            scene_free(&part);
        }
        scene_free(&whole);
    }
    assert_true(scenes.gl_pathc > 20);
    globfree(&scenes);
}

static void windows_are_the_same_everywhere(void **state)
{
    (void)state;
    static const char *const scenes[] = { "scenes/point_sprites.json", "scenes/near_clip.json",
                                          "scenes/sorted.json", "scenes/points.json",
                                          "scenes/stencil_outline.json" };
    for (size_t i = 0; i < GP_COUNT(scenes); i++) {
        Scene whole, part;
        load_and_run(scenes[i], WIDTH, HEIGHT, NULL, device_here(0), &whole);
        for (size_t n = 0; device_here(n); n++) {
            load_and_run(scenes[i], WIDTH, HEIGHT, &windows[0], device_here(n), &part);
            assert_same(scenes[i], whole.picture, part.picture, &windows[0]);
            scene_free(&part);
        }
        scene_free(&whole);
    }
}

/* A window holds no more than its own texels, but where something is read beside its place. */
static void windows_have_their_texels_alone(void **state)
{
    (void)state;
    Scene part;
    const GpRect window = { 256, 0, 384, 128 };
    load_and_run("scenes/shadow.json", 8192, 8192, &window, NULL, &part);
    assert_false(gp_surface_is_whole(part.picture));
    assert_int_equal(part.picture->level[0].pitch, 128 * 4);
    scene_free(&part);
    GpError error = { "" };
    Scene whole;
    assert_int_equal(load("scenes/volume.json", 300, 260, &windows[1], &whole, &error), GP_OK);
    assert_true(gp_surface_is_whole(whole.picture)); /* rays read depth by its coordinates */
    scene_free(&whole);
}

/* --- larger than a target --------------------------------------------------------------------- */

enum { LARGE = GP_MAX_WHOLE };

static void the_last_pixels_of_the_largest_picture(void **state)
{
    (void)state;
    const char *path = "scenes/mip_maps.json";
    const GpRect corner = { LARGE - 128, LARGE - 128, LARGE, LARGE };
    const GpRect around = { LARGE - 256, LARGE - 256, LARGE, LARGE };
    Scene first, other;
    load_and_run(path, LARGE, LARGE, &around, device_here(0), &first);
    for (size_t n = 0; device_here(n); n++) {
        load_and_run(path, LARGE, LARGE, &corner, device_here(n), &other);
        assert_same(path, first.picture, other.picture, &corner);
        scene_free(&other);
    }
    /* the floor reaches the lower right corner: it is no background */
    float rgba[4], background[4] = { 0 };
    const GpRect last = { LARGE - 1, LARGE - 1, LARGE, LARGE };
    GpError error = { "" };
    assert_int_equal(gp_surface_read_floats(first.picture, 0, &last, rgba, &error), GP_OK);
    memcpy(background, first.background, sizeof background);
    assert_true(fabsf(rgba[0] - background[0]) > 0.01f || fabsf(rgba[1] - background[1]) > 0.01f);
    scene_free(&first);
}

/* --- what is refused -------------------------------------------------------------------------- */

static void wrong_windows_are_refused(void **state)
{
    (void)state;
    static const struct {
        GpRect window;
        uint32_t width, height;
        const char *reason;
    } wrong[] = {
        { { 64, 0, 128, 128 }, 256, 256, "multiples" },
        { { 0, 0, 200, 128 }, 256, 256, "multiples" },
        { { 0, 0, 384, 128 }, 256, 256, "inside" },
        { { 128, 0, 128, 128 }, 256, 256, "inside" },
        { { 0, 0, 16384, 128 }, 32768, 256, "within" },
        { { 0, 0, 128, 128 }, 40000, 256, "within" },
    };
    for (size_t i = 0; i < GP_COUNT(wrong); i++) {
        const GpSurfaceDesc desc = { .format = GP_A8R8G8B8,
                                     .width = wrong[i].width,
                                     .height = wrong[i].height,
                                     .window = wrong[i].window };
        GpSurface *surface = NULL;
        GpError error = { "" };
        assert_int_equal(gp_surface_create(&desc, &surface, &error), GP_ERROR_INVALID);
        assert_non_null(strstr(error.text, wrong[i].reason));
        assert_null(surface);
    }
}

static void too_large_to_be_read_elsewhere(void **state)
{
    (void)state;
    const GpRect window = { 0, 0, 128, 128 };
    Scene scene;
    GpError error = { "" };
    assert_int_equal(load("scenes/volume.json", 16384, 16384, &window, &scene, &error),
                     GP_ERROR_FORMAT);
    assert_non_null(strstr(error.text, "at most 8192x8192"));
}

static void a_window_around_a_rectangle(void **state)
{
    (void)state;
    const GpRect around = window_around((GpRect){ 130, 255, 257, 300 }, 300, 310);
    assert_true(gp_rect_equal(around, (GpRect){ 128, 128, 300, 310 }));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scene_by_windows),
        cmocka_unit_test(windows_are_the_same_everywhere),
        cmocka_unit_test(windows_have_their_texels_alone),
        cmocka_unit_test(the_last_pixels_of_the_largest_picture),
        cmocka_unit_test(wrong_windows_are_refused),
        cmocka_unit_test(too_large_to_be_read_elsewhere),
        cmocka_unit_test(a_window_around_a_rectangle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
