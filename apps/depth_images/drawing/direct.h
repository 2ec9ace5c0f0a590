/* Planar depth images in one pass, straight to the view and with the depth test: merged grids of
 * the front layer and, where holes are to be filled, of what lies behind it
 * (shaders_c/warp/direct.h).
 *
 * Any eye will do: what it cannot see of the images stays empty, and what is behind it is clipped.
 * source ours, after paper 001, section 2; layers: Shade, Gortler, He, Szeliski, "Layered depth
 *        images", SIGGRAPH 1998 */
#ifndef APPS_DEPTH_IMAGES_DRAWING_DIRECT_H
#define APPS_DEPTH_IMAGES_DRAWING_DIRECT_H

#include "apps/depth_images/drawing/detail.h"
#include "apps/depth_images/drawing/grid.h"
#include "apps/depth_images/drawing/textures.h"
#include "apps/depth_images/drawing/view.h"

/* All zero: as it is meant. */
typedef struct DirectSetting {
    bool layers;    /* holes are filled from the second layer */
    bool one_sided; /* insides are left out: of several images of a solid each shows its own side */
    uint32_t step;  /* pixels from vertex to vertex; 0: by the footprint */
    double tolerance; /* of merging, as GridSetting has it */
    /* all zero, with layers: spread 2.5, texels 2, along 0.3: what is steep stays whole, since to
     * cut it opens more holes than the second layer fills; but not what normals say is a jump:
     * sheets there are seen as streaks */
    EdgeSetting edges;
    /* as GridSetting has it; 0: 0.4, with layers 0.5: farther out is more of the silhouette, in
     * colours that are a guess */
    double reach;
    WarpDetail detail;
    const char *name; /* of the pass, borrowed; NULL: "direct" */
} DirectSetting;

enum { DIRECT_STEPS = 5 }; /* of grids that are kept: 1, 2, 4, 8, 16 */

/* A layer as a grid: the front alone; before what is behind it; and that. */
typedef enum DirectLayer { DIRECT_ALONE, DIRECT_BEFORE, DIRECT_BEHIND, DIRECT_LAYERS } DirectLayer;

/* Owned by whoever made it, until direct_close. A zeroed one is empty. Grids and textures are made
 * when a frame first wants them. */
typedef struct Direct {
    const DepthImage *image; /* borrowed */
    WarpGrid grids[DIRECT_LAYERS][DIRECT_STEPS];
    bool has_grid[DIRECT_LAYERS][DIRECT_STEPS];
    DepthTextures textures[2][2]; /* of the front, of what is behind; of one level, of all */
    double center[3], radius;     /* of a ball about the image */
    double pixel;                 /* side of its pixels in the world, about */
} Direct;

/* errors GP_ERROR_INVALID: a cylinder */
GpResult direct_open(const DepthImage *image, Direct *made, GpError *error);

/* Appends a pass. Triangles of the second layer that turn their insides to the eye are left out,
 * where it has normals; grids of settings that are not the usual ones are made for the frame.
 * errors GP_ERROR_MEMORY; those of textures.h */
GpResult direct_add(Direct *made, const DirectSetting *setting, const WarpView *view,
                    const WarpTarget *target, Frame *frame, GpError *error);
void direct_close(Direct *made);

/* What of a view, or of the image, the method cannot do, a sentence; NULL: nothing. */
const char *direct_warning(const DepthImage *image, const WarpView *view);

#endif
