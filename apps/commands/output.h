/* A command's frame: drawn, hashed, written to a picture and reported. */
#ifndef APPS_COMMANDS_OUTPUT_H
#define APPS_COMMANDS_OUTPUT_H

#include "apps/commands/options.h"
#include "apps/frame/run_statistics.h"

#include <jansson.h>

/* Path of an output that was not named: the input's name with another extension ("png"), in out/ where
 * that exists. */
void output_default_path(const char *input, const char *extension, char *path, size_t size);

/* What --verbose says of a first frame. */
void output_verbose(const Options *options, const RunStatistics *statistics);

/* Prints "hash FORMAT WxH 0123456789abcdef"; hash is gp_surface_hash's. */
void output_hash(const GpSurface *surface, uint64_t hash);

/* Draws a list, writes the picture and prints its hash; with --json draws it a second time, which is
 * the one that is timed, and prints run_json's object with the file's name and `more`.
 * in   input: what the user gave, for messages; opaque: alpha stays out of the file; more: members to add, borrowed, NULL for none
 * returns the command's exit code, after a message where it is not EXIT_DONE */
int output_frame(const Options *options, const char *input, const char *output, GpDevice *device,
                 const GpList *list, const GpSurface *surface, bool opaque, json_t *more);

#endif
