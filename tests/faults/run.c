#define _GNU_SOURCE
#include "tests/faults/run.h"

#include <fcntl.h>
#include <ftw.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum {
    SECONDS = 60, /* what takes longer hangs */
    MOST_WORDS = 24,
    MOST_FILES = 4096,
};

static void die(const char *what)
{
    perror(what);
    exit(2);
}

/* --- words ------------------------------------------------------------------------------------ */

/* Cuts a line at its spaces, in place; word[count] is NULL. */
static int split(char *line, char *word[MOST_WORDS])
{
    int count = 0;
    for (char *rest = line, *at; (at = strtok_r(NULL, " ", &rest));)
        word[count++] = at;
    word[count] = NULL;
    return count;
}

int run_outputs(const Command *command)
{
    int count = command->outputs != NULL;
    for (const char *at = command->outputs; at && *at; at++)
        count += *at == ' ';
    return count;
}

/* --- files ------------------------------------------------------------------------------------ */

/* FNV-1a of a file, or, where its content is not the same twice, of how it ends; 0 where there is
 * none. */
static uint64_t hash_of(const char *path, bool end_alone)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return 0;
    if (end_alone)
        fseek(file, -3, SEEK_END);
    uint64_t hash = 14695981039346656037u;
    for (int byte; (byte = getc(file)) != EOF;)
        hash = (hash ^ (unsigned)byte) * 1099511628211u;
    fclose(file);
    return hash;
}

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    if (!file || fputs(text, file) < 0 || fclose(file) != 0)
        die(path);
}

/* Files of the folder that stay. */
static char kept[MOST_FILES][PATH_MAX];
static int kept_count;
static bool is_making;
static char *found; /* the name of one that does not stay; "": none */

static bool is_kept(const char *path)
{
    for (int i = 0; i < kept_count; i++)
        if (strcmp(kept[i], path) == 0)
            return true;
    return false;
}

static int keep(const char *path, const struct stat *info, int type, struct FTW *walk)
{
    (void)info;
    (void)walk;
    if (type == FTW_F && kept_count < MOST_FILES)
        snprintf(kept[kept_count++], PATH_MAX, "%s", path);
    return 0;
}

static int remove_new(const char *path, const struct stat *info, int type, struct FTW *walk)
{
    (void)info;
    (void)walk;
    if (type == FTW_F && !is_making && !is_kept(path)) {
        if (found)
            snprintf(found, NAME_MAX + 1, "%s", path);
        unlink(path);
    }
    return 0;
}

static int remove_any(const char *path, const struct stat *info, int type, struct FTW *walk)
{
    (void)info;
    (void)type;
    (void)walk;
    return remove(path);
}

void run_folder_enter(const char *folder)
{
    char cache[128];
    if (chdir(folder) != 0)
        die(folder);
    snprintf(cache, sizeof cache, "%s/cache", folder);
    setenv("XDG_CACHE_HOME", cache, 1);
    setenv("CCACHE_DISABLE", "1", 1);
}

void run_folder_make(const Runner *runner, const char *needed, char folder[64])
{
    snprintf(folder, 64, "/tmp/glasspipe-faults-XXXXXX");
    if (!mkdtemp(folder))
        die(folder);
    run_folder_enter(folder);
    if (mkdir("golden", 0777) != 0)
        die(folder);
    is_making = true;
    for (int i = 0; fault_files[i][0]; i++)
        write_text(fault_files[i][0], fault_files[i][1]);
    for (const Command *input = fault_inputs; input->name; input++) {
        Run run;
        if (!strstr(needed, input->name))
            continue;
        run_command(runner, input, NULL, &run);
        if (run.status != 0)
            printf("# %s: does not work: %s\n", input->name, run.says);
    }
    is_making = false;
    kept_count = 0;
    nftw(".", keep, 16, FTW_PHYS);
}

void run_folder_remove(const char *folder)
{
    nftw(folder, remove_any, 16, FTW_PHYS | FTW_DEPTH);
}

/* --- running ---------------------------------------------------------------------------------- */

static void start(const Runner *runner, const Command *command, const char *fail)
{
    char line[1024], place[PATH_MAX + 64], *word[MOST_WORDS];
    snprintf(line, sizeof line, "glasspipe %s", command->line);
    const int count = split(line, word);
    for (int i = 0; i < count; i++) {
        for (char *at = word[i]; *at; at++)
            *at = *at == '~' ? ' ' : *at;
        if (strncmp(word[i], "SCENES/", 7) == 0) {
            snprintf(place, sizeof place, "%s/%s", runner->scenes, word[i] + 7);
            word[i] = place;
        }
    }
    setenv("GP_FAIL_COUNTS", "counts", 1);
    if (fail)
        setenv("GP_FAIL", fail, 1);
    setenv("LD_PRELOAD", runner->library, 1);
    /* Where the sweep itself runs in the background, a shell or nohup has these ignored. */
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    signal(SIGHUP, SIG_DFL);
    dup2(open("stdout", O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO);
    dup2(open("stderr", O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
    execv(runner->program, word);
    _exit(127);
}

/* Seconds are counted one by one, so that a machine that stands still, with all that runs on it, is
 * not taken for a command that hangs. */
static int wait_for(const Runner *runner, const Command *command, const char *fail)
{
    const struct timespec second = { .tv_sec = 1 };
    int status = 0;
    sigset_t ended, before;
    sigemptyset(&ended);
    sigaddset(&ended, SIGCHLD);
    sigprocmask(SIG_BLOCK, &ended, &before);
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        sigprocmask(SIG_SETMASK, &before, NULL);
        start(runner, command, fail);
    }
    for (int seconds = 0; waitpid(child, &status, WNOHANG) == 0;)
        if (sigtimedwait(&ended, NULL, &second) < 0 && ++seconds == SECONDS)
            kill(child, SIGALRM);
    sigprocmask(SIG_SETMASK, &before, NULL);
    return status;
}

/* Times are in texts and tables, not in pictures. */
static bool ends_alone(const Command *command, const char *path)
{
    const char *dot = strrchr(path, '.');
    return command->varies && strcmp(dot, ".png") != 0;
}

void run_command(const Runner *runner, const Command *command, const char *fail, Run *run)
{
    char outputs[256], *output[MOST_WORDS];
    memset(run, 0, sizeof *run);
    found = NULL;
    nftw(".", remove_new, 16, FTW_PHYS);
    snprintf(outputs, sizeof outputs, "%s", command->outputs ? command->outputs : "");
    const int count = split(outputs, output);
    for (int i = 0; i < count; i++)
        write_text(output[i], "what was there before");
    const int handle = open("counts", O_RDWR | O_CREAT | O_TRUNC, 0666);
    if (handle < 0 || ftruncate(handle, sizeof(FailCounts)) != 0)
        die("counts");
    if (command->after) {
        wait_for(runner, command, command->after);
        if (access(command->may_stay, F_OK) != 0)
            snprintf(run->left, sizeof run->left, "no %.200s ", command->may_stay);
        if (ftruncate(handle, 0) != 0 || ftruncate(handle, sizeof(FailCounts)) != 0)
            die("counts");
    }
    for (int i = 0; i < count; i++)
        run->before[i] = hash_of(output[i], ends_alone(command, output[i]));
    run->status = wait_for(runner, command, fail);

    FailCounts counts;
    if (pread(handle, &counts, sizeof counts, 0) == sizeof counts)
        for (int kind = 0; kind < FAIL_KINDS; kind++)
            run->calls[kind] = counts.calls[kind];
    close(handle);
    run->printed = command->varies ? 0 : hash_of("stdout", false);
    for (int i = 0; i < count; i++) {
        run->written[i] = hash_of(output[i], ends_alone(command, output[i]));
        unlink(output[i]);
    }
    FILE *says = fopen("stderr", "rb");
    if (says) {
        run->says[fread(run->says, 1, sizeof run->says - 1, says)] = '\0';
        fclose(says);
    }
    unlink("stdout");
    unlink("stderr");
    unlink("counts");
    if (command->may_stay && run->status != 0)
        unlink(command->may_stay);
    found = run->left;
    nftw(".", remove_new, 16, FTW_PHYS);
}
