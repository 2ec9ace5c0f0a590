/* Lists that are watched at speed. Of each pass, the units of the reference executor draw the quads
 * that have a pixel which is told of; what they drew is taken back, and the fast executor draws
 * everything. */
#ifndef GP_WATCHED_H
#define GP_WATCHED_H

#include "pipeline/fast/fast.h"
#include "pipeline/reference/reference.h"

/* Runs a checked list.
 * in   reference: its lanes and its trace; lanes, timed: of the fast executor
 * out  counters, phases: the fast executor's
 * errors GP_ERROR_MEMORY, also after some passes were drawn */
GpResult gp_watched_run(const GpReference *reference, GpFast *fast, const GpList *list, int lanes,
                        bool timed, GpCounters *counters, GpPhases *phases, GpError *error);

#endif
