#include "apps/commands/options.h"

#include "apps/commands/commands.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

enum {
    MAX_THREADS = 1024,

    KEY_JSON = 0x100, /* options without a letter */
    KEY_USAGE,
    KEY_VERSION,
    KEY_SIZE,
    KEY_THREADS,
    KEY_ISA,
    KEY_EXECUTOR,
};

/* clang-format off */
static const struct argp_option common_options[] = {
    { "json", KEY_JSON, NULL, 0, "Print the result as one JSON object", 0 },
    { "quiet", 'q', NULL, 0, "Print no messages but errors", 0 },
    { "verbose", 'v', NULL, 0, "Print more messages", 0 },
    { "help", 'h', NULL, 0, "Show this help", -1 },
    { "usage", KEY_USAGE, NULL, 0, "Show a short usage line", -1 },
    { "version", KEY_VERSION, NULL, 0, "Show the version", -1 },
    { NULL, 0, NULL, 0, NULL, 0 },
};

static const struct argp_option frame_options[] = {
    { "size", KEY_SIZE, "WxH", 0, "Size of the picture in pixels, 1x1 to 8192x8192 "
      "(default: the scene's)", 0 },
    { NULL, 0, NULL, 0, NULL, 0 },
};

static const struct argp_option run_options[] = {
    { "threads", KEY_THREADS, "N", 0, "Number of threads, 1 to 1024 (default: one a processor); "
      "never changes a bit", 0 },
    { "isa", KEY_ISA, "NAME", 0, "Instruction set: auto, sse2, avx2, avx512 or neon "
      "(default: $GP_ISA, else auto); never changes a bit", 0 },
    { "executor", KEY_EXECUTOR, "NAME", 0, "fast (default) or reference: the same bits, from "
      "units that can be read and traced", 0 },
    { NULL, 0, NULL, 0, NULL, 0 },
};
/* clang-format on */

/* --- the three shared parsers ---------------------------------------------------------------------
 */

static error_t parse_common(int key, char *text, struct argp_state *state)
{
    (void)text;
    Options *options = state->input;
    switch (key) {
    case KEY_JSON:
        options->json = true;
        return 0;
    case 'q':
        options->quiet = true;
        return 0;
    case 'v':
        options->verbose = true;
        return 0;
    case 'h':
        argp_state_help(state, stdout, ARGP_HELP_STD_HELP);
        return 0;
    case KEY_USAGE:
        argp_state_help(state, stdout, ARGP_HELP_USAGE | ARGP_HELP_EXIT_OK);
        return 0;
    case KEY_VERSION:
        puts("glasspipe " GP_VERSION);
        exit(EXIT_DONE);
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void parse_isa(struct argp_state *state, const char *text, Options *options)
{
    static const char *const names[] = { "auto", "sse2", "avx2", "avx512", "neon" };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        if (strcmp(text, names[i]) == 0) {
            options->isa = names[i];
            return;
        }
    }
    argp_error(state, "--isa %s: expected auto, sse2, avx2, avx512 or neon", text);
}

static error_t parse_run(int key, char *text, struct argp_state *state)
{
    Options *options = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        return options_start(state);
    case KEY_THREADS:
        options->threads = (int)options_number(state, "--threads", text, 1, MAX_THREADS);
        return 0;
    case KEY_ISA:
        parse_isa(state, text, options);
        return 0;
    case KEY_EXECUTOR:
        if (strcmp(text, "fast") != 0 && strcmp(text, "reference") != 0)
            argp_error(state, "--executor %s: expected fast or reference", text);
        options->executor = strcmp(text, "fast") == 0 ? GP_EXECUTOR_FAST : GP_EXECUTOR_REFERENCE;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse_frame(int key, char *text, struct argp_state *state)
{
    Options *options = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        return options_start(state);
    case KEY_SIZE:
        options_size(state, "--size", text, &options->width, &options->height);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp options_common = { common_options, parse_common, NULL, NULL, NULL, NULL, NULL };

static const struct argp_child run_children[] = {
    { &options_common, 0, NULL, 0 },
    { NULL, 0, NULL, 0 },
};

const struct argp options_run = { run_options, parse_run, NULL, NULL, run_children, NULL, NULL };

static const struct argp_child frame_children[] = {
    { &options_run, 0, NULL, 0 },
    { NULL, 0, NULL, 0 },
};

const struct argp options_frame = { frame_options,  parse_frame, NULL, NULL,
                                    frame_children, NULL,        NULL };

void options_parse(const struct argp *parser, int argc, char **argv, void *args)
{
    argp_err_exit_status = EXIT_USAGE;
    /* argp's own help has no -h, hence ARGP_NO_HELP. */
    if (argp_parse(parser, argc, argv, ARGP_NO_HELP, NULL, args))
        exit(report(EXIT_INTERNAL, "out of memory"));
}

char *options_help(int key, const char *text, void *args)
{
    (void)args;
    return key == ARGP_KEY_HELP_DUP_ARGS_NOTE ? NULL : (char *)text;
}

error_t options_start(struct argp_state *state)
{
    state->child_inputs[0] = state->input;
    return 0;
}

/* --- arguments ----------------------------------------------------------------------------------
 */

long options_number(struct argp_state *state, const char *what, const char *text, long low,
                    long high)
{
    char *end;
    errno = 0;
    long value = strtol(text, &end, 10);
    bool digits = text[0] >= '0' && text[0] <= '9' && *end == '\0';
    if (!digits || errno || value < low || value > high)
        argp_error(state, "%s: '%s' is not a whole number in [%ld, %ld]", what, text, low, high);
    return value;
}

void options_size(struct argp_state *state, const char *what, const char *text, uint32_t *width,
                  uint32_t *height)
{
    char digits[2][8] = { "", "" }, rest, name[32];
    if (sscanf(text, "%7[0-9]x%7[0-9]%c", digits[0], digits[1], &rest) != 2)
        argp_error(state, "%s %s: expected WIDTHxHEIGHT, such as 1024x768", what, text);
    snprintf(name, sizeof name, "%s, width", what);
    *width = (uint32_t)options_number(state, name, digits[0], 1, GP_MAX_SIZE);
    snprintf(name, sizeof name, "%s, height", what);
    *height = (uint32_t)options_number(state, name, digits[1], 1, GP_MAX_SIZE);
}

double options_real(struct argp_state *state, const char *what, const char *text)
{
    char *end;
    double value = strtod(text, &end);
    if (end == text || *end != '\0' || !isfinite(value) || value < 0)
        argp_error(state, "%s: '%s' is not a number >= 0", what, text);
    return value;
}

error_t options_positional(struct argp_state *state, const char **slots, int count, char *text)
{
    for (int i = 0; i < count; i++) {
        if (!slots[i]) {
            slots[i] = text;
            return 0;
        }
    }
    argp_error(state, "unexpected argument '%s'", text);
    return EINVAL;
}

/* --- device and messages ------------------------------------------------------------------------
 */

int options_device(const Options *options, const GpTrace *trace, GpDevice **device)
{
    GpDeviceDesc desc = {
        .executor = options->executor,
        .threads = options->threads,
        .isa = options->isa,
        .timed = options->timed,
    };
    if (trace) { /* only one of the two can be watched */
        desc.executor = GP_EXECUTOR_REFERENCE;
        desc.trace = *trace;
    }

    GpError error = { "" };
    GpResult result = gp_device_create(&desc, device, &error);
    if (!result)
        return EXIT_DONE;
    bool asked_wrongly = result == GP_ERROR_INVALID || result == GP_ERROR_UNSUPPORTED;
    return report(asked_wrongly ? EXIT_USAGE : EXIT_INTERNAL, "%s", error.text);
}

int report(int code, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fputs("glasspipe: ", stderr);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
    return code;
}

void notice(const Options *options, const char *format, ...)
{
    if (options->quiet)
        return;
    va_list args;
    va_start(args, format);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
}

int exit_of_input(GpResult result)
{
    if (!result)
        return EXIT_DONE;
    return result == GP_ERROR_MEMORY ? EXIT_INTERNAL : EXIT_INPUT;
}

int exit_of_run(GpResult result)
{
    return result == GP_ERROR_UNSUPPORTED ? EXIT_USAGE : exit_of_input(result);
}

bool stdout_wants_color(void)
{
    const char *no_color = getenv("NO_COLOR"), *term = getenv("TERM");
    if (no_color && no_color[0])
        return false;
    return isatty(STDOUT_FILENO) && term && strcmp(term, "dumb") != 0;
}
