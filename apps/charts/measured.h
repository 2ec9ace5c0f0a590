/* Errors that were measured once, kept in a file, so that nothing is measured twice: one file for
 * all that a measurement depends on but the setting. */
#ifndef APPS_CHARTS_MEASURED_H
#define APPS_CHARTS_MEASURED_H

#include "apps/techniques/technique.h"

#include <jansson.h>

/* A zeroed one is empty, and in no file. */
typedef struct Measured {
    char path[4096]; /* of the file; empty: none */
    json_t *settings;
    uint32_t added; /* since the file was read */
} Measured;

/* What measurements depend on, as a number: the program, the experiment, what its input and its
 * settings aside name (by content: a scene with its meshes), and the picture's size.
 * in   setting: its fields aside count, except those that say how a result is looked at */
uint64_t measured_key(const Technique *technique, const Experiment *experiment,
                      const TechniqueInput *input);

/* Opens FOLDER/NAME-KEY.json. A file that is not there, or cannot be read, is empty.
 * owns the caller, until measured_close */
void measured_open(const char *folder, const char *name, uint64_t key, Measured *measured);
void measured_close(Measured *measured); /* zeroes it */

/* The error of a setting, by its text as setting_print has it; metrics are not kept.
 * out    error: infinite where the setting does not go with the scene
 * returns whether it is known */
bool measured_find(const Measured *measured, const char *setting, TechniqueError *error);
void measured_add(Measured *measured, const char *setting, const TechniqueError *error);

/* Writes what was added, and makes the folder.
 * errors GP_ERROR_IO, GP_ERROR_MEMORY */
GpResult measured_write(const Measured *measured, GpError *error);

#endif
