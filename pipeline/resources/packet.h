/* What travels between the units of the reference executor: vertices, triangles, quads. */
#ifndef GP_PACKET_H
#define GP_PACKET_H

#include "pipeline/resources/state.h"

#include <math.h>

enum {
    GP_SUBPIXEL_BITS = 8,
    GP_SUBPIXELS = 1 << GP_SUBPIXEL_BITS, /* steps a pixel (R2) */
    GP_MAX_POINT_SIZE = 4096,             /* pixels a side of a point sprite */
};

/* Nearest 24.8 fixed-point number, ties to even (R2); |value| <= 33000. The product is exact, and
 * so is nearbyintf. */
static inline int32_t gp_snap(float value)
{
    return (int32_t)nearbyintf(value * (float)GP_SUBPIXELS);
}

/* A shaded vertex. */
typedef struct GpVertex {
    float clip[4]; /* clip space, 0 <= z <= w inside */
    float varying[GP_MAX_VARYINGS];
    float point_size; /* pixels */
} GpVertex;

/* A vertex on the screen. */
typedef struct GpScreenVertex {
    int32_t x, y; /* 24.8 fixed point, inside the guard band */
    float z;      /* depth, not yet clamped */
    float rw;     /* 1 / clip w */
    float clip_distance[GP_MAX_CLIP_PLANES];
    const float *varying;
} GpScreenVertex;

/* A triangle ready for the rasterizer. Corners are ordered so that area2 > 0; corner 0 is always
 * the first vertex, whose values flat interpolants take. Edge i lies opposite corner i:
 *   E_i(x, y) = a[i] * x + b[i] * y + c[i],   x, y in sub-pixels,
 * an exact integer, positive inside; the three sum to area2 everywhere. */
typedef struct GpTriangle {
    GpScreenVertex corner[3];
    int64_t a[3], b[3], c[3];
    int64_t area2;
    bool accepts_zero[3];   /* top or left edge: a centre exactly on it is inside (R5) */
    bool front;             /* clockwise on the screen */
    int32_t x0, y0, x1, y1; /* pixels whose centres may be inside, ends included */

    /* depth = z_base + E_1 * z_step[0] + E_2 * z_step[1], in binary64 */
    double z_base, z_step[2];
    float inverse_area; /* 1 / area2 */

    /* interpolants are summed from the corner that is nearest to the eye on: it has the greatest
     * rw, and is the first of those that have */
    int nearest;
    float rw_ratio[2]; /* rw of the two corners after it, in their order, over its own: 0..1 */
} GpTriangle;

/* A point sprite ready for the rasterizer: covers centres in [left, right) x [top, bottom). */
typedef struct GpPointSprite {
    GpScreenVertex center;
    int32_t left, top, right, bottom; /* 24.8 fixed point */
    int32_t x0, y0, x1, y1;           /* pixels, ends included */
} GpPointSprite;

/* A 2x2 block of pixels on its way down; pixel i is (x + i%2, y + i/2), x and y even. Pixels
 * outside the mask are helpers: they have values, so that differences exist, but are not drawn. */
typedef struct GpQuad {
    int32_t x, y;
    unsigned mask; /* bit i: pixel i is alive */
    bool front;
    int64_t edge[3][4];      /* edge functions at the centres; triangles only */
    float barycentric[3][4]; /* perspective-correct */
    float depth[4];
    float varying[GP_MAX_VARYINGS][4];
    float color[GP_MAX_TARGETS][4][4];       /* [target][channel][pixel]: shader's, then blended */
    float destination[GP_MAX_TARGETS][4][4]; /* what the target held, where blending reads it */
    unsigned killed;                         /* bit i: the pixel shader discarded pixel i */

    /* what the depth and stencil unit saw and decided, for pixels alive when they reached it */
    uint32_t depth_incoming[4], depth_stored[4]; /* codes, as compared (R21) */
    uint8_t stencil_before[4], stencil_after[4];
    unsigned stencil_passed, depth_passed;
    unsigned replaced; /* bit i: by the ternary test pixel i replaces what its targets hold */
} GpQuad;

#endif
