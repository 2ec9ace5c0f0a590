#define _GNU_SOURCE /* O_TMPFILE */
#include "pipeline/io/file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* --- reading ---------------------------------------------------------------------------------- */

static GpResult read_open_file(int handle, const char *path, GpFile *file, GpError *error)
{
    struct stat info;
    if (fstat(handle, &info) != 0)
        return gp_fail(error, GP_ERROR_IO, "%s: %s", path, strerror(errno));
    if (S_ISDIR(info.st_mode))
        return gp_fail(error, GP_ERROR_IO, "%s: is a folder, not a file", path);
    if (!S_ISREG(info.st_mode))
        return gp_fail(error, GP_ERROR_IO, "%s: not a regular file", path);

    size_t size = (size_t)info.st_size;
    char *data = gp_alloc(size + 1, 1);
    if (!data)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %zu bytes", path, size);
    size_t have = 0;
    while (have < size) {
        ssize_t got = read(handle, data + have, size - have);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0) {
            gp_free(data);
            return gp_fail(error, GP_ERROR_IO, "%s: %s", path,
                           got < 0 ? strerror(errno) : "became shorter while it was read");
        }
        have += (size_t)got;
    }
    file->data = data;
    file->size = size;
    return GP_OK;
}

GpResult gp_file_read(const char *path, GpFile *file, GpError *error)
{
    GP_ASSERT(path && file);
    /* Without O_NONBLOCK, opening a pipe that nobody writes to would wait for ever. */
    int handle = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (handle < 0)
        return gp_fail(error, GP_ERROR_IO, "%s: %s", path, strerror(errno));
    GpResult result = read_open_file(handle, path, file, error);
    close(handle);
    return result;
}

void gp_file_free(GpFile *file)
{
    if (!file)
        return;
    gp_free(file->data);
    *file = (GpFile){ .data = NULL, .size = 0 };
}

/* --- writing ---------------------------------------------------------------------------------- */

/* 0 or the errno of the first failure. */
static int write_all(int handle, const char *data, size_t size)
{
    int problem = 0;
    while (size > 0 && problem == 0) {
        ssize_t put = write(handle, data, size);
        if (put > 0) {
            data += put;
            size -= (size_t)put;
        } else if (put == 0) {
            problem = ENOSPC;
        } else if (errno != EINTR) {
            problem = errno;
        }
    }
    return problem;
}

/* The same, and closes the handle: a full disk may be told only by close. */
static int write_and_close(int handle, const char *data, size_t size)
{
    const int problem = write_all(handle, data, size);
    return close(handle) != 0 && problem == 0 ? errno : problem;
}

/* Temporary files that are there, by name, for gp_file_abandon. Where more are written at once than
 * there are places, the others are not known here. */
static _Atomic(const char *) unfinished[16];

static atomic_bool is_abandoned; /* from then on no file gets a name */

static void set_unfinished(const char *old, const char *name)
{
    for (size_t i = 0; i < GP_COUNT(unfinished); i++) {
        const char *expected = old;
        if (atomic_compare_exchange_strong(&unfinished[i], &expected, name))
            return;
    }
}

/* Another thread may be about to give a file the name that is written there already: a moment is
 * waited for it, and no more, as it may be this one, in whose midst a signal came. */
static void remove_unfinished(_Atomic(const char *) *place)
{
    const char *name = atomic_load(place);
    for (int i = 0; i < 1000 && name && *name && unlink(name) != 0 && errno == ENOENT; i++) {
        sched_yield();
        name = atomic_load(place);
    }
}

void gp_file_abandon(void)
{
    atomic_store(&is_abandoned, true);
    for (size_t i = 0; i < GP_COUNT(unfinished); i++)
        remove_unfinished(&unfinished[i]);
}

/* Where a path leads, its last links followed though nothing may be there; false: in a circle, or
 * too long. */
static bool follow_links(const char *path, char end[PATH_MAX])
{
    if (realpath(path, end))
        return true;
    if (snprintf(end, PATH_MAX, "%s", path) >= PATH_MAX)
        return false;
    for (int links = 0; links < 40; links++) { /* as many as Linux follows */
        char target[PATH_MAX];
        const ssize_t length = readlink(end, target, sizeof target - 1);
        if (length < 0)
            return true;
        target[length] = '\0';
        const char *slash = target[0] == '/' ? NULL : strrchr(end, '/');
        const size_t folder = slash ? (size_t)(slash + 1 - end) : 0;
        if (folder + (size_t)length >= PATH_MAX)
            return false;
        memcpy(end + folder, target, (size_t)length + 1);
    }
    return false;
}

struct GpFilePieces {
    const char *path; /* for messages */
    int handle;
    bool named; /* the temporary file is there under its name */
    char temporary[PATH_MAX], end[PATH_MAX];
};

/* Makes the temporary file's name by `make`, which returns below 0 and says EEXIST where another
 * has it. The name is short and does not depend on the target's, so it fits wherever the target
 * fits; the process number keeps two programs apart, EEXIST two threads.
 * returns what `make` did */
static int name_beside(GpFilePieces *file, int (*make)(const GpFilePieces *))
{
    const char *slash = strrchr(file->end, '/');
    const int folder = slash ? (int)(slash - file->end) + 1 : 0;
    for (int attempt = 0; attempt < 1000; attempt++) {
        if (snprintf(file->temporary, PATH_MAX, "%.*s.glasspipe-%ld-%d.tmp", folder, file->end,
                     (long)getpid(), attempt) >= PATH_MAX) {
            errno = ENAMETOOLONG;
            return -1;
        }
        while (atomic_load(&is_abandoned)) /* and the program is about to end */
            pause();
        const int made = make(file);
        if (made >= 0 || errno != EEXIST)
            return made;
    }
    return -1;
}

static int create_named(const GpFilePieces *file)
{
    return open(file->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

static int give_name(const GpFilePieces *file)
{
    char handle[64];
    snprintf(handle, sizeof handle, "/proc/self/fd/%d", file->handle);
    return linkat(AT_FDCWD, handle, AT_FDCWD, file->temporary, AT_SYMLINK_FOLLOW);
}

/* A file without a name in the folder of the target: whatever ends the process, nothing is left of
 * it.
 * returns below 0 where the system has none */
static int create_nameless(const char *end)
{
#ifdef O_TMPFILE
    char folder[PATH_MAX];
    const char *slash = strrchr(end, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - end) + 1 : 2, slash ? end : "./");
    if (access("/proc/self/fd", X_OK) == 0)
        return open(folder, O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
#endif
    return -1;
}

/* returns 0 or an errno */
static int begin_file(GpFilePieces *file, const char *path)
{
    file->path = path;
    file->temporary[0] = '\0';
    if (!follow_links(path, file->end))
        return ELOOP;
    set_unfinished(NULL, file->temporary); /* before it is there: "" is no file */
    file->handle = create_nameless(file->end);
    file->named = file->handle < 0;
    if (file->named)
        file->handle = name_beside(file, create_named);
    if (file->handle >= 0)
        return 0;
    const int problem = errno;
    set_unfinished(file->temporary, NULL);
    return problem;
}

/* A file that is whole takes its place; what is not is gone. returns 0 or an errno */
static int end_file(GpFilePieces *file, bool whole)
{
    int problem = 0;
    if (whole && !file->named) {
        problem = name_beside(file, give_name) < 0 ? errno : 0;
        file->named = !problem;
    }
    if (close(file->handle) != 0 && !problem) /* a full disk may be told only here */
        problem = errno;
    if (whole && !problem && rename(file->temporary, file->end) != 0)
        problem = errno;
    if (file->named && (!whole || problem))
        unlink(file->temporary);
    set_unfinished(file->temporary, NULL);
    return problem;
}

static int replace_file(const char *path, const void *data, size_t size)
{
    GpFilePieces file;
    int problem = begin_file(&file, path);
    if (problem)
        return problem;
    problem = write_all(file.handle, data, size);
    const int at_end = end_file(&file, !problem);
    return problem ? problem : at_end;
}

static GpResult cannot_write(const char *path, int problem, GpError *error)
{
    return gp_fail(error, GP_ERROR_IO, "%s: cannot write: %s", path, strerror(problem));
}

GpResult gp_file_write(const char *path, const void *data, size_t size, GpError *error)
{
    GP_ASSERT(path && (data || size == 0));
    struct stat info;
    int problem;
    if (stat(path, &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode)) {
        int handle = open(path, O_WRONLY | O_CLOEXEC);
        problem = handle < 0 ? errno : write_and_close(handle, data, size);
    } else
        problem = replace_file(path, data, size);
    return problem ? cannot_write(path, problem, error) : GP_OK;
}

/* --- piece by piece --------------------------------------------------------------------------- */

GpResult gp_file_begin(const char *path, GpFilePieces **pieces, GpError *error)
{
    GpFilePieces *made = gp_alloc(1, sizeof *made);
    if (!made)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory", path);
    const int problem = begin_file(made, path);
    if (problem) {
        gp_free(made);
        return cannot_write(path, problem, error);
    }
    *pieces = made;
    return GP_OK;
}

GpResult gp_file_add(GpFilePieces *pieces, const void *data, size_t size, GpError *error)
{
    const int problem = write_all(pieces->handle, data, size);
    return problem ? cannot_write(pieces->path, problem, error) : GP_OK;
}

GpResult gp_file_end(GpFilePieces **pieces, bool whole, GpError *error)
{
    GpFilePieces *ended = *pieces;
    *pieces = NULL;
    if (!ended)
        return GP_OK;
    const int problem = end_file(ended, whole);
    const GpResult result = whole && problem ? cannot_write(ended->path, problem, error) : GP_OK;
    gp_free(ended);
    return result;
}

/* --- names ------------------------------------------------------------------------------------ */

/* The folder of a path, "" or with its last slash; that of too long a path is "". */
static void folder_of(const char *path, char folder[PATH_MAX])
{
    const char *slash = path ? strrchr(path, '/') : NULL;
    const size_t length = slash ? (size_t)(slash + 1 - path) : 0;
    folder[0] = '\0';
    if (length < PATH_MAX)
        snprintf(folder, PATH_MAX, "%.*s", (int)length, path ? path : "");
}

/* Where `make install' puts what the program brings with it: beside its own folder. */
static void installed_folder(char folder[PATH_MAX])
{
    char program[PATH_MAX], own[PATH_MAX];
    const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    program[length > 0 ? length : 0] = '\0';
    folder_of(program, own);
    if (snprintf(folder, PATH_MAX, "%s../share/glasspipe/", own) >= PATH_MAX || !own[0])
        strcpy(folder, "/usr/share/glasspipe/");
}

GpResult gp_data_find(const char *name, char *path, size_t size, GpError *error)
{
    return gp_data_find_beside(NULL, name, path, size, error);
}

GpResult gp_data_find_beside(const char *file, const char *name, char *path, size_t size,
                             GpError *error)
{
    GP_ASSERT(name && path);
    if (!name[0])
        return gp_fail(error, GP_ERROR_IO, "no name: expected that of a file");
    const char *variable = getenv("GLASSPIPE_DATA");
    char beside[PATH_MAX], installed[PATH_MAX];
    folder_of(file, beside);
    installed_folder(installed);
    const char *folders[] = { beside, "", variable ? variable : "", "../shared/data/", installed };
    for (size_t i = 0; i < GP_COUNT(folders); i++) {
        if (i != 1 && (name[0] == '/' || folders[i][0] == '\0'))
            continue;
        char candidate[PATH_MAX];
        const size_t end = strlen(folders[i]);
        const char *slash = end && folders[i][end - 1] != '/' ? "/" : "";
        int length = snprintf(candidate, sizeof candidate, "%s%s%s", folders[i], slash, name);
        if (length < 0 || (size_t)length >= sizeof candidate || access(candidate, F_OK) != 0)
            continue;
        if ((size_t)length >= size)
            return gp_fail(error, GP_ERROR_IO, "%s: the path is longer than %zu bytes", name, size);
        memcpy(path, candidate, (size_t)length + 1);
        return GP_OK;
    }
    if (name[0] == '/')
        return gp_fail(error, GP_ERROR_IO, "%s: no such file", name);
    return gp_fail(
        error, GP_ERROR_IO,
        "%s: no such file, neither %shere nor in $GLASSPIPE_DATA (%s), ../shared/data, %s", name,
        beside[0] ? "beside the scene, " : "", variable ? variable : "not set", installed);
}

bool gp_path_is_folder(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

void gp_file_extension(const char *path, char extension[8])
{
    const char *dot = strrchr(path, '.');
    size_t length = dot ? strlen(dot + 1) : 0;
    if (length > 7 || (dot && strchr(dot, '/')))
        length = 0;
    for (size_t i = 0; i < length; i++) {
        char c = dot[1 + i];
        extension[i] = (char)(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
    extension[length] = '\0';
}

bool gp_file_has_extension(const char *path, const char *extension)
{
    char own[8];
    gp_file_extension(path, own);
    return strcmp(own, extension) == 0;
}
