/* A folder of lessons, in the order of their names, and the page that lists them.
 *
 * Where the folder has a course.json, it says what stands on that page: {"title", "about", "more":
 * [{"title", "about", "page"}]}, each left out as one likes; page: a file
 * beside the index, which is named where it is there. */
#ifndef APPS_INSPECT_LESSON_COURSE_H
#define APPS_INSPECT_LESSON_COURSE_H

#include "apps/base/text.h"
#include "apps/inspect/lesson.h"
#include "pipeline/resources/surface.h"

typedef struct Course {
    char **path; /* of the lessons' files */
    uint32_t count;
    Reader about; /* root NULL: there is none */
    Text entries; /* of the list */
} Course;

/* Finds the lessons of a folder. errors GP_ERROR_IO, GP_ERROR_MEMORY, GP_ERROR_FORMAT: there is
 * none, or course.json is not right. owns: the caller, until course_free */
GpResult course_open(const char *folder, Course *course, GpError *error);
void course_free(Course *course);

/* The page of a lesson, beside the others: "01_three_vertices.html"; "" where there is no such
 * lesson. */
void course_page_name(const Course *course, uint32_t number, char *name, size_t size);

/* Adds a lesson's line, when its page is made. in: picture: its scene's
 * errors GP_ERROR_MEMORY */
GpResult course_add(Course *course, const Lesson *lesson, const GpSurface *picture, GpError *error);

/* The list as a page. in: folder: where it will lie. owns: the caller, until text_free */
void course_index(const Course *course, const char *folder, Text *page);

#endif
