/* Cylindrical depth images as printed: warped within the plane that touches the cylinder at the
 * eye's azimuth, in an order that needs no depth test; then that plane as a picture on its
 * rectangle, under the depth test. Caps, planar images of the same model, are drawn where the eye
 * is on their side: from above that from above, from below the other, at the height of the cylinder
 * none.
 *
 * An eye inside the cylinder, as long as it may be, has no such plane, nor have parallel rays:
 * there the same triangles are drawn straight, with the depth test.
 *
 * DEVIATES: caps are surfaces (surface.h), cut at jumps, since the sheets between near and far that
 *        a warped cap has hang in front of the wall; and triangles that turn away are left out.
 * source Liu, Liu, Wu, Journal of Software 18(6), 2007, sections 3.2, 3.3 and 3.5 */
#ifndef APPS_DEPTH_IMAGES_DRAWING_CYLINDER_H
#define APPS_DEPTH_IMAGES_DRAWING_CYLINDER_H

#include "apps/depth_images/drawing/cylinder_strips.h"
#include "apps/depth_images/drawing/detail.h"
#include "apps/depth_images/drawing/surface.h"

enum { CYLINDER_STEPS = 5 }; /* 1, 2, 4, 8, 16 */

/* Of an image of a cylinder, or of a cap. A zeroed one is empty; owned by whoever made it, until
 * cylinder_close. */
typedef struct CylinderWarp {
    const DepthImage *image; /* borrowed */
    DepthTextures textures;
    CylinderStrips strips[CYLINDER_STEPS];
    uint32_t count;
    double pixel;     /* side of the image's pixels in the world, about */
    DepthSurface cap; /* where the image is planar */
} CylinderWarp;

/* All zero: as it is meant. */
typedef struct CylinderSetting {
    uint32_t step;     /* of columns and rows, a power of two; 0: as footprint_step has it */
    WarpDetail detail; /* over the wall: across is once around. Caps have none */
    const char *name;  /* of the pass that draws into the target, borrowed; NULL: "cylinder" */
} CylinderSetting;

/* errors GP_ERROR_MEMORY; those of surface_open and depth_textures_open */
GpResult cylinder_open(const DepthImage *image, CylinderWarp *made, GpError *error);
void cylinder_close(CylinderWarp *made);

/* Appends the passes "cylinder-warp" and NAME; straight, or of a cap, only that.
 * errors GP_ERROR_MEMORY */
GpResult cylinder_add(const CylinderWarp *made, const CylinderSetting *setting,
                      const WarpView *view, const WarpTarget *target, Frame *frame, GpError *error);

/* What of a view the method cannot do as printed, a sentence; NULL: nothing. */
const char *cylinder_warning(const DepthImage *image, const WarpView *view);

#endif
