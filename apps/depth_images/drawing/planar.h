/* Planar depth images as printed: every cell is warped inside a plane by a table, in an order that
 * needs no depth test, and the plane is then a picture on its rectangle, under the depth test of
 * the view (shaders_c/warp/planar.h).
 *
 * The plane stands at the nearest depth. An eye that is on it, or beyond, moves it to the middle of
 * what is in front of the eye; what is not is left out.
 * DEVIATES: the picture is not the image's own rectangle but that to which anything visible is
 *        warped; and the second target holds no Zt but what follows from it, which is linear
 *        within a triangle.
 * source Liu, Liu, Wu, Journal of Software 18(6), 2007, section 2 */
#ifndef APPS_DEPTH_IMAGES_DRAWING_PLANAR_H
#define APPS_DEPTH_IMAGES_DRAWING_PLANAR_H

#include "apps/depth_images/drawing/detail.h"
#include "apps/depth_images/drawing/edges.h"
#include "apps/depth_images/drawing/plane.h"
#include "apps/depth_images/drawing/textures.h"
#include "apps/depth_images/drawing/view.h"

/* All zero: as printed, but for an eye that is not in front of the plane. */
typedef struct PlanarSetting {
    uint32_t step;    /* pixels from vertex to vertex; 0: by the footprint */
    uint32_t entries; /* of the table, 2 to 8192; 0: 4096; 256 is what depths of 8 bits have */
    bool is_cut;      /* surfaces end as edges.h has it; else sheets hang between near and far */
    bool stays;       /* the plane, and all cells, wherever the eye is */
    WarpDetail detail;
    const char *name; /* of the second pass, borrowed; NULL: "planar" */
} PlanarSetting;

/* Owned by whoever made it, until planar_close. A zeroed one is empty. */
typedef struct Planar {
    const DepthImage *image; /* borrowed */
    DepthTextures textures;
    DepthLattice lattices[2];        /* with sheets, and cut */
    DepthExtent extent;              /* low above high: it shows nothing */
    double center[3], radius, pixel; /* of a ball about it; side of its pixels there */
} Planar;

/* errors GP_ERROR_INVALID: a cylinder; those of depth_textures_open */
GpResult planar_open(const DepthImage *image, Planar *made, GpError *error);

/* Appends passes "planar-warp" and NAME. errors GP_ERROR_MEMORY */
GpResult planar_add(const Planar *made, const PlanarSetting *setting, const WarpView *view,
                    const WarpTarget *target, Frame *frame, GpError *error);
void planar_close(Planar *made);

/* What of a view the method cannot do as printed, a sentence; NULL: nothing. */
const char *planar_warning(const DepthImage *image, const WarpView *view);

#endif
