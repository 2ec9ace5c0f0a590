/* Options that the subcommands share, parsed by argp, and how they talk to the user: results go to
 * stdout, everything else to stderr. */
#ifndef APPS_COMMANDS_OPTIONS_H
#define APPS_COMMANDS_OPTIONS_H

#include "pipeline/glasspipe.h"

#include <argp.h>

/* Set by the parsers below. A command puts this struct first in its own, so that one pointer
 * serves as input of both its own parser and these. */
typedef struct Options {
    bool json, quiet, verbose;
    uint32_t width, height; /* --size; 0: the scene's own */
    int threads;            /* 0: one a processor */
    const char *isa;        /* NULL: automatic */
    GpExecutor executor;
    bool timed; /* GpDeviceDesc.timed */
} Options;

/* --json, -q, -v, -h, --usage, --version. */
extern const struct argp options_common;

/* --threads, --isa, --executor, and the common ones. */
extern const struct argp options_run;

/* --size, and those of options_run. */
extern const struct argp options_frame;

/* Parses a command's arguments into args, which begins with an Options. Does not return after a
 * usage error (exit 2), --help, --usage or --version (exit 0). */
void options_parse(const struct argp *parser, int argc, char **argv, void *args);

/* Help filter of every command's parser: drops argp's note about arguments of short options. */
char *options_help(int key, const char *text, void *args);

/* To be called by a command's parser on ARGP_KEY_INIT: hands args to its one child. */
error_t options_start(struct argp_state *state);

/* Decimal number without sign or trailing text, low..high; usage error (exit 2) naming `what`. */
long options_number(struct argp_state *state, const char *what, const char *text, long low,
                    long high);

/* WIDTHxHEIGHT, such as 1024x768; usage error naming `what`. */
void options_size(struct argp_state *state, const char *what, const char *text, uint32_t *width,
                  uint32_t *height);

/* Finite decimal number, not negative; usage error naming `what`. */
double options_real(struct argp_state *state, const char *what, const char *text);

/* The next positional argument: fills the first empty slot; a usage error past the last.
 * in   slots: count pointers, NULL where still empty */
error_t options_positional(struct argp_state *state, const char **slots, int count, char *text);

/* Creates the device that the options ask for.
 * returns EXIT_DONE, or an exit code after a message: an isa that does not exist or that this
 * machine lacks is a usage error */
int options_device(const Options *options, const GpTrace *trace, GpDevice **device);

/* Prints "glasspipe: " and a line to stderr; returns code, so that a caller can return it. */
int report(int code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same for news that is not an error; nothing with --quiet. */
void notice(const Options *options, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Exit code of a failure to read what the user gave. */
int exit_of_input(GpResult result);

/* The same for a failure to run it: GP_ERROR_UNSUPPORTED is then an --isa that lacks a program. */
int exit_of_run(GpResult result);

/* Whether stdout should be coloured: a terminal that can, and no NO_COLOR. */
bool stdout_wants_color(void);

#endif
