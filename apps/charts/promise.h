/* A promise: the cheapest setting whose error, on this very scene, is at most what was asked for.
 *
 * Settings are proposed by a stored chart, which was measured on another scene, and then measured
 * on this one: its truth is found once, the frame is drawn, and held against it. So what is chosen
 * holds, whatever the chart says; the chart only decides how soon it is found, and how fast it is.
 */
#ifndef APPS_CHARTS_PROMISE_H
#define APPS_CHARTS_PROMISE_H

#include "apps/charts/candidates.h"
#include "apps/charts/listener.h"
#include "apps/charts/measured.h"

typedef struct PromiseJob {
    const Technique *technique;
    const Experiment *experiment; /* of it */
    const Chart *chart;           /* NULL: none is stored */
    void *scene;                  /* open */
    const void *setting;          /* what is aside of the key holds for all */
    uint32_t given;               /* for the technique's check, as it has them */
    const char *extension;
    GpDevice *device;
    double most; /* error */
    bool per_cent;
    ChartListener listener; /* its progress */
} PromiseJob;

typedef struct Promise {
    Candidate chosen;
    TechniqueError measured; /* of it, on the scene; without metrics */
    bool is_kept;            /* at most what was asked for; else it is the least there is */
    uint32_t tried;          /* settings looked at; of those: */
    uint32_t drawn;          /* measured now */
    uint32_t ruled_out; /* not drawn, for their least errors are too large; others are remembered */
} Promise;

/* Chooses: from the step that the chart proposes to slower ones until one holds, or, where that one
 * does, to faster ones as long as they do; then all others. Settings that do not go with the scene
 * are passed over. Those whose least error is known to be over what is asked for are drawn only
 * where nothing holds, and where they may yet be the best there is.
 * in/out measured: asked before a setting is drawn, and told afterwards
 * errors those of the truth, of drawing and of measuring; GP_ERROR_INVALID: no setting goes with
 *        the scene */
GpResult promise_choose(const PromiseJob *job, Measured *measured, Promise *promise,
                        GpError *error);

#endif
