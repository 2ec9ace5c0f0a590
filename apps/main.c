/* The program `glasspipe`: runs the subcommand and makes sure that its output arrived. */
#include "apps/commands/commands.h"
#include "apps/commands/options.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int dispatch(int argc, char **argv)
{
    const char *name = argv[1];
    bool help = strcmp(name, "help") == 0;
    if (help && argc > 2) {
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

/* Where a caller closed descriptor 0, 1 or 2, the next file opened would take its number and
 * receive our messages. They are filled here with ones that refuse the operation. */
static void reserve_standard_files(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0)
            (void)!open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int main(int argc, char **argv)
{
    reserve_standard_files();
    signal(SIGPIPE, SIG_IGN); /* write errors like any other, for close_stdout and the writers */
    signal(SIGXFSZ, SIG_IGN);
    atexit(close_stdout);
    if (argc < 2) {
        commands_help(stderr);
        return EXIT_USAGE;
    }
    return dispatch(argc, argv);
}
