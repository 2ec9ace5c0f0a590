/* Sources that a page shows: those of the units, and of the shaders that a frame draws with. */
#ifndef APPS_INSPECT_SOURCES_H
#define APPS_INSPECT_SOURCES_H

#include "apps/inspect/page_files.h"
#include <glasspipe/glasspipe.h>

#include <jansson.h>

/* The file of a path among those in the program, or NULL. */
const PageFile *source_find(const char *path);

/* The first line of the statement that a line is in; file: NULL: the line itself. */
int source_statement_line(const PageFile *file, int line);

/* The file of a program, or NULL: shaders of the user's own are not in the program. */
const PageFile *source_of_program(const char *program);

/* Visits a file and the shaders' files that it includes, and that these include, as they stand,
 * until a visit returns true. returns whether one did */
bool source_each_include(const PageFile *file, bool (*visit)(void *user, const PageFile *file),
                         void *user);

/* {"pipeline/units/blend.c": text, ...}: the units, and each program's file with what it includes
 * from beside it. The caller owns it. */
json_t *sources_tell(const GpList *list);

/* {"phong_program": path, ...} of the programs of a list; those without are left out. */
json_t *sources_of_programs(const GpList *list);

#endif
