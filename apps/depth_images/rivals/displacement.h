/* Per-pixel displacement of planar depth images: shaders_c/warp/displacement.h over all pixels that
 * the box of their depths is on. */
#ifndef APPS_DEPTH_IMAGES_RIVALS_DISPLACEMENT_H
#define APPS_DEPTH_IMAGES_RIVALS_DISPLACEMENT_H

#include "apps/depth_images/rivals/cells.h"
#include "apps/frame/atlas.h"

/* What the field is made by. All zero: as it is meant. */
typedef struct DisplacementField {
    uint32_t size;    /* its samples along the longest side of the box, 8 to 512; 0: 128 */
    double thickness; /* as of depth_cells_uniforms */
} DisplacementField;

/* All zero: as it is meant. */
typedef struct DisplacementSetting {
    uint32_t steps;   /* through the field, to 255; 0: 64 */
    const char *name; /* of the pass, borrowed; NULL: "displacement" */
} DisplacementSetting;

/* A zeroed one is empty, and draws nothing. Owned by whoever made it, until displacement_close. */
typedef struct Displacement {
    DepthSlab slab;
    DepthCells cells;
    DepthTextures textures;
    VolumeAtlas field;
    uint32_t size[3]; /* of the field */
    double metric[3]; /* lengths of the box's sides, in its longest */
    double sample;    /* longest way between samples next to each other, likewise */
    double thickness;
} Displacement;

/* in     field: NULL: all zero
 * errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: a cylinder, or as large as textures may be at
 *        most */
GpResult displacement_open_sized(const DepthImage *image, const DisplacementField *field,
                                 Displacement *displacement, GpError *error);
GpResult displacement_open(const DepthImage *image, Displacement *displacement, GpError *error);
void displacement_close(Displacement *displacement);

/* Appends a pass. errors GP_ERROR_MEMORY */
GpResult displacement_add(const Displacement *displacement, const DisplacementSetting *setting,
                          const WarpView *view, const WarpTarget *target, Frame *frame,
                          GpError *error);

#endif
