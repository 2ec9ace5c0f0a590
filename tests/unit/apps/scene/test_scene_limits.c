/* Limits of scene files: what is at one is read, and what is one beyond is refused with the
 * number. */
#include "apps/base/text.h"
#include "tests/support/scene_text.h"

#include <stdio.h>

static const char rest[] = "\"objects\": [ { \"mesh\": \"builtin:cube\" } ] }";

/* A scene with so many of an element in an array, between two texts. */
static Text scene_with(const char *before, const char *element, uint32_t count, const char *after)
{
    Text text = { .data = NULL };
    text_add(&text, "%s", before);
    for (uint32_t i = 0; i < count; i++)
        text_add(&text, "%s%s", i ? ", " : "", element);
    text_add(&text, "%s", after);
    return text;
}

static void arrays_end_at_their_limits(void **state)
{
    (void)state;
    static const struct {
        const char *before, *element, *after;
        uint32_t limit;
    } cases[] = {
        { "{ \"lights\": [ ", "{ \"direction\": [1, 2, 3] }", " ], ", 8 },
        { "{ \"targets\": [ ", "{}", " ], ", 4 },
        { "{ \"objects\": [ { \"mesh\": \"builtin:cube\", \"state\": { \"clip_planes\": [ ",
          "[0, 1, 0, 0]", " ] } } ] }", 6 },
        { "{ \"objects\": [ { \"mesh\": { \"triangles\": [ [0, 1, 2] ], \"positions\": [ ",
          "[0, 1, 0]", " ] } } ] }", 4096 },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        for (uint32_t beyond = 0; beyond < 2; beyond++) {
            Text text = scene_with(cases[i].before, cases[i].element, cases[i].limit + beyond,
                                   cases[i].after);
            if (!strstr(text.data, "\"objects\""))
                text_add(&text, "%s", rest);
            Scene scene = { .light_count = 0 };
            GpError error = { "" };
            char expected[64];
            snprintf(expected, sizeof expected, "%u elements, at most %u", cases[i].limit + 1,
                     cases[i].limit);
            const GpResult result = load_scene_text(text.data, text.length, NULL, &scene, &error);
            if (result != (beyond ? GP_ERROR_FORMAT : GP_OK) ||
                (beyond && !strstr(error.text, expected)))
                fail_msg("case %zu, %u: %s", i, beyond, error.text);
            scene_free(&scene);
            text_free(&text);
        }
}

/* Blanks count too. */
static void files_have_up_to_4_megabytes(void **state)
{
    (void)state;
    enum { MOST = 4 << 20 };
    char *text = gp_alloc(MOST + 1, 1);
    memset(text, ' ', MOST + 1);
    memcpy(text, "{ ", 2);
    memcpy(text + 2, rest, strlen(rest));
    for (size_t size = MOST; size <= MOST + 1; size++) {
        Scene scene = { .light_count = 0 };
        GpError error = { "" };
        assert_int_equal(load_scene_text(text, size, NULL, &scene, &error),
                         size == MOST ? GP_OK : GP_ERROR_FORMAT);
        assert_true(size == MOST || strstr(error.text, "over 4 MB"));
        scene_free(&scene);
    }
    gp_free(text);
}

static SceneOutline outline_of(int width, int height, const char *more)
{
    char path[TEMPORARY_PATH], text[400];
    snprintf(text, sizeof text, "{ \"size\": [%d, %d], %s %s", width, height, more, rest);
    put_temporary(text, strlen(text), path);
    const SceneOutline outline = scene_outline(path);
    unlink(path);
    return outline;
}

static void an_outline_has_the_size_that_a_picture_may_have(void **state)
{
    (void)state;
    static const struct {
        int size[2];
        bool is_one;
    } cases[] = {
        { { 1, 1 }, true },     { { 8192, 1 }, true }, { { 1, 8192 }, true },
        { { 0, 5 }, false },    { { 5, 0 }, false },   { { 8193, 5 }, false },
        { { 5, 8193 }, false }, { { -1, 5 }, false },  { { 640, 480 }, true },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        const SceneOutline outline = outline_of(cases[i].size[0], cases[i].size[1], "");
        assert_int_equal(outline.width, cases[i].is_one ? cases[i].size[0] : 512);
        assert_int_equal(outline.height, cases[i].is_one ? cases[i].size[1] : 512);
    }
    assert_int_equal(scene_outline("/nowhere.json").width, 512);
}

static void an_outline_costs_more_with_pixels_passes_and_objects(void **state)
{
    (void)state;
    const char *passes = "\"passes\": [ {}, {} ],";
    const char *objects = "\"passes\": [ { \"objects\": [ {}, {} ] }, {} ],";
    const double least = outline_of(100, 100, "").cost;
    assert_true(outline_of(200, 100, "").cost > least && outline_of(100, 200, "").cost > least);
    assert_true(outline_of(100, 100, passes).cost == least + 100 * 100);
    assert_true(outline_of(100, 100, objects).cost > outline_of(100, 100, passes).cost);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrays_end_at_their_limits),
        cmocka_unit_test(files_have_up_to_4_megabytes),
        cmocka_unit_test(an_outline_has_the_size_that_a_picture_may_have),
        cmocka_unit_test(an_outline_costs_more_with_pixels_passes_and_objects),
    };
    return cmocka_run_group_tests_name("limits of scenes", tests, NULL, NULL);
}
