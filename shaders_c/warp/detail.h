/* Small relief on what depth images show, from a second depth texture. */
#ifndef SHADERS_WARP_DETAIL_H
#define SHADERS_WARP_DETAIL_H

/* Of vertex shaders, which read slot WARP_DETAIL_SLOT: heights 0..1 in red, wrapped round. */
typedef struct WarpDetailUniforms {
    float repeats[2]; /* of the texture over the picture */
    float height;     /* by which 1 comes nearer, world units */
    float level;      /* of the texture that is read */
} WarpDetailUniforms;

enum { WARP_DETAIL_SLOT = 2 };

#endif
