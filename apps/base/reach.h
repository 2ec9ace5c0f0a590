/* Where a body is for a camera: how far away, and on which pixels. Of a body its box is known, or
 * what else lies between eight corners. */
#ifndef APPS_BASE_REACH_H
#define APPS_BASE_REACH_H

#include "apps/base/camera.h"
#include "pipeline/resources/surface.h"

/* Distances along the view between which the body lies, cut to near and far; false: nowhere. */
bool reach_find(double corners[8][3], const Camera *camera, const CameraAxes *axes,
                double reach[2]);

/* Pixels that it is on, and one around; all, where it is not wholly before the eye. May be
 * empty. */
GpRect reach_rect(double corners[8][3], const Camera *camera, const CameraAxes *axes,
                  uint32_t width, uint32_t height);

/* How depth follows from the share r of the way between two distances, as programs take it:
 * z = (depth[0] + depth[1] r) / (depth[2] + depth[3] r). */
void reach_depth(const Camera *camera, const double reach[2], float depth[4]);

#endif
