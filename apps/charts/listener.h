/* Whom a long measurement tells how it goes on. */
#ifndef APPS_CHARTS_LISTENER_H
#define APPS_CHARTS_LISTENER_H

#include <stdint.h>

/* A zeroed one hears nothing. */
typedef struct ChartListener {
    /* What is left out, and why: a line. */
    void (*notice)(const void *user, const char *line);
    /* Settings that are done, of all; text: the next one. */
    void (*progress)(const void *user, uint32_t done, uint32_t total, const char *text);
    const void *user;
} ChartListener;

#endif
