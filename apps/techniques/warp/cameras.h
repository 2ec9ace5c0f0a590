/* From where models and depth images are looked at. */
#ifndef APPS_TECHNIQUES_WARP_CAMERAS_H
#define APPS_TECHNIQUES_WARP_CAMERAS_H

#include "apps/base/bounds.h"
#include "apps/base/camera.h"
#include "apps/base/orbit.h"
#include "apps/depth_images/depth_image.h"

/* All of a box, from 30 degrees to the right and 20 above. */
Camera camera_beside(const Bounds *bounds, OrbitUp up, double aspect);

/* Turned to the right about what a camera looks at, with near and far about the box. */
Camera camera_turned(const Camera *camera, const Bounds *bounds, double degrees);

/* The camera that takes a planar image, and looks at the middle of what it shows; its picture is
 * about the eye and may be larger. */
Camera camera_of_plane(const DepthPlane *plane, const Bounds *bounds);

/* The box of all that the images show; about the first one's own place where that is nothing. */
Bounds bounds_of_images(const DepthModel *model);

#endif
