/* A lesson: a question about one value of a scene's frame, answered on paper before the page shows
 * it.
 *
 * NAME.lesson.json lies beside the scene NAME.json; scenes/README.md says how one is
 * written. What the answer is stands in neither: it is a place in what the recorder says
 * (lesson_answer.h). */
#ifndef APPS_INSPECT_LESSON_H
#define APPS_INSPECT_LESSON_H

#include "apps/base/json_reader.h"

/* What an answer looks like. */
typedef enum LessonForm {
    LESSON_WHOLE,   /* a whole number, decimal or hexadecimal */
    LESSON_DECIMAL, /* a number, to so many places */
    LESSON_SET,     /* whole numbers in any order */
    LESSON_CHOICE,  /* one of some texts */
    LESSON_FORMS
} LessonForm;

/* By value: "whole". */
extern const char *const lesson_form_names[LESSON_FORMS];

enum { LESSON_MOST_PLACES = 6 };

typedef struct LessonAnswer {
    const char *from; /* where it stands in the record: "clip.corners" */
    LessonForm form;
    double times;    /* what is recorded is multiplied by this: 255 makes a byte's code of it */
    int places;      /* of decimals */
    bool count;      /* not the values, but how many there are */
    json_t *choices; /* [{"value", "text"}]; NULL without. Borrowed */
} LessonAnswer;

typedef struct Lesson {
    char name[128], scene[4096];       /* the file's without folder and ending; the scene's path */
    const char *title, *learn, *unit;  /* unit: of the page's panels, "clipping" */
    const char *question, *hint, *why; /* hint: NULL without */
    json_t *look, *hide;               /* texts; NULL without. Borrowed */
    int pass;                          /* -1: the last */
    int32_t x, y;
    int draw, triangle; /* of the fragment that is looked at; -1: the one that is seen */
    int step;           /* of the pixel shader */
    LessonAnswer answer;
    /* pages beside this one; NULL: none. Not of the file: the maker of a course sets them */
    const char *previous, *next, *index;
    Reader reader; /* owns what is borrowed */
} Lesson;

/* Reads a lesson. in: path: of a NAME.lesson.json
 * errors those of reader_open, GP_ERROR_FORMAT. owns: the caller, until lesson_close */
GpResult lesson_open(const char *path, Lesson *lesson, GpError *error);
void lesson_close(Lesson *lesson);

#endif
