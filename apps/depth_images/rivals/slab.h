/* The space between a planar depth image's nearest and farthest depths, made a box: what methods
 * that look along the view's rays walk through.
 *
 * Its x and y are places in the picture, from the left and from the top, and its z is the depth;
 * all go from 0 to 1. Where rays meet in an eye z is linear in 1 / depth: then straight lines of
 * the world stay straight in the box, planes stay planes, and neither needs a division at each
 * step.
 * source Policarpo, Oliveira, Comba, "Real-time relief mapping on arbitrary polygonal surfaces",
 *        I3D 2005, for images as boxes; perspective ones: ours
 */
#ifndef APPS_DEPTH_IMAGES_RIVALS_SLAB_H
#define APPS_DEPTH_IMAGES_RIVALS_SLAB_H

#include "apps/depth_images/drawing/textures.h"
#include "apps/depth_images/drawing/view.h"
#include "shaders_c/warp/slab.h"

/* The depth of a pixel that shows nothing, in the box: beyond its end. */
#define SLAB_NOTHING 2.0f

typedef struct DepthSlab {
    bool is_parallel;
    double low, high;     /* depths at z = 0 and 1; all of the image's are between */
    double matrix[4][4];  /* from the world: x w, y w, z w, w; w is above 0 before the eye */
    double corners[8][3]; /* of the box in the world; bits of the number: x, y, z */
    /* of the box on the picture, which goes from 0 to 1: pixels that show something, and one
     * around */
    double first[2], side[2];
} DepthSlab;

/* Pixels of perspective images that are at the eye itself count as nothing.
 * returns false: the image shows nothing */
bool slab_find(const DepthPlane *plane, const DepthPixels *pixels, DepthSlab *slab);

/* z of a depth; SLAB_NOTHING of what is nothing. */
float slab_z(const DepthSlab *slab, float depth);

/* Rays of a view, to be drawn by programs of shaders_c/warp/slab_shared.h. */
typedef struct SlabRays {
    GpGeometry geometry;  /* one triangle, over the whole picture */
    GpRasterState raster; /* pixels that the box is on */
    SlabUniforms uniforms;
} SlabRays;

/* Whether a picture may be so large: a row and a column of cells more must be a texture.
 * errors GP_ERROR_UNSUPPORTED, which names the method */
GpResult slab_check(const DepthImage *image, const char *method, GpError *error);

/* in     frame: owns the corners
 * returns false: nothing is to be seen of the box, or there is no memory, of which the frame
 *        knows */
bool slab_rays(const DepthSlab *slab, const WarpView *view, Frame *frame, SlabRays *rays);

/* The part of a method's uniforms that all have; `depth` is for rays alone, which slab_rays has. */
SlabUniforms slab_uniforms(const DepthSlab *slab, const WarpView *view);

/* Appends a pass that draws over what the target holds, with its depth. */
void slab_pass(const char *name, const WarpTarget *target, Frame *frame);

/* What is nearer than what the target holds replaces it. */
GpDepthState slab_depth_state(const WarpTarget *target);

/* The same on pixels that the box is on. */
GpState slab_state(const SlabRays *rays, const WarpTarget *target);

/* Colours, and normals, which are found from its points where an image lacks them.
 * errors GP_ERROR_MEMORY; owns: the caller, until depth_textures_close */
GpResult slab_textures_open(const DepthImage *image, DepthTextures *textures, GpError *error);

/* Sets slots 1 and 2 of a draw. */
void slab_textures(const DepthTextures *textures, GpDraw *draw);

#endif
