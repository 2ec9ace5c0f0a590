/* Scaling as files, and as JSON. */
#ifndef APPS_CHARTS_SCALING_FILE_H
#define APPS_CHARTS_SCALING_FILE_H

#include "apps/charts/scaling.h"

#include <jansson.h>

/* Writes PATH.csv and PATH.svg. errors GP_ERROR_IO, GP_ERROR_MEMORY */
GpResult scaling_write(const char *path, const Scaling *scaling, GpError *error);

/* One object a point. The caller owns it; NULL without memory. */
json_t *scaling_json(const Scaling *scaling);

#endif
