/* Lets every call of every command fail once, and looks at what is left.
 *
 *   faults PROGRAM LIBRARY [--most N] [--workers N] [COMMAND...]
 *
 * Each command below runs once as it is, with its calls counted (fail_calls.h), and then once more for
 * each call, which fails. What must hold each time: no signal; exit code 4 for memory, mappings and
 * threads, 3 or 4 for files, or 0 with the same output as ever, where the failure could be borne, and the
 * signal's own end where one came; one
 * line that begins with "glasspipe: " where it is not 0, which says "memory" where that was missing; the
 * output file as it was before or whole; and no other file left.
 *
 * --most N  at most N calls of a kind a command, evenly chosen; all otherwise
 * Prints a line a command and kind, and each fault; exit code 1 where there is one.
 */
#include "tests/faults/fail_calls.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* --- what is run ------------------------------------------------------------------------------ */

typedef struct Command {
    const char *name, *output; /* output: the file that it writes; NULL: none */
    const char *arguments[20]; /* SCENES/ stands for the folder of scenes */
} Command;

static const Command commands[] = {
    { "render", "o.png", { "render", "SCENES/default.json", "--size", "32x32", "-o", "o.png" } },
    { "render-exr", "o.exr", { "render", "SCENES/mrt.json", "--size", "32x32", "-o", "o.exr" } },
    { "render-json",
      "o.png",
      { "render", "SCENES/shadow.json", "--size", "32x32", "--json", "-q", "-o", "o.png" } },
    { "render-reference",
      "o.ppm",
      { "render", "SCENES/toon.json", "--size", "32x32", "--executor", "reference", "-o",
        "o.ppm" } },
    { "sorted", "o.png", { "render", "SCENES/sorted.json", "--size", "32x32", "-o", "o.png" } },
    { "explain", NULL, { "explain", "SCENES/default.json" } },
    { "explain-json", NULL, { "explain", "SCENES/default.json", "--json" } },
    { "pixel", NULL, { "pixel", "SCENES/default.json", "16", "16", "--size", "32x32" } },
    { "pixel-json",
      NULL,
      { "pixel", "SCENES/default.json", "16", "16", "--size", "32x32", "--json" } },
    { "compare", "d.png", { "compare", "old.png", "old.png", "-o", "d.png" } },
    { "shadow", "o.png", { "shadow", "SCENES/shadow.json", "--size", "32x32", "-o", "o.png" } },
    { "shadow-adaptive",
      "o.png",
      { "shadow", "SCENES/shadow.json", "--fit", "adaptive", "--size", "32x32", "-o", "o.png" } },
    { "voxelize", "o.nrrd", { "voxelize", "builtin:sphere", "-n", "16", "-o", "o.nrrd" } },
    { "points", "o.png", { "points", "builtin:sphere", "--size", "32x32", "-o", "o.png" } },
    { "volume", "o.png", { "volume", "builtin:marschner-lobb", "--size", "32x32", "-o", "o.png" } },
    { "volume-splat",
      "o.png",
      { "volume", "builtin:marschner-lobb", "--method", "splat", "--size", "32x32", "-o",
        "o.png" } },
    { "warp", "o.png", { "warp", "builtin:sphere", "--size", "32x32", "-o", "o.png" } },
    { "warp-capture",
      "o.exr",
      { "warp", "capture", "builtin:sphere", "--size", "32x32", "-o", "o.exr" } },
    { "fragments", "o.png", { "fragments", "builtin:sphere", "--size", "32x32", "-o", "o.png" } },
    { "fragments-convex",
      "o.png",
      { "fragments", "builtin:sphere", "--method", "convex", "--size", "32x32", "-o", "o.png" } },
    { "bench", NULL, { "bench", "small_draws", "--threads", "2", "-t", "0.001" } },
};

enum { COMMANDS = sizeof commands / sizeof commands[0] };

typedef struct Sweep {
    char program[PATH_MAX], library[PATH_MAX], scenes[PATH_MAX];
    unsigned long most;
    int workers;
} Sweep;

/* --- one run ---------------------------------------------------------------------------------- */

typedef struct Run {
    int status; /* as waitpid says */
    char says[4096];
    unsigned long long printed;         /* hash of stdout */
    unsigned long long before, written; /* of the output file, before and after; 0: no file */
    char left[NAME_MAX + 1];            /* a file that should not be there; "": none */
    unsigned long calls[FAIL_KINDS];
} Run;

enum { SECONDS = 60 };

/* FNV-1a of a file; 0 where there is none. */
static unsigned long long hash_of(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return 0;
    unsigned long long hash = 14695981039346656037u;
    for (int byte; (byte = getc(file)) != EOF;)
        hash = (hash ^ (unsigned)byte) * 1099511628211u;
    fclose(file);
    return hash;
}

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    if (!file || fputs(text, file) < 0 || fclose(file) != 0) {
        perror(path);
        exit(2);
    }
}

static void start(const Sweep *sweep, const Command *command, const char *fail)
{
    char place[20][PATH_MAX + 256];
    char *arguments[22] = { (char *)sweep->program };
    for (int i = 0; i < 20 && command->arguments[i]; i++) {
        const char *text = command->arguments[i];
        if (strncmp(text, "SCENES/", 7) == 0) {
            snprintf(place[i], sizeof place[i], "%s/%s", sweep->scenes, text + 7);
            text = place[i];
        }
        arguments[i + 1] = (char *)text;
    }
    setenv("GP_FAIL_COUNTS", "counts", 1);
    if (fail)
        setenv("GP_FAIL", fail, 1);
    setenv("LD_PRELOAD", sweep->library, 1);
    const int out = open("stdout", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const int err = open("stderr", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    alarm(SECONDS);
    execv(sweep->program, arguments);
    _exit(127);
}

static void look_for_left(const Command *command, char left[NAME_MAX + 1])
{
    static const char *const known[] = { ".", "..", "stdout", "stderr", "counts", "old.png" };
    left[0] = '\0';
    DIR *folder = opendir(".");
    for (struct dirent *entry; folder && (entry = readdir(folder));) {
        bool expected = command->output && strcmp(entry->d_name, command->output) == 0;
        for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
            expected |= strcmp(entry->d_name, known[i]) == 0;
        if (!expected)
            snprintf(left, NAME_MAX + 1, "%s", entry->d_name);
    }
    if (folder)
        closedir(folder);
}

/* Runs a command in the current folder; fail: "alloc:17", NULL: nothing fails. */
static void run_command(const Sweep *sweep, const Command *command, const char *fail, Run *run)
{
    memset(run, 0, sizeof *run);
    if (command->output)
        write_text(command->output, "what was there before");
    run->before = command->output ? hash_of(command->output) : 0;
    const int handle = open("counts", O_RDWR | O_CREAT | O_TRUNC, 0666);
    if (handle < 0 || ftruncate(handle, sizeof(FailCounts)) != 0) {
        perror("counts");
        exit(2);
    }
    const pid_t child = fork();
    if (child == 0)
        start(sweep, command, fail);
    waitpid(child, &run->status, 0);

    FailCounts counts;
    if (pread(handle, &counts, sizeof counts, 0) == sizeof counts)
        for (int kind = 0; kind < FAIL_KINDS; kind++)
            run->calls[kind] = counts.calls[kind];
    close(handle);
    run->printed = hash_of("stdout");
    run->written = command->output ? hash_of(command->output) : 0;
    FILE *says = fopen("stderr", "rb");
    if (says) {
        run->says[fread(run->says, 1, sizeof run->says - 1, says)] = '\0';
        fclose(says);
    }
    look_for_left(command, run->left);
    if (run->left[0])
        unlink(run->left);
}

/* --- what must hold --------------------------------------------------------------------------- */

static bool is_one_line(const char *text)
{
    const char *end = strchr(text, '\n');
    return strncmp(text, "glasspipe: ", 11) == 0 && end && end[1] == '\0';
}

/* What is wrong with a run whose call failed; NULL: nothing. */
static const char *fault_of(const Command *command, FailKind kind, const Run *good, const Run *run)
{
    static const int signals[] = { SIGINT, SIGTERM, SIGHUP };
    const bool stopped = kind >= FAIL_INTERRUPT;
    if (run->left[0])
        return "leaves a file";
    if (command->output && run->written != run->before && run->written != good->written)
        return "leaves half an output";
    if (stopped)
        return WIFSIGNALED(run->status) && WTERMSIG(run->status) == signals[kind - FAIL_INTERRUPT]
                   ? NULL
                   : "does not end by the signal";
    if (WIFSIGNALED(run->status))
        return WTERMSIG(run->status) == SIGALRM ? "hangs" : "crashes";
    const int code = WEXITSTATUS(run->status);
    const bool memory = kind == FAIL_ALLOC || kind == FAIL_MAP;
    const bool harmless = kind == FAIL_SHORT_READ || kind == FAIL_SHORT_WRITE;
    if (code == 0) {
        if (command->output && run->written != good->written)
            return "says that it worked, and wrote something else";
        return run->printed == good->printed ? NULL
                                             : "says that it worked, and printed something else";
    }
    if (harmless)
        return "fails though nothing was wrong";
    if (memory || kind == FAIL_THREAD ? code != 4 : code != 3 && code != 4)
        return "has the wrong exit code";
    if (!is_one_line(run->says))
        return "does not say so in one line";
    return memory && !strstr(run->says, "memory") ? "does not say that memory was missing" : NULL;
}

/* --- the sweep -------------------------------------------------------------------------------- */

/* Where OpenImageIO runs, a library below it ends the program for want of a thread or a file handle: these
 * two are not tried. */
static bool is_tried(const Command *command, FailKind kind)
{
    const char *dot = command->output ? strrchr(command->output, '.') : NULL;
    return !dot || strcmp(dot, ".exr") != 0 || (kind != FAIL_OPEN && kind != FAIL_THREAD);
}

/* Whether what a command prints is the same each time: times are not. */
static bool printed_varies(const Command *command)
{
    return strcmp(command->arguments[0], "bench") == 0 ||
           (command->output && strstr(command->name, "json"));
}

typedef struct Tally {
    unsigned long points, faults;
} Tally;

/* One worker's share of a kind's calls, in a folder of its own. */
static Tally sweep_kind(const Sweep *sweep, const Command *command, const Run *good, FailKind kind,
                        int worker)
{
    Tally tally = { 0, 0 };
    const unsigned long calls = is_tried(command, kind) ? good->calls[kind] : 0;
    const unsigned long points = sweep->most && sweep->most < calls ? sweep->most : calls;
    for (unsigned long i = (unsigned long)worker; i < points; i += (unsigned long)sweep->workers) {
        char fail[64];
        snprintf(fail, sizeof fail, "%s:%lu", fail_kind_names[kind], i * calls / points + 1);
        Run run;
        run_command(sweep, command, fail, &run);
        if (printed_varies(command))
            run.printed = good->printed;
        const char *fault = fault_of(command, kind, good, &run);
        tally.points++;
        tally.faults += fault != NULL;
        if (fault)
            printf("%s %s: %s (status %d): %s%s\n", command->name, fail, fault, run.status,
                   run.left, run.says);
    }
    fflush(stdout);
    return tally;
}

static void make_folder(int worker, char folder[64])
{
    snprintf(folder, 64, "/tmp/glasspipe-faults-%d-XXXXXX", worker);
    if (!mkdtemp(folder) || chdir(folder) != 0) {
        perror(folder);
        exit(2);
    }
}

static void remove_folder(const char *folder)
{
    DIR *entries = opendir(folder);
    for (struct dirent *entry; entries && (entry = readdir(entries));)
        unlink(entry->d_name);
    if (entries)
        closedir(entries);
    rmdir(folder);
}

/* Its picture for `compare'. */
static void make_inputs(const Sweep *sweep)
{
    static const Command picture = { "picture",
                                     NULL,
                                     { "render", "SCENES/default.json", "--size", "16x16", "-q",
                                       "-o", "old.png" } };
    Run run;
    run_command(sweep, &picture, NULL, &run);
}

static Tally sweep_command(const Sweep *sweep, const Command *command, Tally *shared)
{
    memset(shared, 0, sizeof *shared * (size_t)sweep->workers);
    for (int worker = 0; worker < sweep->workers; worker++) {
        fflush(stdout);
        if (fork() != 0)
            continue;
        char folder[64];
        make_folder(worker, folder);
        make_inputs(sweep);
        Run good;
        run_command(sweep, command, NULL, &good);
        if (!WIFEXITED(good.status) || WEXITSTATUS(good.status) != 0 || good.left[0]) {
            printf("%s: does not work: %s%s\n", command->name, good.left, good.says);
            shared[worker].faults++;
        }
        for (FailKind kind = 0; kind < FAIL_KINDS && shared[worker].faults == 0; kind++) {
            Tally tally = sweep_kind(sweep, command, &good, kind, worker);
            shared[worker].points += tally.points;
            shared[worker].faults += tally.faults;
        }
        remove_folder(folder);
        fflush(stdout);
        _exit(0);
    }
    Tally sum = { 0, 0 };
    for (int worker = 0; worker < sweep->workers; worker++)
        wait(NULL);
    for (int worker = 0; worker < sweep->workers; worker++) {
        sum.points += shared[worker].points;
        sum.faults += shared[worker].faults;
    }
    printf("%-20s %7lu points %5lu faults\n", command->name, sum.points, sum.faults);
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
    if (argc < 3 || !realpath(argv[1], sweep.program) || !realpath(argv[2], sweep.library) ||
        !realpath("scenes", sweep.scenes)) {
        fputs("usage: faults PROGRAM LIBRARY [--most N] [--workers N] [COMMAND...]\n", stderr);
        return 2;
    }
    int i = 3;
    for (; i + 1 < argc && argv[i][0] == '-'; i += 2)
        if (strcmp(argv[i], "--most") == 0)
            sweep.most = strtoul(argv[i + 1], NULL, 10);
        else
            sweep.workers = atoi(argv[i + 1]);
    if (sweep.workers < 1)
        sweep.workers = 1;
    Tally *shared = mmap(NULL, sizeof *shared * (size_t)sweep.workers, PROT_READ | PROT_WRITE,
                         MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED)
        return 2;
    Tally all = { 0, 0 };
    for (int k = 0; k < COMMANDS; k++)
        if (is_chosen(commands[k].name, argc - i, argv + i)) {
            Tally tally = sweep_command(&sweep, &commands[k], shared);
            all.points += tally.points;
            all.faults += tally.faults;
        }
    printf("%lu points, %lu faults\n", all.points, all.faults);
    return all.faults != 0;
}
