/* What commands write and print. */
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

/* Prints a value with nine digits, enough to restore every float exactly, and releases it. Keys come in
 * the order in which they were set.
 * in   value: NULL: there was no memory for it
 * returns the command's exit code, after a message where it is not EXIT_DONE */
int output_json(json_t *value);

/* The same as one of several lines, with six digits. */
void output_json_line(json_t *value);

#endif
