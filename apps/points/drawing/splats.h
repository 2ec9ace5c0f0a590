/* Surfels as a picture: the passes that draw them, by any method. */
#ifndef APPS_POINTS_DRAWING_SPLATS_H
#define APPS_POINTS_DRAWING_SPLATS_H

#include "apps/frame/frame.h"
#include "apps/points/drawing/setting.h"

/* Appends the passes; frame->color is the picture, frame->depth its depth, where surfels are lit.
 * errors GP_ERROR_INVALID: rays are parallel; GP_ERROR_MEMORY is the frame's own */
GpResult splats_build(const SplatSource *source, const SplatView *view, const SplatSetting *setting,
                      Frame *frame, GpError *error);

#endif
