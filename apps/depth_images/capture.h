/* Depth images of meshes, drawn by the pipeline.
 *
 * Depth at a pixel's centre is the surface's, within about 1/512 of a pixel's slope and 2^-20 of
 * itself: the rasterizer rounds corners to 1/256 of a pixel.
 */
#ifndef APPS_DEPTH_IMAGES_CAPTURE_H
#define APPS_DEPTH_IMAGES_CAPTURE_H

#include "apps/base/bounds.h"
#include "apps/base/camera.h"
#include "apps/depth_images/depth_image.h"
#include "pipeline/io/mesh/mesh.h"
#include <glasspipe/glasspipe.h>

/* What is captured: both sides of the triangles of a mesh, which has at least one. Borrowed. */
typedef struct CaptureSource {
    const GpMesh *mesh; /* its normals, and colours; white where it has none */
    double waves;       /* above 0: colours 0.5 + 0.5 sin(waves * position) instead */
} CaptureSource;

/* The box of the triangles. */
Bounds capture_bounds(const CaptureSource *source);

/* The planar image that a camera takes. in aspect: width / height */
DepthPlane depth_plane_of_camera(const Camera *camera, double aspect);

/* One planar image. Zero is a default but for the plane and the size. */
typedef struct CaptureShot {
    DepthPlane plane;
    uint32_t width, height; /* 1 to GP_MAX_SIZE */
    double near, far;       /* only what is between these depths, as a camera's; far 0: all */
    bool behind;            /* the second layer too */
} CaptureShot;

/* Captures a planar image: at each pixel's centre the surface that is nearest, and behind it what
 * is seen when that surface is taken away: the nearest of what faces the eye, where there is any,
 * for that is what an eye sees that moves past an edge; else the nearest back.
 * DEVIATES from Shade et al., "Layered depth images", SIGGRAPH 98, whose layers are all
 *        intersections: the back of what is in front would be the second of them nearly everywhere,
 *        and what comes into view behind it the third.
 * in     device: the caller's
 * out    image: with normals; untouched on failure. A pixel of which nothing is seen is
 *        DEPTH_NOTHING
 * errors GP_ERROR_INVALID (size), GP_ERROR_MEMORY; owns: the caller, until depth_pixels_free of
 *        both layers */
GpResult capture_planar(GpDevice *device, const CaptureSource *source, const CaptureShot *shot,
                        DepthImage *image, GpError *error);

/* --- for other captures ----------------------------------------------------------------------- */

/* A part of a picture: who looks, where in the picture, at which triangles (streams: position,
 * normal and, without waves, colours of four floats). */
typedef struct CaptureView {
    DepthPlane plane;
    double near, far; /* 0 <= near < far */
    GpViewport viewport;
    GpGeometry geometry;
} CaptureView;

/* Draws all views into one picture.
 * in   waves: as above
 * out  behind: NULL: not wanted. Both untouched on failure
 * errors GP_ERROR_INVALID (size), GP_ERROR_MEMORY; owns: the caller */
GpResult capture_views(GpDevice *device, const CaptureView *views, uint32_t count, double waves,
                       uint32_t width, uint32_t height, DepthPixels *front, DepthPixels *behind,
                       GpError *error);

/* The colours that a draw of the source needs: [4] a vertex; NULL: the mesh's own, or there are
 * waves.
 * errors GP_ERROR_MEMORY; owns: the caller, gp_free */
GpResult capture_colors(const CaptureSource *source, float **colors, GpError *error);

#endif
