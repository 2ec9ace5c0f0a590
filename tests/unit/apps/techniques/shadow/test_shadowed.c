/* Scenes under shadows that have more than what casts them: volumes, and what is blended; and
 * scenes that ask for shadows themselves. */
#include "apps/techniques/shadow/setting.h"
#include "apps/techniques/shadow/shadowed.h"
#include "apps/techniques/shadow/technique.h"
#include "tests/support/devices.h"
#include "tests/support/scene_text.h"
#include "tests/support/technique/technique_case.h"

#include <math.h>
#include <stdio.h>

enum { SIDE = 96 };

typedef uint8_t Picture[SIDE * SIDE][4]; /* blue, green, red, alpha */

/* A post whose shadow falls on a floor. in: background, more keys, more objects */
#define SCENE                                                                                      \
    "{ \"size\": [96, 96], \"background\": [%d, %d, %d, 1], \"camera\": { \"eye\": [0.6, 2.2, "    \
    "4.5], \"at\": [0, 0.4, 0], \"fovy\": 40, \"near\": 1, \"far\": 12 },"                         \
    " \"lights\": [ { \"direction\": [0.5, 1, 0.6] } ],%s \"objects\": [ %s"                       \
    " { \"mesh\": \"builtin:plane\", \"transform\": { \"scale\": 2.5 } },"                         \
    " { \"mesh\": \"builtin:cube\", \"transform\": { \"scale\": [0.2, 0.5, 0.2],"                  \
    " \"translate\": [0.8, 0.5, 0.9] } } ] }"
#define GLASS(share)                                                                               \
    "{ \"name\": \"glass\", \"mesh\": \"builtin:ball\", \"transform\": { \"scale\": 0.5,"          \
    " \"translate\": [-0.3, 0.8, 0.3] }, \"state\": { \"cull\": \"cw\", \"depth\": { \"write\": "  \
    "false }, \"blend\": { \"op\": \"add\", \"src\": \"constant\", \"dst\": \"inv-constant\" },"   \
    " \"blend_constant\": [" share ", " share ", " share ", 1] } },"
#define CLOUD                                                                                      \
    "{ \"volume\": \"builtin:ball:16\", \"transfer\": \"fog\", \"fit\": [0.2, -0.2, 0.4, 1.6] },"

#define SORTED " \"order\": \"depth\","

static void write_scene(const char *keys, const char *objects, int grey, char path[TEMPORARY_PATH])
{
    char text[3000];
    snprintf(text, sizeof text, SCENE, grey, grey, grey, keys, objects);
    put_temporary(text, strlen(text), path);
}

static TechniqueStage open_stage(const char *keys, const char *objects, const GpDeviceDesc *device)
{
    char path[TEMPORARY_PATH];
    GpError error = { "" };
    TechniqueStage stage = { &shadow_technique, NULL, device_open(device) };
    const TechniqueInput input = { .path = path, .setting = &shadow_defaults };
    write_scene(keys, objects, 0, path);
    if (shadow_technique.open(&input, &stage.scene, &error))
        fail_msg("%s", error.text);
    unlink(path);
    return stage;
}

static void read_picture(const GpSurface *picture, Picture pixels)
{
    assert_true(picture->format == GP_A8R8G8B8 && picture->width == SIDE);
    memcpy(pixels, picture->level[0].texels, sizeof(Picture));
}

/* By `glasspipe shadow`. */
static void draw(const char *keys, const char *objects, Picture pixels)
{
    Frame frame = { .color = NULL };
    GpError error = { "" };
    TechniqueStage stage = open_stage(keys, objects, device_here(1));
    if (technique_stage_draw(&stage, "", &frame, &error))
        fail_msg("%s", error.text);
    read_picture(frame.color, pixels);
    frame_free(&frame);
    technique_stage_close(&stage);
}

/* By `glasspipe render`. */
static void render(const char *keys, const char *objects, int grey, Picture pixels)
{
    char path[TEMPORARY_PATH];
    Scene scene = { .picture = NULL };
    GpError error = { "" };
    write_scene(keys, objects, grey, path);
    if (shadowed_scene_load(path, NULL, &scene, &error))
        fail_msg("%s", error.text);
    unlink(path);
    run_list(&scene.list);
    read_picture(scene.picture, pixels);
    scene_free(&scene);
}

/* Glass by three quarters is three parts of the picture without it and one of where it is whole:
 * its shadow is nowhere, and the shadows behind it are as they were. Alpha is theirs. */
static void what_is_blended_lies_over_shadows_and_casts_none(void **state)
{
    (void)state;
    static Picture none, whole, glass;
    int covered = 0, dark = 0;
    draw(SORTED, "", none);
    draw(SORTED, GLASS("1"), whole);
    draw(SORTED, GLASS("0.25"), glass);
    for (int i = 0; i < SIDE * SIDE; i++) {
        assert_int_equal(glass[i][3], none[i][3]);
        if (memcmp(none[i], whole[i], 3) != 0) {
            covered++;
            dark += none[i][3] < 128;
        }
        for (int c = 0; c < 3; c++)
            assert_true(fabs(0.75 * none[i][c] + 0.25 * whole[i][c] - glass[i][c]) <= 1);
    }
    print_message("# %d pixels of glass, %d before shadows\n", covered, dark);
    assert_true(covered > 500 && dark > 20);
}

/* What a volume lets through, and what it adds, is known from it before black and white. */
static void volumes_lie_over_shadows_and_cast_none(void **state)
{
    (void)state;
    static Picture none, cloud, black, white;
    int covered = 0;
    draw("", "", none);
    draw("", CLOUD, cloud);
    for (int grey = 0; grey < 2; grey++) {
        Scene scene;
        char text[900];
        snprintf(text, sizeof text,
                 "{ \"size\": [96, 96], \"background\": [%d, %d, %d, 1], \"camera\": { \"eye\": "
                 "[0.6, 2.2, 4.5], \"at\": [0, 0.4, 0], \"fovy\": 40, \"near\": 1, \"far\": 12 },"
                 " \"objects\": [ { \"volume\": \"builtin:ball:16\", \"transfer\": \"fog\","
                 " \"fit\": [0.2, -0.2, 0.4, 1.6] } ] }",
                 grey, grey, grey);
        scene = load_scene(text);
        run_list(&scene.list);
        read_picture(scene.picture, grey ? white : black);
        scene_free(&scene);
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double through = (white[i][0] - black[i][0]) / 255.0;
        assert_int_equal(cloud[i][3], none[i][3]);
        for (int c = 0; c < 3 && through == 1; c++) /* nothing of the cloud is there */
            assert_int_equal(cloud[i][c], none[i][c]);
        for (int c = 0; c < 3; c++) /* what stands in the cloud takes some of it away */
            assert_true(cloud[i][c] <= black[i][c] + none[i][c] + 1 &&
                        cloud[i][c] >= through * none[i][c] - 1);
        covered += memcmp(cloud[i], none[i], 3) != 0;
    }
    print_message("# %d pixels of cloud\n", covered);
    assert_true(covered > 300);
}

static void scenes_that_ask_for_shadows_have_those_of_the_technique(void **state)
{
    (void)state;
    static Picture shown, drawn, without;
    static const char objects[] =
        GLASS("0.4") CLOUD "{ \"points\": \"builtin:sphere\","
                           " \"method\": \"ewa\", \"fit\": [-1, 0, -0.6, 0.7] },";
    int differing = 0;
    render(SORTED " \"shadows\": true,", objects, 0, shown);
    draw(SORTED, objects, drawn);
    render(SORTED, objects, 0, without);
    for (int i = 0; i < SIDE * SIDE; i++) {
        assert_memory_equal(shown[i], drawn[i], 3);
        assert_int_equal(shown[i][3], 255);
        differing += memcmp(shown[i], without[i], 3) != 0;
    }
    assert_true(differing > 100);
}

static void all_techniques_in_one_frame_have_the_same_bits_everywhere(void **state)
{
    (void)state;
    Scene scene = { .picture = NULL };
    GpError error = { "" };
    const SceneOptions small = { .width = 80, .height = 48 };
    if (shadowed_scene_load("scenes/together.json", &small, &scene, &error))
        fail_msg("%s", error.text);
    assert_true(scene.list.pass_count >= 6);
    run_everywhere(&scene.shadowed);
    scene_free(&scene);
}

static void what_cannot_be_is_refused_with_its_reason(void **state)
{
    (void)state;
    char path[TEMPORARY_PATH];
    Scene scene = { .picture = NULL };
    Frame frame = { .color = NULL };
    GpError error = { "" };
    write_scene(" \"shadows\": true,", GLASS("0.4"), 0, path);
    assert_int_equal(shadowed_scene_load(path, NULL, &scene, &error), GP_ERROR_FORMAT);
    unlink(path);
    assert_non_null(strstr(error.text, "shadows: glass is blended, which among shadows asks for"));
    TechniqueStage stage = open_stage("", GLASS("0.4"), device_here(0));
    assert_int_equal(technique_stage_draw(&stage, "", &frame, &error), GP_ERROR_INVALID);
    technique_stage_close(&stage);
    stage = open_stage(SORTED, GLASS("0.4"), device_here(0));
    assert_int_equal(shadow_technique.experiments[0].find_truth(stage.scene, 1, &error),
                     GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "and the scene has more over it: what is blended"));
    technique_stage_close(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_blended_lies_over_shadows_and_casts_none),
        cmocka_unit_test(volumes_lie_over_shadows_and_cast_none),
        cmocka_unit_test(scenes_that_ask_for_shadows_have_those_of_the_technique),
        cmocka_unit_test(all_techniques_in_one_frame_have_the_same_bits_everywhere),
        cmocka_unit_test(what_cannot_be_is_refused_with_its_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
