/* The uniforms of a draw by name: from the struct as its shader's source declares it. */
#ifndef APPS_INSPECT_UNIFORMS_H
#define APPS_INSPECT_UNIFORMS_H

#include <glasspipe/glasspipe.h>

#include <jansson.h>

/* [{"name": "light.color", "word", "words", "value": numbers, of matrices rows of them}, ...] of a
 * draw, in the struct's order; members of four bytes each, floats and whole numbers. Where the
 * source is not in the program, or its struct is not understood, one entry of all words,
 * "uniforms". An empty list: it has none. The caller owns it. */
json_t *uniforms_tell(const GpDraw *draw);

/* Whether a program's struct is found and has the size that the program says. */
bool uniforms_are_known(const GpProgram *program);

#endif
