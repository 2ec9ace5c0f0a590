/* Relief mapping: each pixel looks for the depth image's surface along its ray: steps of one length
 * until it is on the other side of it, then halves.
 * source Policarpo, Oliveira, Comba, "Real-time relief mapping on arbitrary polygonal surfaces",
 *      I3D 2005.
 *        DEVIATES: the ray ends where the line between the last two heights meets it, instead of at
 *        the last half, so that planes come out exactly; the surface is seen from both sides; and
 *        it has a thickness, behind which rays go on: as printed, walls hang from all edges to the
 *        farthest depth */
#ifndef SHADERS_WARP_RELIEF_H
#define SHADERS_WARP_RELIEF_H

#include "shaders_c/warp/cells.h"
#include "shaders_c/warp/slab.h"

typedef struct ReliefUniforms {
    SlabUniforms slab;
    CellUniforms cells;
    float steps; /* at most 255 */
    float halvings;
} ReliefUniforms;

/* Pixels where nothing is met are discarded; depth is written. */
extern const GpProgram relief_program;
extern const GpProgram relief_lit_program;

#endif
