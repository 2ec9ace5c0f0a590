/* What of a point model a frame shows: runs of surfels, each with the filter that its splats
 * need. */
#ifndef APPS_TECHNIQUES_POINTS_SELECT_H
#define APPS_TECHNIQUES_POINTS_SELECT_H

#include "apps/techniques/points/model.h"

/* in   model: with patches, where the setting needs them (points_needs_patches)
 * out  source: in the frame's memory
 * errors GP_ERROR_INVALID, with the reason; GP_ERROR_MEMORY */
GpResult points_select(const PointsModel *model, const PointsOptions *options, Frame *frame,
                       SplatSource *source, GpError *error);

#endif
