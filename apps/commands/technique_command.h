/* The command of a technique: options made of its fields, a scene in, a picture or a volume out. */
#ifndef APPS_COMMANDS_TECHNIQUE_COMMAND_H
#define APPS_COMMANDS_TECHNIQUE_COMMAND_H

#include "apps/commands/options.h"
#include "apps/techniques/technique.h"

enum { TECHNIQUE_MAX_OPTIONS = 16, TECHNIQUE_FIRST_KEY = 0x300 };

/* One run of a command, as far as all techniques have it. Borrowed. */
typedef struct TechniqueRun {
    const Options *options;
    const Technique *technique;
    const char *input, *output; /* what the user named, and the path to write to */
    const void *setting;
    void *scene;
    GpDevice *device;
    void *own;
} TechniqueRun;

/* What a command has of its own where its result is no picture: it has no --size WxH then. */
typedef struct TechniqueResult {
    const char *input;                 /* "a mesh file" */
    const char *output_help;           /* of -o */
    const char *extension;             /* of a file that was not named: "nrrd" */
    const char *count_field;           /* the field that -n sets too */
    const struct argp_option *options; /* up to TECHNIQUE_MAX_OPTIONS; keys from .._FIRST_KEY on */

    /* Takes such an option. returns as argp's parsers do */
    error_t (*parse)(int key, char *text, struct argp_state *state, void *own);
    /* Whether the output could be written, as far as its name tells, and own options go with it.
     * errors GP_ERROR_INVALID */
    GpResult (*check)(const char *output, const void *setting, const void *own, GpError *error);
    /* Builds, draws, writes and prints. returns an exit code, after a message if it is not EXIT_DONE */
    int (*run)(const TechniqueRun *run);
    void *own; /* the command's own options, for parse and run */
} TechniqueResult;

typedef struct TechniqueHelp {
    const char *arguments;         /* "SCENE.json" */
    const char *text;              /* examples first; after \v what follows the options */
    const TechniqueResult *result; /* NULL: a picture */
} TechniqueHelp;

/* Runs it as a subcommand: options of the fields, --error E (the cheapest setting of a stored chart
 * that comes so near to the truth), --curve FILE (that chart), -o FILE, those of the result, and
 * those of options_frame or options_run.
 * returns an exit code of commands.h */
int technique_command(const Technique *technique, const TechniqueHelp *help, int argc, char **argv);

#endif
