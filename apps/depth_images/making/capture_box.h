/* Six planar depth images of a mesh: the faces of a box about it. */
#ifndef APPS_DEPTH_IMAGES_MAKING_CAPTURE_BOX_H
#define APPS_DEPTH_IMAGES_MAKING_CAPTURE_BOX_H

#include "apps/depth_images/capture.h"

/* Captures the parallel images that the six faces of the bounds' box see, a hundredth of its
 * longest side outside; in the order +x, -x, +y, -y, +z, -z.
 * in     side: pixels along the longest side, of a face; pixels are squares; behind: second layers
 *        too
 * out    model: untouched on failure
 * errors those of capture_planar; owns: the caller, until depth_model_free */
GpResult capture_box(GpDevice *device, const CaptureSource *source, uint32_t side, bool behind,
                     DepthModel *model, GpError *error);

#endif
