/* Growth: what time the settings of a technique take as scenes and settings grow.
 *
 * growth_run.c measures, growth_file.c writes, growth_draw.c draws; what is measured is declared by
 * the technique (TechniqueGrowth).
 */
#ifndef APPS_CHARTS_SCALING_H
#define APPS_CHARTS_SCALING_H

#include "apps/commands/options.h"
#include "apps/techniques/technique.h"
#include "apps/base/text.h"

#include <jansson.h>

typedef struct GrowthPoint {
    int panel, line; /* of the technique's table */
    char scene[256], options[SETTING_MAX_TEXT];
    double amount;             /* along the panel's axis */
    double ms, min_ms, cpu_ms; /* of a frame: median, least, processor time */
    uint32_t frames;           /* timed */
} GrowthPoint;

typedef struct Growth {
    const Technique *technique; /* has a table of growth */
    char machine[128], isa[16];
    int threads;
    GrowthPoint *points; /* owned; panel by panel, line by line, in the table's order */
    uint32_t count;
} Growth;

void growth_free(Growth *growth); /* a zeroed one is fine; zeroes it */

/* The name of a point's line. */
const char *growth_name(const Growth *growth, const GrowthPoint *point);

/* Measures all lines. Scenes whose file is not there are left out with a message.
 * in     seconds: for each setting, after its first frame; options: what may be said on stderr
 * out    growth: untouched on failure
 * errors those of scenes that are there, and of settings; GP_ERROR_IO: none is there;
 *        GP_ERROR_MEMORY
 * owns   the caller, until growth_free */
GpResult growth_run(const Technique *technique, GpDevice *device, const Options *options,
                    double seconds, Growth *growth, GpError *error);

/* --- files and pictures ----------------------------------------------------------------------- */

/* Writes PATH.csv and PATH.svg. errors GP_ERROR_IO, GP_ERROR_MEMORY */
GpResult growth_write(const char *path, const Growth *growth, GpError *error);

/* One object a point. The caller owns it; NULL without memory. */
json_t *growth_json(const Growth *growth);

/* Appends the picture as SVG. */
void growth_draw(const Growth *growth, Text *svg);

#endif
