/* A sweep of one's own: settings of a technique as lists, --map 512,1024 --method
 * plain,hardware. */
#ifndef APPS_COMMANDS_CHART_SWEEP_H
#define APPS_COMMANDS_CHART_SWEEP_H

#include "apps/commands/command.h"
#include "apps/techniques/technique.h"

typedef struct ChartSweep {
    const Technique *technique; /* NULL: none was named */
    const Experiment *experiment;
    SettingField fields[SETTING_MAX_FIELDS + 1]; /* those of its key, as texts */
    const char *values[SETTING_MAX_FIELDS];      /* of these: the lists; NULL: not given */
    CommandOptions options;

    /* Once it was checked: one row for each combination of names. */
    Experiment own;
    TechniqueSweep *rows; /* NULL: nothing was given, and the experiment's own sweep is meant */
    Text *texts;          /* a method's name and its options for each row */
} ChartSweep;

/* Finds the technique among the arguments, so that its settings are options.
 * out  sweep: not to be moved; owns: the caller, until chart_sweep_free */
void chart_sweep_prepare(const Technique *const *techniques, int argc, char **argv,
                         ChartSweep *sweep);

/* Makes the rows of what was given. Does not return where a list has what its setting does not
 * take, or where there are too many. */
void chart_sweep_check(struct argp_state *state, ChartSweep *sweep);

void chart_sweep_free(ChartSweep *sweep);

#endif
