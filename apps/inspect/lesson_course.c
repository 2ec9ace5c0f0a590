#include "apps/inspect/lesson_course.h"

#include "apps/base/page.h"
#include "apps/frame/picture.h"
#include "pipeline/io/file.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char style[] =
    "body { max-width: 880px } h1 { margin: 8px 0; letter-spacing: -.01em }\n"
    ".lead { color: var(--soft); max-width: 40em; margin: 0 0 28px }\n"
    "ol, ul { list-style: none; margin: 0; padding: 0; display: grid; gap: 10px }\n"
    "ol { counter-reset: lesson } ol li { counter-increment: lesson }\n"
    "li a { display: grid; grid-template-columns: 80px 1.4em 1fr auto; gap: 4px 18px;\n"
    "       padding: 12px 20px 12px 12px; background: var(--sheet); border: 1px solid "
    "var(--line);\n"
    "       border-radius: 10px; text-decoration: none; align-items: center; break-inside: avoid "
    "}\n"
    "li a:hover { border-color: var(--soft) }\n"
    "a:focus-visible { outline: 3px solid var(--soft); outline-offset: 2px }\n"
    "li img { width: 80px; height: 80px; image-rendering: pixelated; border-radius: 6px }\n"
    "li .number::before { content: counter(lesson) } .number { font-size: 22px; text-align: right "
    "}\n"
    "li b { font-size: 17px; display: block; color: var(--ink) } li span { color: var(--soft) }\n"
    "li .done { color: var(--good); font-size: 14px; white-space: nowrap }\n"
    ".more { margin-top: 26px } .more a { grid-template-columns: 1fr; padding-left: 20px }\n"
    "@media (max-width: 560px) { li a { grid-template-columns: 48px 1fr; }\n"
    "  li img { width: 48px; height: 48px } li .number { display: none } }\n"
    "@media print { body { background: none; padding: 0 } ol, ul { gap: 6px }\n"
    "  li img { width: 48px; height: 48px } li a { padding: 6px 12px } }\n";

/* Marks what was answered in this browser; one that does not remember marks nothing. */
static const char script[] =
    "<script>for (const one of document.querySelectorAll(\"[data-lesson]\")) {\n"
    "    let how = null;\n"
    "    try { how = localStorage.getItem(\"glasspipe lesson \" + one.dataset.lesson); } catch "
    "(none) {}\n"
    "    if (how) one.querySelector(\".done\").textContent = how === \"answered\" ? \"\\u2714 "
    "answered\" : \"\\u25cb seen\";\n"
    "}</script>\n";

/* --- the folder ------------------------------------------------------------------------------- */

static int is_lesson(const struct dirent *entry)
{
    static const char ending[] = ".lesson.json";
    const size_t length = strlen(entry->d_name), end = sizeof ending - 1;
    return entry->d_name[0] != '.' && length > end &&
           strcmp(entry->d_name + length - end, ending) == 0;
}

/* "folder/name"; NULL: no memory */
static char *join(const char *folder, const char *name)
{
    const size_t size = strlen(folder) + strlen(name) + 2;
    char *path = gp_alloc(size, 1);
    if (path)
        snprintf(path, size, "%s/%s", folder, name);
    return path;
}

static GpResult list_lessons(const char *folder, Course *course, GpError *error)
{
    struct dirent **entries;
    const int count = scandir(folder, &entries, is_lesson, alphasort);
    if (count < 0)
        return gp_fail(error, gp_result_of_errno(errno), "%.200s: %s", folder, strerror(errno));
    course->path = gp_alloc((size_t)count + 1, sizeof *course->path);
    bool failed = !course->path;
    for (int i = 0; i < count; i++) {
        char *path = failed ? NULL : join(folder, entries[i]->d_name);
        failed = failed || !path;
        if (!failed)
            course->path[course->count++] = path;
        free(entries[i]);
    }
    free(entries);
    if (failed)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the lessons of a folder");
    return count ? GP_OK
                 : gp_fail(error, GP_ERROR_FORMAT, "%.200s: there is no NAME.lesson.json", folder);
}

static void check_about(Reader *reader)
{
    Node root = node_root(reader);
    node_string(node_member(&root, "title"), "");
    node_string(node_member(&root, "about"), "");
    Node more = node_member(&root, "more");
    const size_t count = node_length(more, 16);
    for (size_t i = 0; i < count; i++) {
        Node one = node_element(&more, i);
        const char *const keys[] = { "title", "about", "page" };
        for (size_t k = 0; k < GP_COUNT(keys); k++) {
            Node text = node_member(&one, keys[k]);
            node_require(&text);
            node_string(text, "");
        }
        node_close(&one);
    }
    node_close(&root);
}

static GpResult read_about(const char *folder, Course *course, GpError *error)
{
    char *path = join(folder, "course.json");
    GpResult result = path ? GP_OK : gp_fail(error, GP_ERROR_MEMORY, "no memory for a path");
    if (path && access(path, F_OK) == 0) {
        result = reader_open(&course->about, path, error);
        if (!result) {
            check_about(&course->about);
            result = course->about.result;
        }
    }
    gp_free(path);
    return result;
}

GpResult course_open(const char *folder, Course *course, GpError *error)
{
    *course = (Course){ .count = 0 };
    GpResult result = list_lessons(folder, course, error);
    if (!result)
        result = read_about(folder, course, error);
    if (result)
        course_free(course);
    return result;
}

void course_free(Course *course)
{
    for (uint32_t i = 0; i < course->count; i++)
        gp_free(course->path[i]);
    gp_free(course->path);
    reader_close(&course->about);
    text_free(&course->entries);
    *course = (Course){ .count = 0 };
}

void course_page_name(const Course *course, uint32_t number, char *name, size_t size)
{
    name[0] = '\0';
    if (number >= course->count)
        return;
    const char *file = strrchr(course->path[number], '/') + 1;
    snprintf(name, size, "%.*s.html", (int)(strlen(file) - strlen(".lesson.json")), file);
}

/* --- the page --------------------------------------------------------------------------------- */

GpResult course_add(Course *course, const Lesson *lesson, const GpSurface *surface, GpError *error)
{
    GpImage image = { .data = NULL };
    Picture picture = { .values = NULL };
    GpFile png = { .data = NULL };
    GpResult result = picture_samples("picture.png", surface, &surface->window, &image, error);
    if (!result)
        result = picture_of_image(&image, &picture, error);
    if (!result)
        result = picture_set_channels(&picture, 3, error);
    if (!result)
        result = picture_encode_png(&picture, &png, error);
    if (!result) {
        Text *text = &course->entries;
        text_add_escaped(text, "<li><a href=\"%s.html\" data-lesson=\"%s\">", lesson->name,
                         lesson->name);
        page_add_png(text, &png, " alt=\"\"");
        text_add_escaped(text,
                         "<span class=\"number\"></span><span><b>%s</b>%s</span><span "
                         "class=\"done\"></span></a></li>\n",
                         lesson->title, lesson->learn);
    }
    gp_file_free(&png);
    picture_free(&picture);
    gp_image_free(&image);
    return result;
}

static const char *text_or(const json_t *object, const char *key, const char *other)
{
    const char *text = json_string_value(json_object_get(object, key));
    return text ? text : other;
}

static void add_more(const json_t *one, const char *folder, Text *page)
{
    char *path = join(folder, text_or(one, "page", ""));
    page->failed = page->failed || !path;
    if (path && access(path, F_OK) == 0)
        text_add_escaped(page, "<li><a href=\"%s\"><span><b>%s</b>%s</span></a></li>\n",
                         text_or(one, "page", ""), text_or(one, "title", ""),
                         text_or(one, "about", ""));
    gp_free(path);
}

void course_index(const Course *course, const char *folder, Text *page)
{
    const json_t *about = course->about.root, *more = json_object_get(about, "more");
    const char *title = text_or(about, "title", "Lessons");
    page_begin(page, title, style);
    text_add_escaped(page, "<h1>%s</h1>\n<p class=\"lead\">%s</p>\n<ol>\n", title,
                     text_or(about, "about", ""));
    text_add(page, "%s</ol>\n<ul class=\"more\">\n",
             course->entries.data ? course->entries.data : "");
    for (size_t i = 0; i < json_array_size(more); i++)
        add_more(json_array_get(more, i), folder, page);
    text_add(page, "</ul>\n%s", script);
    page_end(page);
    page->failed = page->failed || course->entries.failed;
}
