/* Depth images of shapes whose truth is known, for tests: cylinders with their caps, by rays. */
#ifndef TESTS_DEPTH_SHAPES_H
#define TESTS_DEPTH_SHAPES_H

#include "apps/depth_images/depth_image.h"
#include "apps/truth/ray_picture.h"
#include "pipeline/resources/surface.h"

/* Triangles, and how rays see them. */
typedef struct DepthShape {
    TruthScene *triangles;
    float *positions; /* [vertex_count][3] */
    uint32_t *indices;
    uint32_t vertex_count, triangle_count;
    MeshPaint paint;                       /* colours by place */
    double center[3], half_height, radius; /* about it, upright */
} DepthShape;

/* A mesh of the program's, "builtin:torus" or a file's, with waves of `waves` over its size; turned
 * about x by degrees. Fails the running test where it cannot be read. */
DepthShape depth_shape_open(const char *name, double waves, double degrees);

/* A vase with bumps: no caps, one depth everywhere; its walls reach from floor to rim. */
DepthShape depth_shape_vase(void);

/* A quarter of a shape about its centre, by x and y: what lies in quarter 0..3, with its own
 * cylinder. */
DepthShape depth_shape_piece(const DepthShape *shape, int quarter);
void depth_shape_close(DepthShape *shape);

/* The cylinder about a shape, and its caps from above and below where `caps` is above 0, so many
 * pixels a side. With normals of its triangles where `normals`. */
DepthModel depth_shape_capture(const DepthShape *shape, uint32_t width, uint32_t height,
                               uint32_t caps, bool normals);

/* What the camera sees of it. Owned by the caller until ray_picture_free. */
RayPicture depth_shape_truth(const DepthShape *shape, const Camera *camera, uint32_t width,
                             uint32_t height);

/* How a picture differs from the truth, as it is told of depth images. */
typedef struct DepthCompared {
    uint32_t covered, missing, extra; /* pixels of the truth; that stay empty; that should */
    double psnr;                      /* of red, green, blue where both cover */
    double depth;                     /* mean distance along the view where both cover */
} DepthCompared;

/* depth: D32F of the same camera */
DepthCompared depth_compare(const RayPicture *truth, const Camera *camera, const GpSurface *color,
                            const GpSurface *depth);

#endif
