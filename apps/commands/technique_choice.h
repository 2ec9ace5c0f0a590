/* --error: the setting that keeps it. */
#ifndef APPS_COMMANDS_TECHNIQUE_CHOICE_H
#define APPS_COMMANDS_TECHNIQUE_CHOICE_H

#include "apps/commands/technique_args.h"

#include <jansson.h>

/* Reads what the options say of it into the arguments, and does not return where they are wrong. */
void technique_check_error(struct argp_state *state, TechniqueArgs *args);

/* Sets the settings of the arguments to what keeps the error, and says which and why.
 * in   scene: open
 * out  told: an object for --json; the caller's, also after a failure; NULL: not asked for
 * returns EXIT_DONE; EXIT_DIFFERS, after a message, where none keeps it, and the settings are the
 *      most exact ones; or another exit code, after a message */
int technique_choose(TechniqueArgs *args, void *scene, GpDevice *device, json_t **told);

#endif
