/* What cases of techniques share: a model that is opened once, frames of which are built again and
 * again. */
#ifndef APPS_BENCH_MADE_H
#define APPS_BENCH_MADE_H

#include "apps/techniques/technique.h"

typedef struct BenchMade {
    const Technique *technique;
    void *setting, *model;
    /* of a frame's list, once all is made that frames share, by this thread, which alone makes
     * it */
    double build_ms;
} BenchMade;

/* A setting of a technique, to be changed before the model is opened.
 * errors those of technique_setting; owns: the caller, until bench_made_free */
GpResult bench_made_create(const Technique *technique, const char *options, BenchMade **made,
                           GpError *error);
void bench_made_free(void *made); /* NULL is fine */

/* errors those of the technique's open */
GpResult bench_made_open(BenchMade *made, const char *path, uint32_t width, uint32_t height,
                         GpError *error);

/* Builds the frame: twice, so that what is made once for a model is there, unless that is not asked
 * for. The frame then owns `made`, also after a failure. errors those of build */
GpResult bench_made_build(BenchMade *made, bool twice, Frame *frame, GpError *error);

#endif
