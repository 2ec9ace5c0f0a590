#include "apps/program.h"

#include "apps/dispatch.h"
#include "apps/commands/options.h"
#include "pipeline/io/file.h"

#include <errno.h>
#include <fcntl.h>
#include <jansson.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int dispatch(int argc, char **argv)
{
    const char *name = argv[1];
    bool help = strcmp(name, "help") == 0;
    if (help && argc > 2 && strcmp(argv[2], "help") != 0) {
        char option[] = "--help";
        char *arguments[] = { NULL, argc > 3 ? argv[3] : option, option, NULL };
        return commands_run(argv[2], 3, arguments);
    }
    if (help || strcmp(name, "-h") == 0 || strcmp(name, "--help") == 0) {
        commands_help(stdout);
        return EXIT_DONE;
    }
    if (strcmp(name, "--version") == 0) {
        puts("glasspipe " GP_VERSION);
        return EXIT_DONE;
    }
    return commands_run(name, argc - 1, argv + 1);
}

/* A result that did not reach its reader is a failure. Runs at exit, whoever calls it. */
static void close_stdout(void)
{
    bool failed = ferror(stdout) != 0;
    errno = 0;
    if (fclose(stdout) != 0 || failed) {
        const char *reason = errno ? strerror(errno) : "write error";
        _exit(report(EXIT_INTERNAL, "standard output: %s", reason));
    }
}

/* Nothing is half written where this is called from, but other threads may be about to. */
static void end_without_memory(void)
{
    gp_file_abandon();
    _exit(report(EXIT_INTERNAL, "no memory"));
}

/* Objects of JSON are made member by member in many places; one that lacks members must never pass
 * for whole. */
static void *json_memory(size_t size)
{
    void *memory = malloc(size);
    if (!memory)
        end_without_memory();
    return memory;
}

/* Where a caller closed descriptor 0, 1 or 2, the next file opened would take its number and
 * receive our messages. They are filled here with ones that refuse the operation. */
static void reserve_standard_files(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0)
            (void)!open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

static void (*last_words)(int number);

void program_set_last_words(void (*say)(int number))
{
    last_words = say;
}

/* Ends the program as the signal would have, with no file left half made. Whoever sends one may
 * send more, and another thread may be given them: the first is seen to its end. */
static void end_by_signal(int number)
{
    static atomic_flag is_ending = ATOMIC_FLAG_INIT;
    if (atomic_flag_test_and_set(&is_ending))
        return;
    gp_file_abandon();
    if (last_words) {
        last_words(number);
        gp_file_abandon(); /* other threads wrote on meanwhile */
    }
    signal(number, SIG_DFL);
    raise(number); /* as soon as this returns */
}

/* What is ignored stays so: nohup asked for it. */
static void handle_signals(void)
{
    static const int ends[] = { SIGINT, SIGTERM, SIGHUP };
    const struct sigaction handle = { .sa_handler = end_by_signal, .sa_flags = SA_RESTART };
    for (size_t i = 0; i < GP_COUNT(ends); i++) {
        struct sigaction old;
        if (sigaction(ends[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN)
            sigaction(ends[i], &handle, NULL);
    }
}

int program_run(int argc, char **argv)
{
    if (argc < 2) {
        commands_help(stderr);
        return EXIT_USAGE;
    }
    return dispatch(argc, argv);
}

void program_begin(void)
{
    reserve_standard_files();
    handle_signals();
    signal(SIGPIPE, SIG_IGN); /* write errors like any other, for close_stdout and the writers */
    signal(SIGXFSZ, SIG_IGN);
    gp_call_without_memory(end_without_memory);
    json_set_alloc_funcs(json_memory, free);
    atexit(close_stdout);
}
