/* What commands write and print. */
#ifndef APPS_COMMANDS_OUTPUT_H
#define APPS_COMMANDS_OUTPUT_H

#include "apps/commands/options.h"
#include "apps/frame/run_statistics.h"
#include "pipeline/io/volume/volume_file.h"

#include <jansson.h>

/* Path of an output that was not named: the input's name with another extension ("png"), in out/
 * where that exists. */
void output_default_path(const char *input, const char *extension, char *path, size_t size);

/* What a list gave, once it has been drawn for the first time. Borrowed. */
typedef struct Output {
    const Options *options;
    const char *input, *path; /* what the user gave, for messages; where it is to be written */
    GpDevice *device;
    const GpList *list;
    RunStatistics statistics;
    const GpSurface *surface; /* the picture, or what the volume was read from */
    bool opaque;              /* alpha stays out of the picture's file */
    const char *alpha_path;   /* where it is to be written alone; NULL: nowhere */
    const char *alpha_name;   /* what it is, for --json: "visibility" */
    GpVolume volume;          /* data NULL: the picture is the result */
    const char *lines;        /* to be printed after the hash; NULL: none */
    json_t *members;          /* to be added to --json's; NULL: none */
    const char *rate;         /* one of them, to be told by the second too; NULL: none */
} Output;

/* Writes the picture or the volume, and prints "hash FORMAT WxH 0123456789abcdef",
 * gp_surface_hash's or that of the volume's voxels in order; with --json draws the list a second
 * time, which is the one that is timed, and prints run_json's object.
 * returns the command's exit code, after a message where it is not EXIT_DONE */
int output_result(Output *output);

/* Prints a value with fifteen digits, more than restore every float exactly, and releases it. Keys
 * come in the order in which they were set.
 * in   value: NULL: there was no memory for it
 * returns the command's exit code, after a message where it is not EXIT_DONE */
int output_json(json_t *value);

/* The same as one of several lines, with six digits. */
void output_json_line(json_t *value);

#endif
