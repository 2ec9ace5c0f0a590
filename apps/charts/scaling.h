/* Scaling: what time the settings of a technique take as scenes and settings grow.
 *
 * scaling_run measures, scaling_file writes, scaling_draw draws; what is measured is declared by
 * the technique (TechniqueScaling).
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
    double others;        /* as a chart's */
    ScalingPoint *points; /* owned; panel by panel, line by line, in the table's order */
    uint32_t count;
} Scaling;

void scaling_free(Scaling *scaling); /* a zeroed one is fine; zeroes it */

/* The name of a point's line. */
const char *scaling_name(const Scaling *scaling, const ScalingPoint *point);

/* Whether amount and time are numbers that a logarithmic axis can hold. */
bool scaling_has_place(const ScalingPoint *point);

/* Time as a power of the amount, as a line's points have it. */
typedef struct ScalingPower {
    double power;       /* of all points: the slope of their logarithms, by least squares */
    double least, most; /* from one point to the next that has half as much again, or more */
} ScalingPower;

/* Finds it. returns whether the line has two points so far apart; else *power is untouched */
bool scaling_power(const Scaling *scaling, int panel, int line, ScalingPower *power);

#endif
