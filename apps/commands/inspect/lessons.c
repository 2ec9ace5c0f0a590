#include "apps/commands/inspect/lessons.h"

#include "apps/base/folder.h"
#include "apps/base/json.h"
#include "apps/commands/output.h"
#include "apps/inspect/lesson_course.h"
#include "pipeline/io/file.h"

#include <stdio.h>
#include <string.h>

/* A lesson's page; course: which it is one of, or NULL */
static int inspect_lesson(const InspectCommand *command, Lesson *lesson, const char *path,
                          Course *course)
{
    GpError error = { "" };
    InspectCommand own = *command;
    Drawn drawn = { .opened = NULL };
    own.scene = lesson->scene;
    own.lesson = lesson;
    own.options.json = command->options.json && !course; /* of all at once */
    int code = inspect_open(&own, own.scene, NULL, &drawn);
    if (!code)
        code = inspect_write(&own, path, &drawn, &drawn);
    if (!code && course && course_add(course, lesson, drawn.picture, &error))
        code = report(EXIT_INTERNAL, "%s", error.text);
    inspect_release(&own, &drawn);
    return code;
}

static int inspect_one(const InspectCommand *command)
{
    GpError error = { "" };
    Lesson lesson;
    GpResult result = lesson_open(command->lesson_path, &lesson, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    char path[4096];
    output_default_path(lesson.scene, "html", path, sizeof path);
    const int code =
        inspect_lesson(command, &lesson, command->output ? command->output : path, NULL);
    lesson_close(&lesson);
    return code;
}

static int inspect_of_course(const InspectCommand *command, Course *course, uint32_t number,
                             const char *folder)
{
    GpError error = { "" };
    Lesson lesson;
    GpResult result = lesson_open(course->path[number], &lesson, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    char name[256], previous[256], next[256], path[4096];
    course_page_name(course, number, name, sizeof name);
    course_page_name(course, number - 1, previous, sizeof previous);
    course_page_name(course, number + 1, next, sizeof next);
    lesson.previous = previous[0] ? previous : NULL;
    lesson.next = next[0] ? next : NULL;
    lesson.index = "index.html";
    snprintf(path, sizeof path, "%.3800s/%s", folder, name);
    const int code = inspect_lesson(command, &lesson, path, course);
    lesson_close(&lesson);
    return code;
}

static int write_index(const InspectCommand *command, const Course *course, const char *folder)
{
    GpError error = { "" };
    Text page = { .data = NULL };
    char path[4096];
    course_index(course, folder, &page);
    snprintf(path, sizeof path, "%.4000s/index.html", folder);
    const GpResult result = text_write(path, &page, &error);
    text_free(&page);
    if (result)
        return report(EXIT_INTERNAL, "%s", error.text);
    if (command->options.json)
        return output_json(json_pack("{s:o, s:I}", "index", json_text(path), "lessons",
                                     (json_int_t)course->count));
    notice(&command->options, "%s: %u lessons", path, course->count);
    return EXIT_DONE;
}

static int inspect_course(const InspectCommand *command)
{
    GpError error = { "" };
    Course course;
    const char *folder = command->output            ? command->output
                         : gp_path_is_folder("out") ? "out/lessons"
                                                    : "lessons";
    const GpResult result = course_open(command->lesson_path, &course, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    int code = EXIT_DONE;
    if (folder_make(folder, &error))
        code = report(EXIT_INTERNAL, "%s", error.text);
    for (uint32_t i = 0; i < course.count && !code; i++)
        code = inspect_of_course(command, &course, i, folder);
    if (!code)
        code = write_index(command, &course, folder);
    course_free(&course);
    return code;
}

int inspect_lessons(InspectCommand *command)
{
    GpError error = { "" };
    char path[4096];
    if (gp_data_find(command->lesson_path, path, sizeof path, &error))
        return report(EXIT_INPUT, "%s", error.text);
    command->lesson_path = path;
    return gp_path_is_folder(path) ? inspect_course(command) : inspect_one(command);
}
