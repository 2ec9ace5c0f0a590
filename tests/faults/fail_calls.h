/* Which calls can be made to fail, shared by the library that lets them fail and the sweep. */
#ifndef TESTS_FAULTS_FAIL_CALLS_H
#define TESTS_FAULTS_FAIL_CALLS_H

#include <stdbool.h>

typedef enum FailKind {
    FAIL_ALLOC, /* no memory */
    FAIL_MAP,
    FAIL_OPEN,       /* too many open files */
    FAIL_READ,       /* a broken disk */
    FAIL_SHORT_READ, /* one byte instead of many: nothing wrong */
    FAIL_WRITE,
    FAIL_FULL,        /* a full disk */
    FAIL_SHORT_WRITE, /* one byte instead of many: nothing wrong */
    FAIL_RENAME,
    FAIL_THREAD,
    FAIL_INTERRUPT, /* SIGINT at an allocation: at any moment */
    FAIL_TERMINATE, /* SIGTERM at a write */
    FAIL_HANG_UP,   /* SIGHUP before a file takes its place */
    FAIL_KINDS
} FailKind;

static const char *const fail_kind_names[FAIL_KINDS] = {
    "alloc",       "map",    "open",   "read",      "short-read", "write",   "full",
    "short-write", "rename", "thread", "interrupt", "terminate",  "hang-up",
};

typedef struct FailCounts {
    _Atomic unsigned long calls[FAIL_KINDS];
} FailCounts;

#endif
