/* The second step of relief texture mapping: a rectangle with a texture that was warped for the
 * eye.
 * source Oliveira, Bishop, McAllister, "Relief texture mapping", SIGGRAPH 2000. DEVIATES: the
 *        texture has the places of the depth image that its texels show, and not their colours, so
 *        that these are fetched as sharp as they are, lit, and at their own depth */
#ifndef SHADERS_WARP_RELIEF_TEXTURE_H
#define SHADERS_WARP_RELIEF_TEXTURE_H

#include "shaders_c/warp/slab.h"

typedef struct ReliefTextureUniforms {
    float mvp[4][4];
    SlabUniforms slab;
    float clip[2][4];            /* z and w of clip space, of a place of the box */
    float world[4][4];           /* of a place of the box: x w, y w, z w, w */
    float first[2], per_side[2]; /* from the box to the texture, 0 to 1 */
    /* places next to each other on a surface are less apart than this, in the box */
    float apart[2];
} ReliefTextureUniforms;

/* Slots 0, points, and 3, linear: places in the box, and 1 where there is one. Pixels without are
 * discarded; depth is written. */
extern const GpProgram relief_texture_program;
extern const GpProgram relief_texture_lit_program;

#endif
