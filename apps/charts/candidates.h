/* In which order the settings of an experiment are tried where an error is asked for. */
#ifndef APPS_CHARTS_CANDIDATES_H
#define APPS_CHARTS_CANDIDATES_H

#include "apps/charts/chart.h"

typedef struct Candidate {
    char method[64], options[SETTING_MAX_TEXT];
} Candidate;

/* Those before the first are faster, and further from the truth, the further they stand before
 * it. */
typedef struct Candidates {
    Candidate *list;
    uint32_t count;
    uint32_t first; /* what is proposed */
} Candidates;

/* Lists all settings of the chart and of the experiment's sweep. With a chart its steps
 * (chart_list_steps) come first, of which the first one whose error there is at most `most`, or
 * else the last, is proposed; then its other points by their errors; then what only the sweep has.
 * Of the sweep the rows that are usual ones come before the others, in each case the first settings
 * of all rows before the second ones.
 * in     chart: NULL: there is none; per_cent: most is a share, as in chart_per_cent
 * errors GP_ERROR_MEMORY; owns: the caller, until gp_free of the list */
GpResult candidates_list(const Experiment *experiment, const Chart *chart, double most,
                         bool per_cent, Candidates *candidates, GpError *error);

#endif
