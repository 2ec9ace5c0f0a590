/* Splats under shadow maps: they cast and receive as the mesh does that they are sampled from. */
#include "apps/techniques/shadow/setting.h"
#include "apps/techniques/shadow/technique.h"
#include "tests/support/devices.h"
#include "tests/support/scene_text.h"
#include "tests/support/technique/technique_case.h"

#include <stdio.h>

enum { SIDE = 128 };

#define AT        "\"position\": [2, 4, 2], \"at\": [0, 0.5, 0]"
#define DIRECTION "\"direction\": [0.5, 1, 0.6]"

/* A ball over a floor, and a post whose shadow falls on it. in: the light, and the ball */
#define SCENE                                                                                      \
    "{ \"size\": [128, 128], \"camera\": { \"eye\": [0.6, 2.2, 4.5], \"at\": [0, 0.6, 0],"         \
    " \"fovy\": 40, \"near\": 1, \"far\": 12 }, \"lights\": [ { %s } ], \"objects\": ["            \
    " { \"mesh\": \"builtin:plane\", \"transform\": { \"scale\": 2.5 } },"                         \
    " { \"mesh\": \"builtin:cube\", \"transform\": { \"scale\": [0.06, 0.5, 0.06],"                \
    " \"translate\": [0.8, 1.6, 0.9] } },"                                                         \
    " { %s, \"transform\": { \"translate\": [0, 1.1, 0] } } ] }"
#define SPLATS "\"points\": \"builtin:sphere\", \"method\": \"ewa\""
#define MESH   "\"mesh\": \"builtin:sphere\""

static void *open_text(const char *text, GpError *error)
{
    char path[TEMPORARY_PATH];
    void *made = NULL;
    const TechniqueInput input = { .path = path, .setting = &shadow_defaults };
    put_temporary(text, strlen(text), path);
    const GpResult result = shadow_technique.open(&input, &made, error);
    unlink(path);
    return result ? NULL : made;
}

/* The frame refers to the stage; both belong to the caller. */
static TechniqueStage draw(const char *light, const char *ball, const GpDeviceDesc *device,
                           const char *options, Frame *frame)
{
    char text[2000];
    GpError error = { "" };
    snprintf(text, sizeof text, SCENE, light, ball);
    const TechniqueStage stage = { &shadow_technique, open_text(text, &error),
                                   device_open(device) };
    if (!stage.scene || technique_stage_draw(&stage, options, frame, &error))
        fail_msg("%s, %s: %s", ball, options, error.text);
    return stage;
}

/* Alpha is the visibility of the light; -1 where nothing is. */
static int visible_at(const Frame *frame, uint32_t i, uint32_t j)
{
    float depth;
    memcpy(&depth, gp_surface_texel(frame->depth->level, sizeof depth, i, j), sizeof depth);
    return depth < 1 ? gp_surface_texel(frame->color->level, 4, i, j)[3] > 127 : -1;
}

/* The silhouette of discs lies outside of the ball's by their radius squared over twice the ball's,
 * 0.0007, a texel of the map is 0.006 wide and a pixel 0.026: outlines move by less than a quarter
 * of a pixel, so that of the pixels along them at most a quarter changes sides. */
static void expect_alike(const char *light, const char *options)
{
    Frame splats = { .color = NULL }, mesh = { .color = NULL };
    int wrong = 0, outline = 0, dark = 0;
    TechniqueStage first = draw(light, SPLATS, device_here(1), options, &splats);
    TechniqueStage second = draw(light, MESH, device_here(1), options, &mesh);
    for (uint32_t j = 0; j + 1 < SIDE; j++)
        for (uint32_t i = 0; i + 1 < SIDE; i++) {
            const int here = visible_at(&mesh, i, j);
            outline += here != visible_at(&mesh, i + 1, j) || here != visible_at(&mesh, i, j + 1);
            wrong += here != visible_at(&splats, i, j);
            dark += here == 0;
        }
    print_message("# %s: %d pixels differ, %d along outlines, %d in shadow\n", options, wrong,
                  outline, dark);
    assert_true(outline > 300 && dark > 1000);
    assert_true(wrong <= outline / 4);
    frame_free(&splats);
    frame_free(&mesh);
    technique_stage_close(&first);
    technique_stage_close(&second);
}

static void a_splatted_ball_casts_and_receives_as_its_mesh_does(void **state)
{
    (void)state;
    static const char *const options[] = {
        "--facing smooth",
        "--facing smooth --filter nearest",
        "--facing smooth --method plain",
        "--facing smooth --method plain --filter nearest",
        "--facing smooth --casters near --depth d16",
        "--facing smooth --casters far",
        "--facing smooth --fit eye",
    };
    for (size_t i = 0; i < GP_COUNT(options); i++) {
        expect_alike(AT, options[i]);
        expect_alike(DIRECTION, options[i]);
    }
}

static void every_device_draws_the_same_shadows(void **state)
{
    (void)state;
    static const char *const options[] = { "", "--method plain",
                                           "--method plain --filter nearest" };
    for (size_t i = 0; i < GP_COUNT(options); i++) {
        uint64_t first = 0;
        for (size_t d = 0; device_here(d); d++) {
            Frame frame = { .color = NULL };
            TechniqueStage stage = draw(AT, SPLATS, device_here(d), options[i], &frame);
            const uint64_t hash = hash_targets(&frame.list);
            first = d == 0 ? hash : first;
            if (hash != first)
                fail_msg("%s: %s draws other bits", options[i], device_name(device_here(d)));
            frame_free(&frame);
            technique_stage_close(&stage);
        }
    }
}

static void what_splats_have_no_shadows_of_is_refused(void **state)
{
    (void)state;
    static const char *const rows[][3] = {
        { "{ \"lights\": [ { \"direction\": [0, 1, 0] }, { \"direction\": [1, 1, 0] } ], ", "",
          "splats have shadows under one light, and the scene has 2" },
        { "{ \"lights\": [ { \"position\": [0, 3, 0] } ], ", "",
          "splats have no shadows from a cube" },
        { "{ \"lights\": [ { \"position\": [0, 3, 0], \"at\": [0, 0, 1], \"size\": 1 } ], ",
          "--method plain --filter soft", "splats have no soft shadows" },
        { "{ ", "--fit adaptive", "splats have no shadows by the adaptive fit" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        char text[600];
        GpError error = { "" };
        Frame frame = { .color = NULL };
        snprintf(text, sizeof text, "%s\"objects\": [ { " SPLATS " } ] }", rows[i][0]);
        TechniqueStage stage = { &shadow_technique, open_text(text, &error),
                                 device_open(device_here(0)) };
        assert_non_null(stage.scene);
        assert_int_equal(technique_stage_draw(&stage, rows[i][1], &frame, &error),
                         GP_ERROR_INVALID);
        if (!strstr(error.text, rows[i][2]))
            fail_msg("'%s' instead of '%s'", error.text, rows[i][2]);
        technique_stage_close(&stage);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_splatted_ball_casts_and_receives_as_its_mesh_does),
        cmocka_unit_test(every_device_draws_the_same_shadows),
        cmocka_unit_test(what_splats_have_no_shadows_of_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
