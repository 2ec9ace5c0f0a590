/* Cylindrical depth images of a mesh, with their end caps.
 *
 * source Liu, Liu, Wu, "Real-time rendering depth images on GPU by forward warping", Journal of
 *        Software 18(6), 2007, section 3.1
 */
#ifndef APPS_DEPTH_IMAGES_MAKING_CAPTURE_CYLINDER_H
#define APPS_DEPTH_IMAGES_MAKING_CAPTURE_CYLINDER_H

#include "apps/base/orbit.h"
#include "apps/depth_images/capture.h"

/* How a cylinder's pixels are found. */
typedef enum CaptureRays {
    /* each column is drawn from its own azimuth, so that all pixels are the mesh's; DEVIATES from
     * the paper, whose images of faces are sampled a second time: on a knot at 128x96 their mean
     * error of depth is 350 times as large, and 4 % of the pixels are wrongly covered
     * (test_capture_around prints both) */
    CAPTURE_COLUMNS,
    /* as printed: from six planar images, whose pixels' surfaces are drawn instead of the mesh.
     * DEVIATES: rays find these surfaces, so that nothing is warped into wrong order and no seam is
     * drawn twice */
    CAPTURE_FACES
} CaptureRays;

/* Zero is a default, but for the size. */
typedef struct CaptureTurn {
    DepthCylinder cylinder; /* radius 0: the one about the mesh */
    OrbitUp up;             /* its axis, of that */
    CaptureRays rays;
    uint32_t width, height; /* of the cylinder's image, 1 to GP_MAX_SIZE */
    uint32_t cap;           /* pixels a side of the caps; 0: width / 2, at least 1 */
    bool behind;            /* second layers too */

    /* Called with how many columns are drawn, of all; NULL: nobody asks */
    void (*tell)(const void *listener, uint32_t done, uint32_t all, const char *what);
    const void *listener;
} CaptureTurn;

/* Captures a cylinder, then the caps: parallel, from above with `zero` to the right, from below
 * with axis x zero there. A ray of the cylinder ends at its axis: what is beyond belongs to the
 * other side.
 * out    model: three images; untouched on failure
 * errors those of capture_planar; owns: the caller, until depth_model_free */
GpResult capture_cylinder(GpDevice *device, const CaptureSource *source, const CaptureTurn *turn,
                          DepthModel *model, GpError *error);

#endif
