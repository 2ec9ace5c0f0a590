/* Depth images of scenes: in their place, like the meshes that they were captured of, hiding and
 * hidden, under shadows; and refused with a reason. */
#include "apps/depth_images/depth_file.h"
#include "apps/techniques/shadow/technique.h"
#include "tests/support/depth/depth_shapes.h"
#include "tests/support/devices.h"
#include "tests/support/scene_text.h"

#include <math.h>
#include <stdio.h>

enum { SIDE = 96 };

#define BALL "\"depth_image\": \"builtin:sphere\", \"pixels\": [128, 128]"
#define SCENE(camera, objects)                                                                     \
    "{ \"size\": [96, 96], \"background\": [0, 0, 0, 1], \"lights\": [ { \"direction\": [0.3, "    \
    "0.5, 1] } ],\n  \"camera\": { " camera " },\n  \"objects\": [ " objects " ] }"
#define NEAR_EYE "\"eye\": [2, 2, 4], \"at\": [0, 0, 0], \"fovy\": 40, \"near\": 1, \"far\": 20"

static void draw(const char *text, float rgba[SIDE * SIDE][4])
{
    Scene scene = load_scene(text);
    run_list(&scene.list);
    assert_int_equal(gp_surface_read_floats(scene.picture, 0, NULL, &rgba[0][0], NULL), GP_OK);
    scene_free(&scene);
}

/* Root of the mean square difference of two pictures, of 255, and how many pixels the first
 * covers. */
static double difference(const char *one, const char *other, uint32_t *covered)
{
    static float a[SIDE * SIDE][4], b[SIDE * SIDE][4];
    double sum = 0;
    draw(one, a);
    draw(other, b);
    *covered = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        *covered += a[i][0] + a[i][1] + a[i][2] > 0;
        for (int c = 0; c < 3; c++)
            sum += pow((double)a[i][c] - (double)b[i][c], 2);
    }
    return 255 * sqrt(sum / (3.0 * SIDE * SIDE));
}

static void an_image_looks_like_its_mesh(void **state)
{
    (void)state;
    static const char *const shapes[] = { "sphere", "cube", "torus" };
    for (size_t i = 0; i < GP_COUNT(shapes); i++) {
        char text[2][600];
        uint32_t covered;
        for (int k = 0; k < 2; k++)
            snprintf(text[k], sizeof text[k],
                     SCENE(NEAR_EYE,
                           "{ \"%s\": \"builtin:%s\", \"transform\": { \"rotate\": [0, 1, "
                           "0, 25] }, \"fit\": [0, -1, 0, 2], \"material\": { "
                           "\"diffuse\": [0.8, 0.5, 0.3] } }"),
                     k ? "mesh" : "depth_image", shapes[i]);
        const double off = difference(text[0], text[1], &covered);
        print_message("# %s: %.2f of 255, %u pixels\n", shapes[i], off, covered);
        assert_true(covered > 1000);
        assert_true(off < 10);
    }
}

/* The world turned about y by a quarter, half as large, and moved: (x, y, z) is at
 * (z / 2 + 7, y / 2 - 3, 2 - x / 2). */
static void an_image_and_its_camera_move_together(void **state)
{
    (void)state;
    uint32_t covered;
#define LIT                                                                                        \
    "\"material\": { \"diffuse\": [0, 0, 0], \"ambient\": [0.5, 0.5, 0.5], \"specular\": 0 }"
    const double off = difference(
        SCENE(NEAR_EYE, "{ " BALL ", " LIT " }"),
        SCENE("\"eye\": [9, -2, 1], \"at\": [7, -3, 2], \"fovy\": 40, \"near\": 0.5, \"far\": 10",
              "{ " BALL ", " LIT ", \"transform\": { \"scale\": 0.5, \"rotate\": [0, 1, 0, 90], "
              "\"translate\": [7, -3, 2] } }"),
        &covered);
    assert_true(covered > 1000);
    assert_true(off < 1);
}

static void meshes_and_images_hide_each_other(void **state)
{
    (void)state;
#define WALL(z)                                                                                    \
    "{ \"mesh\": \"builtin:cube\", \"transform\": { \"scale\": [3, 3, 0.01], \"translate\": [0, "  \
    "0, " #z "] }, \"material\": { \"program\": \"unlit\", \"color\": [0.2, 0, 0, 1] } }"
#define AHEAD "\"eye\": [0, 0, 5], \"at\": [0, 0, 0], \"fovy\": 40, \"near\": 1, \"far\": 20"
    uint32_t covered;
    assert_true(difference(SCENE(AHEAD, WALL(1.5)), SCENE(AHEAD, WALL(1.5) ", { " BALL " }"),
                           &covered) == 0);
    const double half =
        difference(SCENE(AHEAD, WALL(0.7)), SCENE(AHEAD, WALL(0.7) ", { " BALL " }"), &covered);
    const double whole =
        difference(SCENE(AHEAD, WALL(-2)), SCENE(AHEAD, WALL(-2) ", { " BALL " }"), &covered);
    print_message("# %.1f of 255 half behind a wall, %.1f before it\n", half, whole);
    assert_true(half > 5 && whole > half + 5);
}

/* Visibility of the light at each pixel, as the technique has it in alpha; 0 where nothing is. */
static void draw_shadows(const char *shape, float rgba[SIDE * SIDE][4])
{
    char text[700], path[TEMPORARY_PATH];
    GpError error = { "" };
    void *scene;
    Frame frame = { .color = NULL };
    snprintf(
        text, sizeof text,
        "{ \"size\": [96, 96], \"camera\": { \"eye\": [1, 3, 5], \"at\": [0, 0.5, 0], \"fovy\": "
        "45, \"near\": 1, \"far\": 20 }, \"lights\": [ { \"direction\": [1, 1.2, 0.4], \"at\": "
        "[0, 0, 0] } ], \"objects\": [ { \"mesh\": \"builtin:disc\", \"transform\": { "
        "\"scale\": 3 } }, { \"%s\": \"builtin:sphere\", \"fit\": [0, 0.3, 0, 1.2] } ] }",
        shape);
    put_temporary(text, strlen(text), path);
    GpDevice *device = device_open(&(GpDeviceDesc){ .threads = 2 });
    if (technique_open(&shadow_technique, path, 0, 0, &scene, &error) ||
        technique_build(&shadow_technique, scene, "--map 512", device, &frame, &error) ||
        gp_device_run(device, &frame.list, &error) ||
        gp_surface_read_floats(frame.color, 0, NULL, &rgba[0][0], &error))
        fail_msg("%s", error.text);
    unlink(path);
    frame_free(&frame);
    shadow_technique.close(scene);
    gp_device_destroy(&device);
}

static void images_cast_and_receive_shadows(void **state)
{
    (void)state;
    static float mesh[SIDE * SIDE][4], image[SIDE * SIDE][4];
    uint32_t dark = 0, lit = 0, off = 0;
    draw_shadows("mesh", mesh);
    draw_shadows("depth_image", image);
    for (int i = 0; i < SIDE * SIDE; i++) {
        lit += mesh[i][3] > 0.5f;
        dark += mesh[i][3] < 0.5f && mesh[i][0] + mesh[i][1] + mesh[i][2] > 0;
        off += fabsf(mesh[i][3] - image[i][3]) > 0.5f;
    }
    print_message("# %u pixels lit, %u in the dark, %u otherwise of the image\n", lit, dark, off);
    assert_true(dark > 250 && lit > 1000 && off < 40);
}

/* A planar image from a file, at the place that it was taken of. */
static void files_are_read_beside_the_scene(void **state)
{
    (void)state;
    char path[TEMPORARY_PATH + 8], text[600];
    DepthShape shape = depth_shape_vase();
    DepthModel model = depth_shape_capture(&shape, 96, 64, 32, true);
    GpError error = { "" };
    static float rgba[SIDE * SIDE][4];
    uint32_t covered = 0;
    put_temporary("", 0, path);
    unlink(path);
    strcat(path, ".exr");
    const GpResult result = depth_file_write(path, &model, &error);
    depth_model_free(&model);
    depth_shape_close(&shape);
    if (result == GP_ERROR_UNSUPPORTED)
        skip();
    assert_int_equal(result, GP_OK);
    snprintf(text, sizeof text, SCENE(NEAR_EYE, "{ \"depth_image\": \"%s\" }"), path);
    draw(text, rgba);
    unlink(path);
    for (int i = 0; i < SIDE * SIDE; i++)
        covered += rgba[i][0] + rgba[i][1] + rgba[i][2] > 0;
    assert_true(covered > 1000);
}

static void what_is_wrong_is_refused_with_its_place(void **state)
{
    (void)state;
    static const RefusedObject rows[] = {
        { "\"depth_image\": \"builtin:cat\"", ": objects[0].depth_image: " },
        { "\"depth_image\": \"nowhere.exr\"", ": objects[0].depth_image: " },
        { "\"depth_image\": 3", ": objects[0].depth_image: expected a string" },
        { BALL ", \"mesh\": \"builtin:cube\"",
          ": objects[0]: expected a mesh, points, a volume or a depth image" },
        { "\"depth_image\": \"builtin:cube\", \"pixels\": [4, 4]", ": objects[0].pixels" },
        { BALL ", \"color\": [1, 1, 1, 1]",
          ": objects[0].color: depth images have none of their own" },
        { BALL ", \"lit\": true", ": objects[0].lit: of volumes: expected a volume" },
        { BALL ", \"material\": { \"textures\": [ { \"image\": \"builtin:uv\" } ] }",
          ": objects[0].material.textures: program mapped_phong reads no texture" },
        { BALL ", \"transform\": { \"scale\": [1, 2, 1] }",
          ": objects[0].transform: depth images keep their shape: expected one scale above 0" },
        { BALL ", \"transform\": { \"scale\": [-1, -1, -1] }",
          ": objects[0].transform: depth images keep their shape: expected one scale above 0" },
    };
    check_refused_objects(rows, GP_COUNT(rows));
}

static void memory_that_runs_short_is_said(void **state)
{
    (void)state;
    static const char text[] = SCENE(NEAR_EYE, "{ \"depth_image\": \"builtin:cube\", \"pixels\": "
                                               "[16, 16] }");
    check_short_memory(text, 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_image_looks_like_its_mesh),
        cmocka_unit_test(an_image_and_its_camera_move_together),
        cmocka_unit_test(meshes_and_images_hide_each_other),
        cmocka_unit_test(images_cast_and_receive_shadows),
        cmocka_unit_test(files_are_read_beside_the_scene),
        cmocka_unit_test(what_is_wrong_is_refused_with_its_place),
        cmocka_unit_test(memory_that_runs_short_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
