#include "apps/commands/options.h"

#include "apps/techniques/shadow/shadowed.h"
#include "pipeline/io/file.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_MESSAGE = 16384 };

static const char *const isa_names[] = { "auto", "sse2", "avx2", "avx512", "neon", NULL };
static const char *const executor_names[] = { "fast", "reference", NULL };

const SettingField options_common[] = {
    { "json", NULL, "Print the result as one JSON object", SETTING_FLAG,
      .offset = offsetof(Options, json) },
    { "quiet", NULL, "Print no messages but errors", SETTING_FLAG,
      .offset = offsetof(Options, quiet), .letter = 'q' },
    { "verbose", NULL, "Print more messages", SETTING_FLAG, .offset = offsetof(Options, verbose),
      .letter = 'v' },
    { .name = NULL },
};

const SettingField options_run[] = {
    { "threads", "N",
      "Number of threads, 1 to 1024 (default: one a processor); never changes a bit",
      SETTING_INTEGER, .offset = offsetof(Options, threads), 1, 1024 },
    { "isa", "NAME",
      "Instruction set: auto, sse2, avx2, avx512 or neon (default: $GP_ISA, else auto); "
      "never changes a bit",
      SETTING_TEXT, .offset = offsetof(Options, isa), .names = isa_names },
    { "executor", "NAME",
      "fast (default) or reference: the same bits, from units that can be read and "
      "traced",
      SETTING_NAME, .offset = offsetof(Options, executor), .names = executor_names },
    { .name = NULL },
};

const SettingField options_frame[] = {
    { "size", "WxH", "Size of the picture in pixels, 1x1 to 8192x8192 (default: the scene's)",
      SETTING_SIZE, .offset = offsetof(Options, size), 1, GP_MAX_SIZE },
    { .name = NULL },
};

int options_device(const Options *options, const GpTrace *trace, GpDevice **device)
{
    GpDeviceDesc desc = {
        .executor = options->executor,
        .threads = (int)options->threads,
        .isa = options->isa,
        .timed = options->timed,
    };
    if (trace) {
        desc.trace = *trace;
        if (!trace->only_wanted)
            desc.executor = GP_EXECUTOR_REFERENCE;
        desc.trace.only_wanted = desc.executor == GP_EXECUTOR_FAST;
    }

    GpError error = { "" };
    GpResult result = gp_device_create(&desc, device, &error);
    if (!result)
        return EXIT_DONE;
    const bool asked_wrongly = result == GP_ERROR_INVALID || result == GP_ERROR_UNSUPPORTED;
    const bool by_option = options->isa && strcmp(options->isa, "auto") != 0;
    return report(asked_wrongly ? EXIT_USAGE : EXIT_INTERNAL, "%s%s",
                  asked_wrongly && !by_option && getenv("GP_ISA") ? "$GP_ISA: " : "", error.text);
}

/* Nothing is half written where this is called from, but for what is abandoned. */
static void end_now(int code, const char *line)
{
    gp_file_abandon();
    report(code, "%s", line);
    fflush(stdout);
    _exit(code);
}

ItemRun options_items(const Options *options)
{
    return (ItemRun){ .device = { .executor = options->executor,
                                  .threads = (int)options->threads,
                                  .isa = options->isa },
                      .verify = options->verify,
                      .timeout = options->timeout,
                      .end = end_now,
                      .resume = options->resume };
}

int options_scene(const Options *options, const char *path, Scene *scene)
{
    const SceneOptions size = { .width = options->size[0], .height = options->size[1] };
    GpError error = { "" };
    GpResult result = shadowed_scene_load(path, &size, scene, &error);
    return result ? report(exit_of_input(result), "%s", error.text) : EXIT_DONE;
}

/* --- messages --------------------------------------------------------------------------------- */

void message_print(FILE *file, const char *text)
{
    const unsigned char *at = (const unsigned char *)text;
    for (; *at; at++)
        if (at[0] == 0xc2 && at[1] >= 0x80 && at[1] < 0xa0) { /* U+0080 to U+009F */
            fprintf(file, "\\x%02x\\x%02x", at[0], at[1]);
            at++;
        } else if (*at < ' ' || *at == 0x7f) {
            fprintf(file, "\\x%02x", *at);
        } else {
            putc(*at, file);
        }
}

/* A line; longer ones are cut. There may be no memory for them. */
static void print_line(const char *before, const char *format, va_list args)
{
    char line[MOST_MESSAGE];
    vsnprintf(line, sizeof line, format, args);
    fputs(before, stderr);
    message_print(stderr, line);
    fputc('\n', stderr);
}

static void (*told)(int code, const char *line);

void report_to(void (*tell)(int code, const char *line))
{
    told = tell;
}

int report(int code, const char *format, ...)
{
    char line[1024];
    va_list args;
    va_start(args, format);
    if (told) {
        vsnprintf(line, sizeof line, format, args);
        va_end(args);
        told(code, line);
        return code;
    }
    print_line("glasspipe: ", format, args);
    va_end(args);
    return code;
}

void notice(const Options *options, const char *format, ...)
{
    if (options->quiet)
        return;
    va_list args;
    va_start(args, format);
    print_line("", format, args);
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
