/* Depth images: pictures whose pixels know how far away is what they show.
 *
 * Row 0 is the top one; the ray of pixel (x, y) goes through (x + 1/2, y + 1/2) of the picture.
 * Space: world, right-handed; lengths are the model's.
 * source Liu, Liu, Wu, "Real-time rendering depth images on GPU by forward warping", Journal of
 *        Software 18(6), 2007: sections 2 (planar) and 3.1 (cylinder)
 */
#ifndef APPS_DEPTH_IMAGES_DEPTH_IMAGE_H
#define APPS_DEPTH_IMAGES_DEPTH_IMAGE_H

#include "pipeline/base/base.h"

#include <math.h>

/* The depth of a pixel that shows nothing. Every other depth is finite and at least 0. */
#define DEPTH_NOTHING INFINITY

/* Where planar images are taken from. Unit vectors, square to each other: right x up = -forward. */
typedef struct DepthPlane {
    bool is_parallel;
    /* where the rays meet; of parallel ones a point of the plane that depths are counted from */
    double eye[3];
    double right[3], up[3], forward[3];
    /* the picture: tangents of angles; parallel: world units from the eye. It need not be about the
     * eye */
    double left, bottom, width, height;
} DepthPlane;

/* A cylinder that is looked through from all sides towards its axis (the paper's DPCI). Pixel (x,
 * y) stands at azimuth 2 pi (x + 1/2) / width, from `zero` towards axis x zero, and at height
 * ((height in pixels) / 2 - (y + 1/2)) / (height in pixels) * height above the centre. */
typedef struct DepthCylinder {
    double center[3];        /* the middle of the axis */
    double axis[3], zero[3]; /* unit, square to each other: up, and azimuth 0 */
    double radius, height;
} DepthCylinder;

/* The pixels of one layer; empty: width 0. */
typedef struct DepthPixels {
    uint32_t width, height;
    /* [height][width]: planar: along `forward` from the eye, for perspective the eye's z, not the
     * length of the ray; cylinder: inwards from its surface */
    float *depth;
    float *color;  /* [height][width][3]: red, green, blue, 0..1, as shown (lit later if at all) */
    float *normal; /* [height][width][3]: world, unit, outwards; NULL: unknown */
} DepthPixels;

typedef struct DepthImage {
    bool is_cylinder;
    union {
        DepthPlane plane;
        DepthCylinder cylinder;
    };
    DepthPixels front; /* what is seen first */
    /* what is seen behind it where the front is taken away (a layered depth image); empty, or of
     * the front's size, DEPTH_NOTHING where nothing was kept */
    DepthPixels behind;
} DepthImage;

enum { DEPTH_MODEL_IMAGES = 6 };

/* Images that are one object, as a file has them: one planar; a cylinder with its two end caps,
 * planar and parallel, from above and from below; six faces of a box. A zeroed one is empty. */
typedef struct DepthModel {
    uint32_t count;
    DepthImage images[DEPTH_MODEL_IMAGES];
} DepthModel;

/* Room for pixels, all DEPTH_NOTHING and black.
 * errors GP_ERROR_MEMORY; owns: the caller, until depth_pixels_free */
GpResult depth_pixels_make(uint32_t width, uint32_t height, bool has_normals, DepthPixels *pixels);
void depth_pixels_free(DepthPixels *pixels); /* a zeroed one is fine */
void depth_model_free(DepthModel *model);

/* The point that a pixel of a depth shows. in x, y: of the picture, in pixels from its left upper
 * corner */
void depth_plane_point(const DepthPlane *plane, const DepthPixels *pixels, double x, double y,
                       double depth, double point[3]);
void depth_cylinder_point(const DepthCylinder *cylinder, const DepthPixels *pixels, double x,
                          double y, double depth, double point[3]);

/* Where a point is in the picture, and at what depth; false: nowhere (behind the eye; on the
 * axis). */
bool depth_plane_place(const DepthPlane *plane, const DepthPixels *pixels, const double point[3],
                       double place[2], double *depth);
bool depth_cylinder_place(const DepthCylinder *cylinder, const DepthPixels *pixels,
                          const double point[3], double place[2], double *depth);

#endif
