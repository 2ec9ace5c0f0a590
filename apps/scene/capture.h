/* Depth images of whole scenes, as they are lit there. */
#ifndef APPS_SCENE_CAPTURE_H
#define APPS_SCENE_CAPTURE_H

#include "apps/depth_images/depth_image.h"
#include "apps/scene/scene.h"

/* Draws a scene and takes its picture with its depth buffer as a planar image: one layer, colours clamped to
 * [0, 1], nothing where the depth buffer was left at 1, normals from depths beside each other. Depth is
 * as fine as the scene's depth buffer: of 24 bits z^2 / (2^24 near) at a depth of z.
 * in     device: the caller's
 * out    image: untouched on failure
 * errors GP_ERROR_INVALID: the scene has passes of its own, which may look from elsewhere, or no depth
 *        buffer; those of gp_device_run; GP_ERROR_MEMORY; owns: the caller, until depth_pixels_free of its front */
GpResult scene_capture(GpDevice *device, const Scene *scene, DepthImage *image, GpError *error);

#endif
