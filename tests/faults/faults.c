/* Lets every call of every command fail once, and looks at what is left.
 *
 *   faults PROGRAM LIBRARY [--most N] [--kind NAME] [--workers N] [COMMAND...]
 *
 * Each command of commands.c runs once as it is, with its calls counted (fail_calls.h), and then
 * once more for each call, which fails. What must hold each time: no signal; exit code 4 for
 * memory, mappings and threads, 3 or 4 for files, or 0 with the same output as ever, where the
 * failure could be borne, and the signal's own end where one came; one line that begins with
 * "glasspipe: " where it is not 0, which says "memory" where that was missing; each output file as
 * it was before or whole; no other file left; and when nothing fails after it, what came at first.
 *
 * --most N  at most N calls of a kind a command, evenly chosen; all otherwise
 * --kind NAME  calls of that kind alone
 * Speaks TAP, a test a command, then counts points by the kind of failure; exit code 1 where there
 * is a fault.
 */
#include "tests/faults/run.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

/* --- what must hold --------------------------------------------------------------------------- */

/* The reason in one line, after those of warnings, of other files that were written, and of a
 * script. */
static bool is_one_line(const char *text)
{
    static const char *const others[] = { "glasspipe: warning: ", "wrote ", "/" };
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        while (strncmp(text, others[i], strlen(others[i])) == 0 && strchr(text, '\n'))
            text = strchr(text, '\n') + 1;
    const char *end = strchr(text, '\n');
    return strncmp(text, "glasspipe", 9) == 0 && strstr(text, ": ") && end && end[1] == '\0';
}

/* Whether each output is as it was, or whole. */
static bool outputs_hold(const Command *command, const Run *good, const Run *run)
{
    for (int i = 0; i < run_outputs(command); i++)
        if (run->written[i] != run->before[i] && run->written[i] != good->written[i])
            return false;
    return true;
}

/* What is wrong with a run that says that it worked; NULL: nothing. A cache that cannot be written
 * is warned of. */
static const char *fault_of_done(const Command *command, const Run *good, const Run *run)
{
    const bool warned = strstr(run->says, "warning: o.cache");
    for (int i = 0; i < run_outputs(command); i++)
        if (run->written[i] != good->written[i] && !(warned && run->written[i] == run->before[i]))
            return "says that it worked, and wrote something else";
    return run->printed == good->printed ? NULL : "says that it worked, and printed something else";
}

/* Whether a library or the loader ended the program by itself, for want of memory: their words. */
static bool is_theirs(FailKind kind, const Run *run)
{
    static const char *const words[] = { "GLib-ERROR", "memory for thread-local data: ABORT",
                                         "Out of memory allocating bitmask" /* libnuma */ };
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (kind == FAIL_ALLOC && strstr(run->says, words[i]))
            return true;
    return false;
}

/* What is wrong with a run of which call n failed; NULL: nothing. */
static const char *fault_of(const Command *command, FailKind kind, unsigned long n, const Run *good,
                            const Run *run)
{
    static const int signals[] = { SIGINT, SIGTERM, SIGHUP };
    const bool stopped = kind >= FAIL_INTERRUPT;
    if (run->left[0])
        return "leaves a file";
    if (!outputs_hold(command, good, run))
        return "leaves half an output";
    if (stopped && run->calls[kind] >= n)
        return WIFSIGNALED(run->status) && WTERMSIG(run->status) == signals[kind - FAIL_INTERRUPT]
                   ? NULL
                   : "does not end by the signal";
    if (is_theirs(kind, run))
        return NULL;
    if (WIFSIGNALED(run->status))
        return WTERMSIG(run->status) == SIGALRM ? "hangs" : "crashes";
    const int code = WEXITSTATUS(run->status);
    const bool memory = kind == FAIL_ALLOC || kind == FAIL_MAP;
    if (code == 0)
        return fault_of_done(command, good, run);
    if (kind == FAIL_SHORT_READ || kind == FAIL_SHORT_WRITE)
        return "fails though nothing was wrong";
    if (memory || kind == FAIL_THREAD ? code != 4 : code != 3 && code != 4)
        return "has the wrong exit code";
    if (!is_one_line(run->says) && !(command->has_report && code == 3))
        return "does not say so in one line";
    return memory && !strstr(run->says, "memory") ? "does not say that memory was missing" : NULL;
}

/* --- the sweep -------------------------------------------------------------------------------- */

enum { MOST_WORKERS = 64, MOST_FAULTS = 20 /* of a command: then it is left */ };

typedef struct Sweep {
    Runner runner;
    unsigned long most;
    const char *kind; /* NULL: all */
    int workers;
    char folder[MOST_WORKERS][64];
} Sweep;

typedef struct Tally {
    unsigned long points[FAIL_KINDS], theirs, faults;
} Tally;

/* Where OpenImageIO runs, a library below it ends the program for want of a thread or a file
 * handle: these two are not tried. */
static bool is_tried(const Sweep *sweep, const Command *command, FailKind kind)
{
    if (sweep->kind && strcmp(sweep->kind, fail_kind_names[kind]) != 0)
        return false;
    return !strstr(command->line, ".exr") || (kind != FAIL_OPEN && kind != FAIL_THREAD);
}

static void tell(const Command *command, const char *fail, const char *fault, const Run *run)
{
    char says[sizeof run->says];
    snprintf(says, sizeof says, "%s", run->says);
    for (char *at = says; *at; at++)
        *at = *at == '\n' ? ' ' : *at;
    printf("# %s %s: %s (status %d): %s%s\n", command->name, fail, fault, run->status, run->left,
           says);
}

/* One worker's share of a kind's calls. */
static void sweep_kind(const Sweep *sweep, const Command *command, const Run *good, FailKind kind,
                       int worker, Tally *tally)
{
    const unsigned long calls = is_tried(sweep, command, kind) ? good->calls[kind] : 0;
    const unsigned long points = sweep->most && sweep->most < calls ? sweep->most : calls;
    Run run;
    for (unsigned long i = (unsigned long)worker; i < points; i += (unsigned long)sweep->workers) {
        const unsigned long n = i * calls / points + 1;
        char fail[64];
        snprintf(fail, sizeof fail, "%s:%lu", fail_kind_names[kind], n);
        run_command(&sweep->runner, command, fail, &run);
        const char *fault = fault_of(command, kind, n, good, &run);
        tally->points[kind]++;
        tally->theirs += is_theirs(kind, &run);
        tally->faults += fault != NULL;
        if (fault)
            tell(command, fail, fault, &run);
    }
    run_command(&sweep->runner, command, NULL, &run);
    const char *fault = run.status != 0 ? "fails" : fault_of_done(command, good, &run);
    tally->faults += fault != NULL;
    if (fault)
        tell(command, "after that", fault, &run);
}

/* All kinds, in the worker's own folder. */
static void work(const Sweep *sweep, const Command *command, int worker, Tally *tally)
{
    Run good;
    run_folder_enter(sweep->folder[worker]);
    run_command(&sweep->runner, command, NULL, &good);
    if (good.status != 0 || good.left[0]) {
        tally->faults = MOST_FAULTS;
        printf("# %s: does not work: %s%s\n", command->name, good.left, good.says);
    }
    for (FailKind kind = 0; kind < FAIL_KINDS && tally->faults < MOST_FAULTS; kind++)
        sweep_kind(sweep, command, &good, kind, worker, tally);
    fflush(stdout);
}

static void add(Tally *to, const Tally *tally)
{
    to->faults += tally->faults;
    to->theirs += tally->theirs;
    for (int kind = 0; kind < FAIL_KINDS; kind++)
        to->points[kind] += tally->points[kind];
}

static unsigned long points_of(const Tally *tally)
{
    unsigned long sum = 0;
    for (int kind = 0; kind < FAIL_KINDS; kind++)
        sum += tally->points[kind];
    return sum;
}

static Tally sweep_command(const Sweep *sweep, const Command *command, int number, Tally *shared)
{
    Tally sum = { .faults = 0 };
    memset(shared, 0, sizeof *shared * (size_t)sweep->workers);
    for (int worker = 0; worker < sweep->workers; worker++) {
        fflush(stdout);
        if (fork() == 0) {
            work(sweep, command, worker, &shared[worker]);
            _exit(0);
        }
    }
    for (int worker = 0; worker < sweep->workers; worker++)
        wait(NULL);
    for (int worker = 0; worker < sweep->workers; worker++)
        add(&sum, &shared[worker]);
    printf("%s %d - %-22s %6lu points %5lu faults\n", sum.faults ? "not ok" : "ok", number,
           command->name, points_of(&sum), sum.faults);
    return sum;
}

static bool is_chosen(const char *name, int count, char **names)
{
    bool chosen = count == 0;
    for (int i = 0; i < count; i++)
        chosen |= strcmp(names[i], name) == 0;
    return chosen;
}

int main(int argc, char **argv)
{
    Sweep sweep = { .workers = 2 };
    Runner *runner = &sweep.runner;
    if (argc < 3 || !realpath(argv[1], runner->program) || !realpath(argv[2], runner->library) ||
        !realpath("scenes", runner->scenes)) {
        fputs("usage: faults PROGRAM LIBRARY [--most N] [--kind NAME] [--workers N] [COMMAND...]\n",
              stderr);
        return 2;
    }
    int i = 3;
    for (; i + 1 < argc && argv[i][0] == '-'; i += 2)
        if (strcmp(argv[i], "--most") == 0)
            sweep.most = strtoul(argv[i + 1], NULL, 10);
        else if (strcmp(argv[i], "--kind") == 0)
            sweep.kind = argv[i + 1];
        else
            sweep.workers = atoi(argv[i + 1]);
    if (sweep.workers < 1 || sweep.workers > MOST_WORKERS)
        sweep.workers = 1;
    char needed[4096] = "";
    int commands = 0;
    for (const Command *command = fault_commands; command->name; command++)
        if (is_chosen(command->name, argc - i, argv + i)) {
            commands++;
            strncat(needed, command->needs ? command->needs : "", 100);
        }
    if (i < argc && commands < argc - i) {
        fputs("faults: a command that is not known; tests/faults/commands.c has them\n", stderr);
        return 2;
    }
    for (int worker = 0; worker < sweep.workers; worker++)
        run_folder_make(runner, needed, sweep.folder[worker]);
    printf("1..%d\n", commands);
    Tally *shared = mmap(NULL, sizeof *shared * (size_t)sweep.workers, PROT_READ | PROT_WRITE,
                         MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED)
        return 2;
    Tally all = { .faults = 0 };
    int number = 0;
    for (const Command *command = fault_commands; command->name; command++)
        if (is_chosen(command->name, argc - i, argv + i)) {
            const Tally tally = sweep_command(&sweep, command, ++number, shared);
            add(&all, &tally);
        }
    for (int worker = 0; worker < sweep.workers; worker++)
        run_folder_remove(sweep.folder[worker]);
    for (int kind = 0; kind < FAIL_KINDS; kind++)
        printf("# %-22s %7lu points\n", fail_kind_names[kind], all.points[kind]);
    printf("# %lu points, %d commands, %lu ended by a library or the loader, %lu faults\n",
           points_of(&all), commands, all.theirs, all.faults);
    return all.faults != 0;
}
