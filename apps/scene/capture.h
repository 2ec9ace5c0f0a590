/* Depth images of whole scenes, as they are lit there. */
#ifndef APPS_SCENE_CAPTURE_H
#define APPS_SCENE_CAPTURE_H

#include "apps/depth_images/depth_image.h"
#include "apps/scene/scene.h"

/* Draws a scene and takes its picture with its depth buffer as a planar image: colours clamped to
 * [0, 1], nothing where the depth buffer was left at 1, normals from depths beside each other.
 * Depth is as fine as the scene's depth buffer: of 24 bits z^2 / (2^24 near) at a depth of z. With
 * a second layer all that is drawn with a depth is drawn once more, sorted: the nearest fragment of
 * each pixel is passed, and the first behind it taken that faces the eye. DEVIATES from captures of
 * meshes, which where there is none take a back.
 * in     device: the caller's; behind: with a second layer
 * out    image: untouched on failure
 * errors GP_ERROR_INVALID: the scene has passes of its own, which may look from elsewhere, or no
 *        depth buffer; for a second layer, splats or volumes; those of gp_device_run;
 *        GP_ERROR_MEMORY
 * owns   the caller, until depth_pixels_free of its layers */
GpResult scene_capture(GpDevice *device, const Scene *scene, bool behind, DepthImage *image,
                       GpError *error);

#endif
