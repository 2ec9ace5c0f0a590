/* Scaling: what time the settings of a technique take as scenes and settings grow.
 *
 * scaling_run.c measures, scaling_file.c writes, scaling_draw.c draws; what is measured is declared by
 * the technique (TechniqueScaling).
 */
#ifndef APPS_CHARTS_SCALING_H
#define APPS_CHARTS_SCALING_H

#include "apps/charts/listener.h"
#include "apps/techniques/technique.h"
#include "apps/base/text.h"

#include <jansson.h>

typedef struct ScalingPoint {
    int panel, line; /* of the technique's table */
    char scene[256], options[SETTING_MAX_TEXT];
    double amount;             /* along the panel's axis */
    double ms, min_ms, cpu_ms; /* of a frame: median, least, processor time */
    uint32_t frames;           /* timed */
} ScalingPoint;

typedef struct Scaling {
    const Technique *technique; /* has a table of scaling */
    char machine[128], isa[16];
    int threads;
    ScalingPoint *points; /* owned; panel by panel, line by line, in the table's order */
    uint32_t count;
} Scaling;

void scaling_free(Scaling *scaling); /* a zeroed one is fine; zeroes it */

/* The name of a point's line. */
const char *scaling_name(const Scaling *scaling, const ScalingPoint *point);

/* Measures all lines. Scenes whose file is not there are left out, and the listener told.
 * in     seconds: for each setting, after its first frame
 * out    scaling: untouched on failure
 * errors those of scenes that are there, and of settings; GP_ERROR_IO: none is there;
 *        GP_ERROR_MEMORY
 * owns   the caller, until scaling_free */
GpResult scaling_run(const Technique *technique, GpDevice *device, const ChartListener *listener,
                     double seconds, Scaling *scaling, GpError *error);

/* --- files and pictures ----------------------------------------------------------------------- */

/* Writes PATH.csv and PATH.svg. errors GP_ERROR_IO, GP_ERROR_MEMORY */
GpResult scaling_write(const char *path, const Scaling *scaling, GpError *error);

/* One object a point. The caller owns it; NULL without memory. */
json_t *scaling_json(const Scaling *scaling);

/* Appends the picture as SVG. */
void scaling_draw(const Scaling *scaling, Text *svg);

#endif
