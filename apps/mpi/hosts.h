/* What ranks know of each other. */
#ifndef APPS_MPI_HOSTS_H
#define APPS_MPI_HOSTS_H

#include <stdint.h>

typedef struct Host {
    char name[64];    /* of the machine */
    char version[32]; /* of the program */
    uint64_t test;    /* self_test_hash */
    int64_t pid;
    uint64_t threads; /* to draw by, where nothing else is said */
} Host;

#endif
