/* Measuring a chart: the sweep of a technique over a scene. */
#ifndef APPS_CHARTS_CHART_RUN_H
#define APPS_CHARTS_CHART_RUN_H

#include "apps/charts/chart.h"
#include "apps/charts/listener.h"
#include "apps/items/items.h"

typedef struct ChartJob {
    const Technique *technique;
    const Experiment *experiment; /* of it */
    const char *scene;            /* path */
    uint32_t width, height;       /* of the picture; 0 x 0: the scene's own */
    const char *folder;           /* where pictures of the front go; NULL: none are made */
    const char *name;             /* of files; NULL: chart_name's */
    double seconds;               /* for each setting, after its first frame */
    GpDevice *device;
    /* settings are items, by this; NULL: drawn one after the other by the device */
    const ItemRun *run;
    bool *is_unwritten; /* out: GP_ERROR_IO is of a picture that could not be written; or NULL */
    ChartListener listener;
} ChartJob;

/* Opens the scene, finds the truth, measures all settings of the sweep, marks the front and writes
 * at most CHART_MAX_PICTURES pictures of it as NAME_1.png and so on. Settings that
 * do not go with the scene are left out, and the listener told.
 * out    chart: untouched on failure; error: not NULL
 * errors those of the scene and of the truth; GP_ERROR_INVALID: no setting goes with the scene;
 *        GP_ERROR_IO: a picture could not be written; GP_ERROR_MEMORY; items_run's codes as the
 *        error that comes to them
 * owns   the caller, until chart_free */
GpResult chart_run(const ChartJob *job, Chart *chart, GpError *error);

#endif
