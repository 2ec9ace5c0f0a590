/* Lessons: what the recorder says is what pencil and paper say, the page knows it by its hash
 * alone, and lessons that ask for nothing are refused. */
#include "apps/inspect/inspect.h"
#include "apps/inspect/lesson_answer.h"
#include "apps/inspect/lesson_course.h"
#include "apps/scene/scene.h"
#include "tests/support/unit.h"

#include <stdio.h>

/* Found by hand, in the normal form: of decimals in units of the last place. */
static const struct {
    const char *name, *answer, *wrong;
} lessons[] = {
    { "01_three_vertices", "0 2", "0 1" },      /* the ends of the diagonal */
    { "02_vertex_shader", "2", "4" },           /* 4 - 2 */
    { "03_clipping", "4", "3" },                /* 3 - 1 + 2 */
    { "04_viewport", "845", "844" },            /* 3.3 * 256 = 844.8 */
    { "05_setup", "-80", "80" },                /* 0 * 0 - (-10)(-8) */
    { "06_fill_rule", "21", "18" },             /* 15 and the diagonal */
    { "07_interpolation", "20", "50" },         /* (1/4 + 1/4) / (2 + 1/4 + 1/4) */
    { "08_levels", "4", "16" },                 /* log2(256 / 16) */
    { "09_pixel_shader", "675", "600" },        /* 0.75 * 0.8 + 0.075 */
    { "10_tests", "6", "5" },                   /* incr-sat of 5 */
    { "11_blending", "96", "95" },              /* 0.375 * 255 + 1/2, cut */
    { "12_deferred_four_targets", "55", "50" }, /* the centre of pixel 5 */
};

typedef struct Opened {
    Lesson lesson;
    Scene scene;
} Opened;

static void open_lesson(const char *name, Opened *opened)
{
    GpError error = { "" };
    char path[128];
    snprintf(path, sizeof path, "scenes/lessons/%s.lesson.json", name);
    if (lesson_open(path, &opened->lesson, &error) ||
        scene_load(opened->lesson.scene, &(SceneOptions){ .width = 0 }, &opened->scene, &error))
        fail_msg("%s", error.text);
}

static void close_lesson(Opened *opened)
{
    scene_free(&opened->scene);
    lesson_close(&opened->lesson);
}

static Inspect inspect_of(const Opened *opened)
{
    const Lesson *lesson = &opened->lesson;
    return (Inspect){ .title = lesson->name,
                      .list = &opened->scene.list,
                      .picture = opened->scene.picture,
                      .region = { lesson->x, lesson->y, lesson->x + 1, lesson->y + 1 },
                      .lesson = lesson,
                      .draw = -1,
                      .pixels = 1,
                      .no_timings = true,
                      .threads = 1 };
}

static void the_recorder_says_what_pencil_and_paper_say(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(lessons); i++) {
        Opened opened;
        GpError error = { "" };
        open_lesson(lessons[i].name, &opened);
        Blobs blobs = { .count = 0 };
        Record record;
        json_t *told = NULL;
        char answer[LESSON_ANSWER_TEXT], right[17], wrong[17];
        const Inspect inspect = inspect_of(&opened);
        if (record_frame(&inspect, &blobs, &record, &error) ||
            lesson_record(&opened.lesson, &record, &told, &error) ||
            lesson_answer(&opened.lesson, told, answer, &error))
            fail_msg("%s: %s", lessons[i].name, error.text);
        if (strcmp(answer, lessons[i].answer) != 0)
            fail_msg("%s: recorded %s, by hand %s", lessons[i].name, answer, lessons[i].answer);
        lesson_hash(&opened.lesson, answer, right);
        lesson_hash(&opened.lesson, lessons[i].wrong, wrong);
        assert_string_not_equal(right, wrong);
        json_decref(told);
        record_free(&record);
        blobs_free(&blobs);
        close_lesson(&opened);
    }
}

/* inspect_page refuses a frame that the executors draw with other bits. */
static void both_executors_draw_every_lesson_alike(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(lessons); i++) {
        Opened opened;
        GpError error = { "" };
        Text page;
        open_lesson(lessons[i].name, &opened);
        const Inspect inspect = inspect_of(&opened);
        if (inspect_page(&inspect, NULL, &page, &error))
            fail_msg("%s: %s", lessons[i].name, error.text);
        text_free(&page);
        close_lesson(&opened);
    }
}

static void the_hash_is_the_one_that_the_page_computes(void **state)
{
    (void)state;
    char hash[17];
    Lesson lesson = { .name = "" };
    lesson_hash(&lesson, "foobar", hash);
    assert_string_equal(hash, "d45ef972adb920e0"); /* FNV-1a of "\nfoobar", by another program */
}

static void a_folder_has_all_of_its_lessons_on_one_page(void **state)
{
    (void)state;
    GpError error = { "" };
    Course course;
    Text page = { .data = NULL };
    if (course_open("scenes/lessons", &course, &error))
        fail_msg("%s", error.text);
    assert_int_equal(course.count, GP_COUNT(lessons));
    for (size_t i = 0; i < GP_COUNT(lessons); i++) {
        char name[128], expected[256];
        Opened opened;
        course_page_name(&course, (uint32_t)i, name, sizeof name);
        snprintf(expected, sizeof expected, "%s.html", lessons[i].name);
        assert_string_equal(name, expected);
        open_lesson(lessons[i].name, &opened);
        assert_int_equal(course_add(&course, &opened.lesson, opened.scene.picture, &error), GP_OK);
        close_lesson(&opened);
    }
    course_index(&course, ".", &page);
    for (size_t i = 0; i < GP_COUNT(lessons); i++) {
        char link[256];
        snprintf(link, sizeof link, "href=\"%s.html\"", lessons[i].name);
        assert_non_null(strstr(page.data, link));
    }
    text_free(&page);
    course_free(&course);
}

static json_t *record_text(void)
{
    return json_loads(
        "{\"vertices\": [{\"vertex\": 7, \"reuse\": 2}, {\"vertex\": 3, \"reuse\": 1},"
        " {\"vertex\": 5, \"reuse\": 2}], \"setup\": [{\"reason\": null}],"
        " \"pixel\": {\"color\": [[0.0625, -0.0625, \"nan\"]]},"
        " \"test\": [{\"unit\": \"depth\", \"passed\": false}],"
        " \"far\": [1e200, 2e200]}",
        0, NULL);
}

static void paths_name_members_elements_and_those_that_have_a_value(void **state)
{
    (void)state;
    json_t *choices = json_loads("[{\"value\": \"none\"}, {\"value\": \"depth\"}]", 0, NULL);
    const struct {
        LessonAnswer answer;
        const char *text; /* NULL: refused */
    } rows[] = {
        { { .from = "vertices.reuse=2.vertex", .form = LESSON_SET, .times = 1 }, "5 7" },
        { { .from = "vertices.*.reuse", .form = LESSON_SET, .times = 1 }, "1 2" },
        { { .from = "vertices.*", .count = true }, "3" },
        { { .from = "vertices.1.vertex", .times = 2 }, "6" },
        { { .from = "vertices.3.vertex", .times = 1 }, NULL },
        { { .from = "vertices.1x.vertex", .times = 1 }, NULL },
        { { .from = "vertices.*.vertex", .times = 1 }, NULL }, /* three are not one */
        { { .from = "pixel.color.0.0", .form = LESSON_DECIMAL, .times = 1, .places = 3 }, "63" },
        { { .from = "pixel.color.0.1", .form = LESSON_DECIMAL, .times = 1, .places = 3 }, "-63" },
        { { .from = "pixel.color.0.2", .form = LESSON_DECIMAL, .times = 1 }, NULL },
        { { .from = "setup.0.reason", .form = LESSON_CHOICE, .choices = choices }, "none" },
        { { .from = "test.passed=false.unit", .form = LESSON_CHOICE, .choices = choices },
          "depth" },
        { { .from = "test.0.passed", .form = LESSON_CHOICE, .choices = choices }, NULL },
        { { .from = "far.*", .form = LESSON_SET, .times = 1 }, NULL }, /* 403 characters */
    };
    json_t *told = record_text();
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const Lesson lesson = { .name = "made", .answer = rows[i].answer };
        GpError error = { "" };
        char text[LESSON_ANSWER_TEXT];
        const GpResult result = lesson_answer(&lesson, told, text, &error);
        if (!rows[i].text) {
            assert_int_equal(result, GP_ERROR_FORMAT);
            assert_non_null(strstr(error.text, rows[i].answer.from));
        } else if (result || strcmp(text, rows[i].text) != 0) {
            fail_msg("%s: %s", rows[i].answer.from, result ? error.text : text);
        }
    }
    json_decref(told);
    json_decref(choices);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_recorder_says_what_pencil_and_paper_say),
        cmocka_unit_test(both_executors_draw_every_lesson_alike),
        cmocka_unit_test(the_hash_is_the_one_that_the_page_computes),
        cmocka_unit_test(a_folder_has_all_of_its_lessons_on_one_page),
        cmocka_unit_test(paths_name_members_elements_and_those_that_have_a_value),
    };
    return cmocka_run_group_tests_name("lessons", tests, NULL, NULL);
}
