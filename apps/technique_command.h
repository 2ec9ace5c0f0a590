/* The command of a technique: options made of its fields, a scene in, a picture out. */
#ifndef APPS_TECHNIQUE_COMMAND_H
#define APPS_TECHNIQUE_COMMAND_H

#include "apps/technique.h"

/* What argp prints. */
typedef struct TechniqueHelp {
    const char *arguments; /* "SCENE.json" */
    const char *text;      /* examples first; after \v what follows the options */
} TechniqueHelp;

/* Runs it as a subcommand: options of the fields, --error E (the cheapest setting of a stored chart
 * that comes so near to the truth), --curve FILE (that chart), -o FILE, and those of options_frame.
 * returns an exit code of commands.h */
int technique_command(const Technique *technique, const TechniqueHelp *help, int argc, char **argv);

#endif
