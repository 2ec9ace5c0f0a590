/* Options that the subcommands share, and how they talk to the user: results go to
 * stdout, everything else to stderr. */
#ifndef APPS_COMMANDS_OPTIONS_H
#define APPS_COMMANDS_OPTIONS_H

#include "apps/items/items.h"
#include "apps/scene/scene.h"
#include "apps/techniques/settings.h"
#include <glasspipe/glasspipe.h>

#include <stdio.h>

/* What the program tells its caller. */
enum {
    EXIT_DONE = 0,
    EXIT_DIFFERS = 1,  /* compared, and they differ; a check failed; an error was not reached */
    EXIT_USAGE = 2,    /* a wrong command, option or argument */
    EXIT_INPUT = 3,    /* an input file that is missing, broken, or asks for the impossible */
    EXIT_INTERNAL = 4, /* no memory, or the output could not be written */
};

/* A command puts this struct first in its own. */
typedef struct Options {
    bool json, quiet, verbose;
    uint32_t size[2]; /* 0 x 0: the scene's own */
    uint32_t threads; /* 0: one a processor */
    const char *isa;  /* NULL: automatic */
    GpExecutor executor;
    bool timed; /* GpDeviceDesc.timed */

    /* of commands whose work are items (OPTIONS_ITEMS) */
    double verify, timeout;
    bool resume;
} Options;

/* For the table of such a command. */
#define OPTIONS_ITEMS                                                                              \
    { "verify",                                                                                    \
      "P",                                                                                         \
      "Draw P per cent of the work a second time, by another thread or rank, and compare",         \
      SETTING_NUMBER,                                                                              \
      .offset = offsetof(Options, verify),                                                         \
      .low = 0,                                                                                    \
      .high = 100 },                                                                               \
        { "timeout",                                                                               \
          "S",                                                                                     \
          "End with a message where one item takes more than S seconds",                           \
          SETTING_NUMBER,                                                                          \
          .offset = offsetof(Options, timeout),                                                    \
          .low = 0,                                                                                \
          .high = 1e6 },                                                                           \
    {                                                                                              \
        "resume", NULL, "Note what is done in a journal, and go on from one that is there",        \
            SETTING_FLAG, .offset = offsetof(Options, resume)                                      \
    }

/* Which of them a command has: each has those before it too. */
typedef enum OptionsShared { OPTIONS_COMMON, OPTIONS_RUN, OPTIONS_FRAME } OptionsShared;

extern const SettingField options_common[]; /* --json, -q, -v */
extern const SettingField options_run[];    /* --threads, --isa, --executor */
extern const SettingField options_frame[];  /* --size */

/* The most that a number without a limit may be. */
#define OPTIONS_ANY 1e300

/* Creates the device that the options ask for.
 * returns EXIT_DONE, or an exit code after a message: an isa that does not exist or that this
 * machine lacks is a usage error */
int options_device(const Options *options, const GpTrace *trace, GpDevice **device);

/* How items are run, but for the journal, its key and progress. */
ItemRun options_items(const Options *options);

/* Reads a scene, in the size that the options ask for. returns as options_device */
int options_scene(const Options *options, const char *path, Scene *scene);

/* Prints "glasspipe: " and a line to stderr, as message_print does; returns code, so that a caller
 * can return it. */
int report(int code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Tells another one than stderr of errors, without "glasspipe: "; NULL: stderr again. */
void report_to(void (*tell)(int code, const char *line));

/* The same for news that is not an error; nothing with --quiet. */
void notice(const Options *options, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Prints a text in one line, whatever a file says: control characters as \xNN. */
void message_print(FILE *file, const char *text);

/* Exit code of a failure to read what the user gave. */
int exit_of_input(GpResult result);

/* The same for a failure to run it: GP_ERROR_UNSUPPORTED is then an --isa that lacks a program. */
int exit_of_run(GpResult result);

/* Whether stdout should be coloured: a terminal that can, and no NO_COLOR. */
bool stdout_wants_color(void);

#endif
