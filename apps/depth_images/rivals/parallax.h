/* Bump and parallax mapping of planar depth images on a rectangle: shaders_c/warp/parallax.h. They
 * move no outline, and their depth is that of the rectangle. */
#ifndef APPS_DEPTH_IMAGES_RIVALS_PARALLAX_H
#define APPS_DEPTH_IMAGES_RIVALS_PARALLAX_H

#include "apps/depth_images/rivals/cells.h"

typedef enum ParallaxKind {
    PARALLAX_OFFSET = 0, /* as Kaneko has it: places run away where the view is flat */
    PARALLAX_LIMITED,    /* as Welsh has it */
    PARALLAX_BUMP        /* not moved, only lit */
} ParallaxKind;

/* All zero: as it is meant. */
typedef struct ParallaxSetting {
    ParallaxKind kind;
    double plane;     /* where among the depths the rectangle stands, above 0 to 1; 0: half way */
    const char *name; /* of the pass, borrowed; NULL: "parallax" */
} ParallaxSetting;

/* A zeroed one is empty, and draws nothing. Owned by whoever made it, until parallax_close. */
typedef struct Parallax {
    DepthSlab slab;
    DepthCells cells;
    DepthTextures textures;
} Parallax;

/* errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: a cylinder, or as large as textures may be at
 *      most */
GpResult parallax_open(const DepthImage *image, Parallax *parallax, GpError *error);
void parallax_close(Parallax *parallax);

/* Appends a pass. errors GP_ERROR_MEMORY */
GpResult parallax_add(const Parallax *parallax, const ParallaxSetting *setting,
                      const WarpView *view, const WarpTarget *target, Frame *frame, GpError *error);

#endif
