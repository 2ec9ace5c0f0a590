/* The first step of relief texture mapping: a depth image as it has to be on a plane of its box so
 * that an eye sees it right; in plain C, row by row and then column by column.
 * source Oliveira, Bishop, McAllister, "Relief texture mapping", SIGGRAPH 2000, sections 3 and 4.
 *        DEVIATES: texels have the places that they show, not their colours; of several that fall
 *        on one texel the nearest is kept, whatever their order; gaps between pixels of different
 *        surfaces are not filled */
#ifndef APPS_DEPTH_IMAGES_RIVALS_PREWARP_H
#define APPS_DEPTH_IMAGES_RIVALS_PREWARP_H

#include "apps/depth_images/rivals/slab.h"

/* What the eye is to see on the plane. A zeroed one is empty. */
typedef struct Prewarped {
    uint32_t width, height;   /* 0: nothing is seen */
    double first[2], side[2]; /* of the texture in the box; it may reach beyond */
    float (*texel)[4];        /* [height][width]: place in the box, and 1 where there is one */
} Prewarped;

typedef struct PrewarpInput {
    const DepthSlab *slab;
    const DepthPixels *pixels;
    double eye[4];    /* as slab_eye has it */
    bool is_parallel; /* the view: eye is a direction */
    double plane;     /* its z */
    /* pixels whose depths differ by more than this share of the nearer are of different surfaces;
     * below 0: none are */
    double cut;
} PrewarpInput;

/* Texels are as large as the image's pixels, or larger where they would be more than twice as many
 * along a side.
 * errors GP_ERROR_MEMORY; owns: the caller, gp_free of texel */
GpResult prewarp_make(const PrewarpInput *input, Prewarped *made);

#endif
