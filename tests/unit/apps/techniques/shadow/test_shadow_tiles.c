/* Adaptive shadow maps: finer tiles where the eye sees edges of shadows, held against cast rays. */
#include "apps/techniques/shadow/shadow.h"
#include "tests/support/scene_text.h"
#include "apps/truth/shadow_error.h"

#include <stdio.h>

enum { WIDTH = 256, HEIGHT = 160 };

/* --- scenes ----------------------------------------------------------------------------------- */

static const char sun[] = "\"direction\": [-0.75, 1, 0.25]";
static const char spot[] = "\"position\": [-6, 8, 3], \"at\": [0, 0, 0], "
                           "\"shadow\": { \"fovy\": 50 }";
static const char bulb[] = "\"position\": [-6, 8, 3]";

/* A floor with a knot, a ball and a block on it. */
static Scene load(const char *light)
{
    char text[1024];
    snprintf(text, sizeof text,
             "{ \"size\": [%d, %d], \"camera\": { \"eye\": [2, 3, 7], \"at\": [0, 0.6, 0], "
             "\"fovy\": 40, \"near\": 1, \"far\": 40 }, \"lights\": [ { %s } ], \"objects\": [ "
             "{ \"mesh\": \"builtin:knot\", \"transform\": { \"translate\": [0, 1.2, 0] } }, "
             "{ \"mesh\": \"builtin:ball\", \"transform\": { \"translate\": [-2.5, 1, -1] } }, "
             "{ \"mesh\": \"builtin:cube\", \"transform\": { \"scale\": 0.5, "
             "\"translate\": [2.5, 0.5, 0] } }, "
             "{ \"mesh\": \"builtin:plane\", \"transform\": { \"scale\": 12 } } ] }",
             WIDTH, HEIGHT, light);
    return load_scene(text);
}

static ShadowSetting setting_of(LightFit fit)
{
    return (ShadowSetting){ .method = SHADOW_HARDWARE,
                            .filter = SHADOW_BILINEAR,
                            .facing = SHADOW_FLAT,
                            .fit = fit,
                            .map = 128,
                            .slope = 2 };
}

static Frame build_with(const Scene *scene, ShadowKept *kept, const ShadowSetting *setting)
{
    Frame frame = { .color = NULL };
    GpError error = { "" };
    GpDevice *device;
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &device, &error), GP_OK);
    if (shadow_build(scene, kept, setting, device, &frame, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
    return frame;
}

static Frame build(const Scene *scene, const ShadowSetting *setting)
{
    return build_with(scene, NULL, setting);
}

static void draw(const Frame *frame, GpExecutor executor, int threads)
{
    GpDevice *device;
    GpError error = { "" };
    const GpDeviceDesc desc = { .executor = executor, .threads = threads };
    assert_int_equal(gp_device_create(&desc, &device, &error), GP_OK);
    if (gp_device_run(device, &frame->list, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
}

/* --- truth ------------------------------------------------------------------------------------ */

static ShadowTruth cast(const Scene *scene)
{
    const GpPass *pass = &scene->list.passes[0];
    const SceneLight *light = &scene->lights[0];
    uint32_t count = 0;
    for (uint32_t i = 0; i < pass->draw_count; i++)
        count += pass->draws[i].geometry.index_count / 3;
    TruthTriangle *triangles = calloc(count, sizeof *triangles);
    assert_non_null(triangles);
    count = 0;
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        const GpGeometry *geometry = &pass->draws[i].geometry;
        const GpStream *stream = &geometry->streams[GP_POSITION];
        for (uint32_t j = 0; j < geometry->index_count; j++) {
            float p[3];
            memcpy(p, (const char *)stream->data + (size_t)geometry->indices[j] * stream->stride,
                   sizeof p);
            for (int k = 0; k < 3; k++)
                triangles[count + j / 3].corner[j % 3][k] = (double)p[k];
        }
        count += geometry->index_count / 3;
    }
    ShadowView view = { .camera = scene->camera, .width = WIDTH, .height = HEIGHT };
    view.light.kind = light->directional ? TRUTH_DIRECTIONAL : TRUTH_POINT;
    memcpy(view.light.towards, light->position, sizeof view.light.towards);
    memcpy(view.light.position, light->position, sizeof view.light.position);
    TruthScene *truth_scene;
    ShadowTruth truth;
    assert_int_equal(truth_scene_create(triangles, count, &truth_scene), GP_OK);
    assert_int_equal(shadow_truth_cast(truth_scene, &view, &truth), GP_OK);
    truth_scene_destroy(&truth_scene);
    free(triangles);
    return truth;
}

static ShadowError error_of(const Scene *scene, const ShadowTruth *truth, LightFit fit)
{
    static float measured[WIDTH * HEIGHT];
    ShadowSetting setting = setting_of(fit);
    Frame frame = build(scene, &setting);
    draw(&frame, GP_EXECUTOR_FAST, 2);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const uint8_t *color = gp_surface_texel(frame.color->level, 4, i % WIDTH, i / WIDTH);
        float depth;
        memcpy(&depth, gp_surface_texel(frame.depth->level, 4, i % WIDTH, i / WIDTH), sizeof depth);
        measured[i] = depth < 1 ? (float)color[3] / 255 : SHADOW_NOTHING;
    }
    frame_free(&frame);
    return shadow_error(truth, measured, NULL);
}

/* --- facts ------------------------------------------------------------------------------------ */

static void tiles_bring_shadows_nearer_to_the_truth(void **state)
{
    (void)state;
    const char *const lights[] = { sun, spot };
    for (int i = 0; i < 2; i++) {
        Scene scene = load(lights[i]);
        ShadowTruth truth = cast(&scene);
        ShadowError base = error_of(&scene, &truth, LIGHT_FIT_CASTERS);
        ShadowError tiles = error_of(&scene, &truth, LIGHT_FIT_ADAPTIVE);
        assert_true(base.acne + base.leak > 50);
        assert_true(2 * (tiles.acne + tiles.leak) < base.acne + base.leak);
        assert_true(tiles.rmse < base.rmse);
        shadow_truth_free(&truth);
        scene_free(&scene);
    }
}

static void every_executor_draws_the_same(void **state)
{
    (void)state;
    Scene scene = load(spot);
    ShadowSetting setting = setting_of(LIGHT_FIT_ADAPTIVE);
    Frame frame = build(&scene, &setting), again = build(&scene, &setting);
    draw(&frame, GP_EXECUTOR_FAST, 3);
    draw(&again, GP_EXECUTOR_REFERENCE, 1);
    assert_true(gp_surface_hash(frame.color) == gp_surface_hash(again.color));
    frame_free(&frame);
    frame_free(&again);
    scene_free(&scene);
}

/* Twice through all fits: each is found, and then known; of two lights, which are not alike. */
static void what_is_kept_draws_the_same(void **state)
{
    (void)state;
    Scene scene = load("\"direction\": [-0.75, 1, 0.25] }, { \"position\": [6, 8, 3], "
                       "\"at\": [0, 0, 0], \"shadow\": { \"fovy\": 50 }");
    Frame memory = { .color = NULL };
    ShadowKept *kept = shadow_keep(&scene, &memory);
    assert_non_null(kept);
    for (int i = 0; i < 2 * (LIGHT_FIT_ADAPTIVE + 1); i++) {
        const ShadowSetting setting = setting_of((LightFit)(i % (LIGHT_FIT_ADAPTIVE + 1)));
        Frame frame = build_with(&scene, kept, &setting), fresh = build(&scene, &setting);
        draw(&frame, GP_EXECUTOR_FAST, 2);
        draw(&fresh, GP_EXECUTOR_FAST, 2);
        assert_true(gp_surface_hash(frame.color) == gp_surface_hash(fresh.color));
        frame_free(&frame);
        frame_free(&fresh);
    }
    frame_free(&memory);
    scene_free(&scene);
}

static void the_list_holds_what_the_tiles_cost(void **state)
{
    (void)state;
    static const char *const names[] = { "map", "request", "mark", "tiles", "lit" };
    Scene scene = load(sun);
    ShadowSetting setting = setting_of(LIGHT_FIT_ADAPTIVE);
    Frame frame = build(&scene, &setting);
    assert_int_equal(frame.list.pass_count, 5);
    for (int i = 0; i < 5; i++)
        assert_string_equal(frame.list.passes[i].name, names[i]);
    frame_free(&frame);
    scene_free(&scene);
}

static void every_light_has_its_tiles(void **state)
{
    (void)state;
    Scene scene = load("\"direction\": [-0.75, 1, 0.25] }, { \"position\": [6, 8, 3], "
                       "\"at\": [0, 0, 0], \"shadow\": { \"fovy\": 50 }");
    ShadowSetting setting = setting_of(LIGHT_FIT_ADAPTIVE);
    Frame frame = build(&scene, &setting);
    assert_int_equal(scene.light_count, 2);
    assert_int_equal(frame.list.pass_count, 10);
    const GpDraw *first = frame.list.passes[4].draws, *second = frame.list.passes[9].draws;
    for (int i = 1; i <= 3; i++)
        assert_true(first->textures[i].surface != second->textures[i].surface);
    draw(&frame, GP_EXECUTOR_FAST, 2);
    frame_free(&frame);
    scene_free(&scene);
}

static void without_edges_there_are_no_tiles(void **state)
{
    (void)state;
    Scene scene = load("\"direction\": [0, -1, 0]"); /* from below: the floor is all in the dark */
    ShadowSetting setting = setting_of(LIGHT_FIT_ADAPTIVE);
    Frame frame = build(&scene, &setting);
    assert_int_equal(frame.list.pass_count, 4);
    draw(&frame, GP_EXECUTOR_FAST, 1);
    frame_free(&frame);
    scene_free(&scene);
}

static void refuses_what_has_no_tiles(void **state)
{
    (void)state;
    const struct {
        const char *light, *reason;
        ShadowMethod method;
        ShadowFilter filter;
    } cases[] = { { sun, "the adaptive fit", SHADOW_PLAIN, SHADOW_BILINEAR },
                  { sun, "the adaptive fit", SHADOW_HARDWARE, SHADOW_NEAREST },
                  { bulb, "shines to all sides", SHADOW_HARDWARE, SHADOW_BILINEAR } };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        Scene scene = load(cases[i].light);
        ShadowSetting setting = setting_of(LIGHT_FIT_ADAPTIVE);
        setting.method = cases[i].method;
        setting.filter = cases[i].filter;
        setting.slope = 0;
        Frame frame = { .color = NULL };
        GpError error = { "" };
        assert_int_equal(shadow_build(&scene, NULL, &setting, NULL, &frame, &error),
                         GP_ERROR_INVALID);
        assert_non_null(strstr(error.text, cases[i].reason));
        assert_null(frame.color);
        scene_free(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tiles_bring_shadows_nearer_to_the_truth),
        cmocka_unit_test(every_executor_draws_the_same),
        cmocka_unit_test(what_is_kept_draws_the_same),
        cmocka_unit_test(the_list_holds_what_the_tiles_cost),
        cmocka_unit_test(every_light_has_its_tiles),
        cmocka_unit_test(without_edges_there_are_no_tiles),
        cmocka_unit_test(refuses_what_has_no_tiles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
