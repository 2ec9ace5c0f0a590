/* What shaders use, beside what their profiles allow. */
#ifndef APPS_COMMANDS_SHADER_LIMITS_H
#define APPS_COMMANDS_SHADER_LIMITS_H

#include "pipeline/shader/counts.h"

#include <jansson.h>

/* Adds "vertex_shader" and, where there is one, "pixel_shader": profile (name), gradients, and for
 * each resource {used, limit}; limit null where the profile has none. Nothing where it is not
 * counted. */
void shader_limits_add(json_t *object, const GpProgram *program);

/* Prints two such objects as one table, "used of limit"; NULL leaves a column out. */
void shader_limits_print(const json_t *vertex, const json_t *pixel);

#endif
