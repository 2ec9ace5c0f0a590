/* Look-alikes of depth images on one rectangle, whose outline and depth stay those of the
 * rectangle: bump mapping, which only lights the picture by its normals, and parallax mapping,
 * which also moves places by the depth that is found where each of them would be without it.
 * source Blinn, "Simulation of wrinkled surfaces", SIGGRAPH 1978; Kaneko et al., "Detailed shape
 *        representation with parallax mapping", ICAT 2001; limited: Welsh, "Parallax mapping with
 *        offset limiting", Infiscape 2004 */
#ifndef SHADERS_WARP_PARALLAX_H
#define SHADERS_WARP_PARALLAX_H

#include "shaders_c/warp/cells.h"
#include "shaders_c/warp/slab.h"

typedef struct ParallaxUniforms {
    float mvp[4][4];
    SlabUniforms slab;
    CellUniforms cells;
    float eye[4];    /* in the box, homogeneous; of a parallel view towards it */
    float z;         /* of the rectangle in the box */
    float metric[3]; /* lengths of the box's sides */
} ParallaxUniforms;

/* GP_POSITION is a corner, GP_TEXCOORD0 its place in the box. Pixels that show nothing are
 * discarded. */
extern const GpProgram bump_program; /* without light it is a picture */
extern const GpProgram bump_lit_program;
extern const GpProgram parallax_program;
extern const GpProgram parallax_lit_program;
extern const GpProgram parallax_limited_program;
extern const GpProgram parallax_limited_lit_program;

#endif
