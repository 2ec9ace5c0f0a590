/* Scaling: what time the settings of a technique take as scenes and settings grow.
 *
 * scaling_run measures, scaling_file writes, scaling_draw draws; what is measured is declared by the
 * technique (TechniqueScaling).
 */
#ifndef APPS_CHARTS_SCALING_H
#define APPS_CHARTS_SCALING_H

#include "apps/frame/timing.h"
#include "apps/techniques/technique.h"

typedef struct ScalingPoint {
    int panel, line; /* of the technique's table */
    char scene[256], options[SETTING_MAX_TEXT];
    double amount; /* along the panel's axis */
    Timing time;
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

#endif
