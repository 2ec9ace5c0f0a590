/* Charts as files: CSV for tables, JSON to be read back. */
#ifndef APPS_CHARTS_CHART_FILE_H
#define APPS_CHARTS_CHART_FILE_H

#include "apps/charts/chart.h"

#include <jansson.h>

/* Where charts are: out/charts where out exists, else charts. */
const char *chart_folder(void);

/* What the files of a chart are called, without folder and extension: "shadow", or
 * "shadow_SCENE" where the scene is not the experiment's own. */
void chart_name(const Experiment *experiment, const char *scene, char *name, size_t size);

/* The caller owns it; NULL without memory. */
json_t *chart_json(const Chart *chart);

/* Writes PATH.json, PATH.csv and PATH.svg. errors GP_ERROR_IO, GP_ERROR_MEMORY */
GpResult chart_write(const char *path, const Chart *chart, GpError *error);

/* Reads a JSON file that chart_write wrote; all numbers have the same bits again.
 * out    chart: untouched on failure
 * errors GP_ERROR_IO, GP_ERROR_FORMAT (with file, line and value), GP_ERROR_MEMORY
 * owns   the caller, until chart_free */
GpResult chart_read(const char *path, Chart *chart, GpError *error);

#endif
