/* Lessons of `glasspipe inspect`: one page, or a folder of them with an index. */
#ifndef APPS_COMMANDS_INSPECT_LESSONS_H
#define APPS_COMMANDS_INSPECT_LESSONS_H

#include "apps/commands/inspect/page.h"

/* Writes the page of the lesson that --lesson names, or those of all in a folder; an exit code,
 * with its message said. Lessons are found where data is. */
int inspect_lessons(InspectCommand *command);

#endif
