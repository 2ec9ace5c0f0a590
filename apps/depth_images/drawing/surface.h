/* Depth images drawn straight: as surfaces in the world, of as few triangles as stand for them,
 * with colours and normals of their textures at each pixel, under the depth test. Planes and
 * cylinders alike.
 *
 * source ours; the paper's warping within a plane does with two dimensions and an order of drawing
 *        what a machine with a depth test does as quickly with three
 */
#ifndef APPS_DEPTH_IMAGES_DRAWING_SURFACE_H
#define APPS_DEPTH_IMAGES_DRAWING_SURFACE_H

#include "apps/depth_images/drawing/merge.h"
#include "apps/depth_images/drawing/textures.h"
#include "apps/depth_images/drawing/view.h"

enum { SURFACE_MAX_LEVELS = 8 };

/* How an image is made a surface. All zero: as it is meant. */
typedef struct SurfaceDetail {
    /* How far the surface may be from the image's points, in its pixels; 0: 1/4 */
    double tolerance;
    /* Neighbours whose depths differ by more than so many times their distance are not one surface,
     * where that is a jump and no slope; 0: 4; below 0: all are */
    double cut;
    /* [height][width]: 1: pixels that are to be drawn, triangles with none of them are left out.
     * NULL: all are. Borrowed while it is opened */
    const uint8_t *own;
} SurfaceDetail;

typedef struct SurfaceVertex {
    float position[3], texcoord[2], normal[3];
} SurfaceVertex;

/* The image with every `step`th column and row. */
typedef struct SurfaceLevel {
    uint32_t step;
    MergedMesh mesh;
    SurfaceVertex *vertices; /* [mesh.vertex_count] */
} SurfaceLevel;

/* A zeroed one is empty. Owned by whoever made it, until surface_close. */
typedef struct DepthSurface {
    bool is_cylinder;
    DepthTextures textures;
    SurfaceLevel levels[SURFACE_MAX_LEVELS]; /* steps 1, 2, 4 ... */
    uint32_t level_count;
    double center[3], radius; /* of a ball about it */
    double pixel;             /* side of the image's pixels in the world, about */
} DepthSurface;

/* The shadow map of a light from without end, as programs read it. */
typedef struct SurfaceShadow {
    float map[3][4]; /* to it: u, v, depth */
    GpTexture texture;
} SurfaceShadow;

/* All zero: as it is meant. */
typedef struct SurfaceSetting {
    uint32_t step;   /* of columns and rows, a power of two; 0: as surface_step has it */
    bool both_sides; /* insides are drawn too; else what turns away is left out */
    /* For images that are small in the picture: everywhere the level of textures that belongs to
     * the footprint, and the way to the eye as it is in the middle. Their light is from without
     * end */
    bool is_distant;
    const SurfaceShadow *shadow; /* of the view's light; NULL: none. Borrowed */
    const char *name;            /* of the pass, borrowed; NULL: "surface" */
} SurfaceSetting;

/* Normals that the image lacks are found from its points.
 * in     detail: NULL: as it is meant
 * errors GP_ERROR_MEMORY; GP_ERROR_INVALID: larger than textures may be */
GpResult surface_open(const DepthImage *image, const SurfaceDetail *detail, DepthSurface *surface,
                      GpError *error);
void surface_close(DepthSurface *surface);

/* The step of columns and rows for a view, as footprint_step has it. */
uint32_t surface_step(const DepthSurface *surface, const WarpView *view);

/* Appends a pass. errors GP_ERROR_MEMORY */
GpResult surface_add(const DepthSurface *surface, const SurfaceSetting *setting,
                     const WarpView *view, const WarpTarget *target, Frame *frame, GpError *error);

/* Its draws alone, into the frame's last pass; with depth test where `has_depth`. What is outside
 * the view is left out. returns triangles that are drawn */
uint32_t surface_draw(const DepthSurface *surface, const SurfaceSetting *setting,
                      const WarpView *view, bool has_depth, Frame *frame);

/* What a light's shadow map sees of it: depth alone, by shaders_c/common/depth_only.h. */
uint32_t surface_draw_depth(const DepthSurface *surface, const SurfaceSetting *setting,
                            const WarpView *view, Frame *frame);

#endif
