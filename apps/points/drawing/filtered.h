/* Surfels as splats that are added up.
 *
 * Three passes (paper 004, section 3): visibility leaves the surface's depth, pushed back by epsilon;
 * splats that lie before it add their weighted attributes; the sums are divided by the weights, and
 * lit. With the ternary depth test the first two are one.
 */
#ifndef APPS_POINTS_DRAWING_FILTERED_H
#define APPS_POINTS_DRAWING_FILTERED_H

#include "apps/points/drawing/view.h"

/* Appends the passes; frame->color is the picture, frame->depth its depth, where surfels are lit. */
void splat_build_filtered(const SplatSource *source, const SplatEye *eye, const SplatView *view,
                          const SplatSetting *setting, Frame *frame);

#endif
