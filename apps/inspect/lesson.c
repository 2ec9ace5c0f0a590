#include "apps/inspect/lesson.h"

#include <stdio.h>
#include <string.h>

static const char ending[] = ".lesson.json";

const char *const lesson_form_names[LESSON_FORMS] = { "whole", "decimal", "set", "choice" };

static const char *text_of(Node *object, const char *key)
{
    Node node = node_member(object, key);
    node_require(&node);
    return node_string(node, "");
}

/* A list of texts, kept as it is. */
static json_t *texts_of(Node *object, const char *key)
{
    Node node = node_member(object, key);
    const size_t count = node_length(node, 16);
    for (size_t i = 0; i < count; i++)
        node_string(node_element(&node, i), "");
    return count ? node.value : NULL;
}

static json_t *read_choices(Node *object, LessonForm form)
{
    Node node = node_member(object, "choices");
    const size_t count = node_length(node, 8);
    for (size_t i = 0; i < count; i++) {
        Node choice = node_element(&node, i);
        text_of(&choice, "value");
        text_of(&choice, "text");
        node_close(&choice);
    }
    if ((form == LESSON_CHOICE) != (count > 1))
        node_fail(&node, GP_ERROR_FORMAT, "expected two or more for the form choice, else none");
    return count ? node.value : NULL;
}

static void read_answer(Node node, LessonAnswer *answer)
{
    node_require(&node);
    answer->from = text_of(&node, "from");
    node_enum(&node, "form", lesson_form_names, LESSON_FORMS, &answer->form);
    answer->times = node_double(node_member(&node, "times"), 1, -1e9, 1e9);
    answer->places = (int)node_integer(node_member(&node, "places"), 3, 0, LESSON_MOST_PLACES);
    if (answer->form != LESSON_DECIMAL)
        answer->places = 0;
    answer->count = node_bool(node_member(&node, "count"), false);
    answer->choices = read_choices(&node, answer->form);
    node_close(&node);
}

static void read_place(Node *root, Lesson *lesson)
{
    long pixel[2] = { 0, 0 };
    Node node = node_member(root, "pixel");
    node_require(&node);
    node_integers(node, pixel, 2, 0, 8191);
    lesson->x = (int32_t)pixel[0];
    lesson->y = (int32_t)pixel[1];
    lesson->step = (int)node_integer(node_member(root, "step"), 0, 0, 65535);
    lesson->pass = (int)node_integer(node_member(root, "pass"), -1, 0, 4095);
    lesson->draw = (int)node_integer(node_member(root, "draw"), -1, 0, INT32_MAX);
    lesson->triangle = (int)node_integer(node_member(root, "triangle"), -1, 0, INT32_MAX);
}

static void read_lesson(Lesson *lesson)
{
    Node root = node_root(&lesson->reader);
    lesson->title = text_of(&root, "title");
    lesson->learn = text_of(&root, "learn");
    lesson->unit = text_of(&root, "unit");
    lesson->question = text_of(&root, "question");
    lesson->hint = node_string(node_member(&root, "hint"), NULL);
    lesson->why = text_of(&root, "why");
    lesson->look = texts_of(&root, "look");
    lesson->hide = texts_of(&root, "hide");
    read_place(&root, lesson);
    read_answer(node_member(&root, "answer"), &lesson->answer);
    node_close(&root);
}

/* Its name, and the scene beside it. */
static GpResult name_lesson(const char *path, Lesson *lesson, GpError *error)
{
    const size_t length = strlen(path), end = sizeof ending - 1;
    const char *slash = strrchr(path, '/'), *file = slash ? slash + 1 : path;
    if (length <= end || strcmp(path + length - end, ending) != 0 || strlen(file) <= end)
        return gp_fail(error, GP_ERROR_FORMAT, "%.200s: expected a file NAME%s", path, ending);
    const int name = (int)(strlen(file) - end), scene = (int)(length - end);
    if ((size_t)name >= sizeof lesson->name || (size_t)scene + 6 > sizeof lesson->scene)
        return gp_fail(error, GP_ERROR_FORMAT, "%.200s: the name is too long", path);
    snprintf(lesson->name, sizeof lesson->name, "%.*s", name, file);
    snprintf(lesson->scene, sizeof lesson->scene, "%.*s.json", scene, path);
    return GP_OK;
}

GpResult lesson_open(const char *path, Lesson *lesson, GpError *error)
{
    *lesson = (Lesson){ .pass = -1 };
    GpResult result = name_lesson(path, lesson, error);
    if (!result)
        result = reader_open(&lesson->reader, path, error);
    if (result)
        return result;
    read_lesson(lesson);
    result = lesson->reader.result;
    if (result)
        lesson_close(lesson);
    return result;
}

void lesson_close(Lesson *lesson)
{
    reader_close(&lesson->reader);
    *lesson = (Lesson){ .pass = -1 };
}
