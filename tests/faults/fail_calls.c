/* A library for LD_PRELOAD that lets one call of a kind fail: the n-th allocation, open, read,
 * write, mapping or new thread of a process, whoever makes it, the program or a library under it.
 *
 *   GP_FAIL=alloc:17     the 17th allocation has no memory; 17+: and all after it
 *   GP_FAIL_COUNTS=FILE  holds a FailCounts, in which the calls of each kind are counted as they
 *                        are made, so that they are known however the process ends
 */
#define _GNU_SOURCE
#include "tests/faults/fail_calls.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

/* glibc's own, which are there before dlsym can be called. */
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

static FailCounts unshared, *counts = &unshared;
static FailKind chosen = FAIL_KINDS;
static unsigned long first, last;

__attribute__((constructor)) static void choose(void)
{
    const char *path = getenv("GP_FAIL_COUNTS"), *what = getenv("GP_FAIL");
    unsetenv("LD_PRELOAD"); /* compilers that it starts are not on trial */
    const long handle = path ? syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CLOEXEC) : -1;
    if (handle >= 0) {
        void *shared = (void *)syscall(SYS_mmap, NULL, sizeof *counts, PROT_READ | PROT_WRITE,
                                       MAP_SHARED, handle, 0L);
        if (shared != MAP_FAILED)
            counts = shared;
        syscall(SYS_close, handle);
    }
    const char *colon = what ? strchr(what, ':') : NULL;
    for (FailKind kind = 0; colon && kind < FAIL_KINDS; kind++)
        if (strncmp(what, fail_kind_names[kind], (size_t)(colon - what)) == 0 &&
            fail_kind_names[kind][colon - what] == '\0') {
            char *end;
            first = strtoul(colon + 1, &end, 10);
            last = *end == '+' ? (unsigned long)-1 : first;
            chosen = kind;
        }
}

/* Counts a call; whether it is to fail. */
static bool fails(FailKind kind)
{
    const unsigned long n = atomic_fetch_add(&counts->calls[kind], 1) + 1;
    return kind == chosen && n >= first && n <= last;
}

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

/* --- signals ---------------------------------------------------------------------------------- */

static int sent;

static void send_signal(int number)
{
    sent = number;
    raise(number);
}

/* Whoever ends a program may do so twice, and the second comes while it clears up after the
 * first. */
int unlink(const char *path)
{
    if (sent)
        kill(getpid(), sent);
    return (int)syscall(SYS_unlinkat, AT_FDCWD, path, 0);
}

/* --- memory ----------------------------------------------------------------------------------- */

static bool no_memory(void)
{
    if (fails(FAIL_INTERRUPT))
        send_signal(SIGINT);
    if (!fails(FAIL_ALLOC))
        return false;
    errno = ENOMEM;
    return true;
}

void *malloc(size_t size)
{
    return no_memory() ? NULL : __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
    return no_memory() ? NULL : __libc_calloc(count, size);
}

void *realloc(void *old, size_t size)
{
    return no_memory() ? NULL : __libc_realloc(old, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return no_memory() ? NULL : __libc_memalign(alignment, size);
}

void *memalign(size_t alignment, size_t size)
{
    return no_memory() ? NULL : __libc_memalign(alignment, size);
}

int posix_memalign(void **memory, size_t alignment, size_t size)
{
    void *got = no_memory() ? NULL : __libc_memalign(alignment, size);
    if (!got)
        return ENOMEM;
    *memory = got;
    return 0;
}

void *mmap(void *place, size_t size, int protection, int flags, int handle, off_t offset)
{
    if (fails(FAIL_MAP)) {
        errno = ENOMEM;
        return MAP_FAILED;
    }
    return (void *)syscall(SYS_mmap, place, size, protection, flags, handle, offset);
}

/* --- files ------------------------------------------------------------------------------------ */

int open(const char *path, int flags, ...)
{
    mode_t mode = 0;
    if ((flags & O_CREAT) || (flags & O_TMPFILE) == O_TMPFILE) {
        va_list list;
        va_start(list, flags);
        mode = va_arg(list, mode_t);
        va_end(list);
    }
    if (fails(FAIL_OPEN)) {
        errno = EMFILE;
        return -1;
    }
    return (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

FILE *fopen(const char *path, const char *mode)
{
    if (fails(FAIL_OPEN)) {
        errno = EMFILE;
        return NULL;
    }
    return NEXT(fopen)(path, mode);
}

ssize_t read(int handle, void *data, size_t size)
{
    if (fails(FAIL_READ)) {
        errno = EIO;
        return -1;
    }
    if (fails(FAIL_SHORT_READ) && size > 1)
        size = 1;
    return syscall(SYS_read, handle, data, size);
}

ssize_t pread(int handle, void *data, size_t size, off_t offset)
{
    if (fails(FAIL_READ)) {
        errno = EIO;
        return -1;
    }
    return syscall(SYS_pread64, handle, data, size, offset);
}

ssize_t write(int handle, const void *data, size_t size)
{
    if (fails(FAIL_TERMINATE))
        send_signal(SIGTERM);
    if (fails(FAIL_WRITE)) {
        errno = EIO;
        return -1;
    }
    if (fails(FAIL_FULL)) {
        errno = ENOSPC;
        return -1;
    }
    if (fails(FAIL_SHORT_WRITE) && size > 1)
        size = 1;
    return syscall(SYS_write, handle, data, size);
}

int rename(const char *from, const char *to)
{
    if (fails(FAIL_HANG_UP))
        send_signal(SIGHUP);
    if (fails(FAIL_RENAME)) {
        errno = EIO;
        return -1;
    }
    return (int)syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0);
}

/* A file without a name gets one. */
int linkat(int old_folder, const char *from, int new_folder, const char *to, int flags)
{
    if (fails(FAIL_RENAME)) {
        errno = EIO;
        return -1;
    }
    return (int)syscall(SYS_linkat, old_folder, from, new_folder, to, flags);
}

/* --- threads ---------------------------------------------------------------------------------- */

int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                   void *argument)
{
    if (fails(FAIL_THREAD))
        return EAGAIN;
    return NEXT(pthread_create)(thread, attributes, run, argument);
}
