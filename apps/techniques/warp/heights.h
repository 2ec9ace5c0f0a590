/* The small relief that a picture of heights lays over what depth images show. */
#ifndef APPS_TECHNIQUES_WARP_HEIGHTS_H
#define APPS_TECHNIQUES_WARP_HEIGHTS_H

#include "apps/base/bounds.h"
#include "apps/depth_images/drawing/detail.h"
#include "apps/techniques/warp/options.h"

/* A zeroed one is empty: none was asked for. Owned by whoever made it, until warp_heights_close. */
typedef struct WarpHeights {
    GpSurface *surface; /* R32F, all levels */
    double amplitude;   /* as WarpDetail has it */
    uint32_t repeat;    /* of the picture across an image */
} WarpHeights;

/* Reads the picture of the options, if any: its fourth channel where it has one, as pictures of
 * normals with heights do, else the first.
 * in     bounds: of what is seen; a relief of no depth stands out by a fiftieth of its longest side
 * errors those of gp_data_find and picture_read; GP_ERROR_MEMORY */
GpResult warp_heights_open(const WarpOptions *options, const Bounds *bounds, WarpHeights *heights,
                           GpError *error);
void warp_heights_close(WarpHeights *heights);

/* The relief on an image: its squares stay squares, and are as large on all images of a model. Caps
 * of cylinders have none. */
WarpDetail warp_heights_on(const WarpHeights *heights, const DepthModel *model, uint32_t image);

/* Leans the normals of all images by it. errors GP_ERROR_MEMORY */
GpResult warp_heights_lean(const WarpHeights *heights, DepthModel *model, GpError *error);

#endif
