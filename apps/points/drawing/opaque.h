/* Surfels without filters: points that hide what is behind them, in one pass. */
#ifndef APPS_POINTS_DRAWING_OPAQUE_H
#define APPS_POINTS_DRAWING_OPAQUE_H

#include "apps/points/drawing/view.h"

/* Appends the pass; frame->color is the picture, frame->depth its depth.
 * in   setting: of a method that splat_is_opaque */
void splat_build_opaque(const SplatSource *source, const SplatEye *eye, const SplatView *view,
                        const SplatSetting *setting, Frame *frame);

static inline bool splat_is_opaque(SplatMethod method)
{
    return method >= SPLAT_ROUND && method <= SPLAT_SEQUENCE;
}

#endif
