/* What of a model's levels a picture shows: runs of surfels, each with the filter that its splats
 * need. */
#ifndef APPS_POINTS_DRAWING_CHOOSE_H
#define APPS_POINTS_DRAWING_CHOOSE_H

#include "apps/frame/frame.h"
#include "apps/points/cull.h"
#include "apps/points/drawing/setting.h"

/* How far points may be merged. */
typedef struct SplatDetail {
    /* standard deviation that merging adds to a splat at most; 0: none is merged, but by the
     * adaptive method as its tolerance allows */
    double pixels;
    uint32_t budget; /* splats at most; 0: any number */
} SplatDetail;

/* in   patches: what the source refers to, with their surfels or without
 * out  source: its runs are in the frame's memory
 * errors GP_ERROR_INVALID: the budget is too small; GP_ERROR_MEMORY */
GpResult splat_choose(const Patches *patches, const SplatView *view, const SplatSetting *setting,
                      const SplatDetail *detail, Frame *frame, SplatSource *source, GpError *error);

/* The view as patches are culled in it. */
PointView splat_point_view(const SplatView *view, const SplatSetting *setting);

/* Whether a method's filters differ from patch to patch. */
static inline bool splat_needs_patches(SplatMethod method)
{
    return method == SPLAT_ADAPTIVE || method == SPLAT_AREA || method == SPLAT_DISTANCE;
}

#endif
