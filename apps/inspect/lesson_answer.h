/* The answer to a lesson's question: what the recorder says, in one normal form, and its hash.
 *
 * The record of a fragment is an object: draw, primitive, vertices[], clip and setup[] of its
 * triangle; raster, interpolate, pixel, steps, missed and the lists texture, test and output of
 * itself, with the members that trace_json.h gives them; fragments[], all of the pixel (draw,
 * primitive, verdict); covered: the pixels of its triangle; counters, of its draw. A path names
 * values in it by words with dots between: a member; a number, an element from 0; *, all elements;
 * member=value, the elements that have it. "vertices.reuse=2.vertex" are the vertices that are
 * named twice. The page's panels name their values so too. */
#ifndef APPS_INSPECT_LESSON_ANSWER_H
#define APPS_INSPECT_LESSON_ANSWER_H

#include "apps/inspect/lesson.h"
#include "apps/inspect/record.h"

/* Finds the record of the fragment that a lesson looks at. out: the caller owns it
 * errors GP_ERROR_FORMAT: there is none, or it is not recorded; GP_ERROR_MEMORY */
GpResult lesson_record(const Lesson *lesson, const Record *record, json_t **told, GpError *error);

enum { LESSON_ANSWER_TEXT = 256 };

/* The answer in its normal form: of numbers times and rounded to so many places, as whole numbers
 * of these; those of a set ascending, with blanks between; of a choice its value.
 * errors GP_ERROR_FORMAT: the path names nothing there, or nothing of this form */
GpResult lesson_answer(const Lesson *lesson, const json_t *told, char text[LESSON_ANSWER_TEXT],
                       GpError *error);

/* FNV-1a of 64 bits of "NAME\nTEXT", as 16 digits: the page has the answer as this alone, so that
 * it is not read by chance. It is a curtain and no lock. */
void lesson_hash(const Lesson *lesson, const char *text, char hash[17]);

/* The lesson as its page has it: name, title, learn, unit, pass, x, y, draw, triangle, step,
 * question, look[], hide[], hint, form, places, choices[], hash, previous, next, index; why: a
 * blob, so that it is not read by chance either. The caller owns it.
 * errors those of lesson_record and lesson_answer */
GpResult lesson_tell(const Lesson *lesson, const Record *record, Blobs *blobs, json_t **told,
                     GpError *error);

#endif
