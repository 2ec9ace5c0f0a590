/* What a list consists of, pass by pass. */
#ifndef APPS_COMMANDS_PASS_LIST_H
#define APPS_COMMANDS_PASS_LIST_H

#include <glasspipe/glasspipe.h>

#include <jansson.h>

/* One object a pass: pass, name, width, height, draws, group (gp_list_groups), targets (names of
 * formats, depth last). The caller owns the array; NULL without memory. */
json_t *pass_list_json(const GpList *list);

/* Prints that array to stdout as a table. */
void pass_list_print(const json_t *passes);

#endif
