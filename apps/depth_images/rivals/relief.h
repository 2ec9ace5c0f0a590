/* Relief mapping of planar depth images: shaders_c/warp/relief.h over all pixels that the box of
 * their depths is on. */
#ifndef APPS_DEPTH_IMAGES_RIVALS_RELIEF_H
#define APPS_DEPTH_IMAGES_RIVALS_RELIEF_H

#include "apps/depth_images/rivals/cells.h"

/* All zero: as it is meant. */
typedef struct ReliefSetting {
    uint32_t steps;    /* of the linear search, to 255; 0: 64 */
    uint32_t halvings; /* of the binary one, to 255; 0: 8 */
    double thickness;  /* as of depth_cells_uniforms; below 0: as printed */
    const char *name;  /* of the pass, borrowed; NULL: "relief" */
} ReliefSetting;

/* A zeroed one is empty, and draws nothing. Owned by whoever made it, until relief_close. */
typedef struct Relief {
    DepthSlab slab;
    DepthCells cells;
    DepthTextures textures;
} Relief;

/* errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: a cylinder, or as large as textures may be at
 *      most */
GpResult relief_open(const DepthImage *image, Relief *relief, GpError *error);
void relief_close(Relief *relief);

/* Appends a pass. errors GP_ERROR_MEMORY */
GpResult relief_add(const Relief *relief, const ReliefSetting *setting, const WarpView *view,
                    const WarpTarget *target, Frame *frame, GpError *error);

#endif
