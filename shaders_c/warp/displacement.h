/* Displacement by a distance field: each pixel walks along its ray as far as nothing is near, until
 * it is near the depth image's surface, where it looks for it among the image's own cells.
 * source Donnelly, "Per-pixel displacement mapping with distance functions", GPU Gems 2, chapter 8,
 *      2005.
 *        DEVIATES: the field lies flat in a texture; it leads to the surface, which is then met as
 *        by relief mapping, so that planes come out exactly whatever the field's size */
#ifndef SHADERS_WARP_DISPLACEMENT_H
#define SHADERS_WARP_DISPLACEMENT_H

#include "shaders_c/volume/atlas.h"
#include "shaders_c/warp/cells.h"
#include "shaders_c/warp/slab.h"

typedef struct DisplacementUniforms {
    SlabUniforms slab;
    CellUniforms cells;
    VolumePatches field; /* slot 3, linear: distances, 1 is `reach` and more */
    float last[3];       /* of the field's samples along x, y, z: N - 1 */
    float metric[3];     /* lengths of the box's sides, as distances are measured */
    float reach;
    float near;  /* distance at which the surface is looked for, so far before and behind */
    float steps; /* at most 255 */
} DisplacementUniforms;

/* Pixels where nothing is met are discarded; depth is written. */
extern const GpProgram displacement_program;
extern const GpProgram displacement_lit_program;

#endif
