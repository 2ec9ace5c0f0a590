/* Clipping: cuts triangles to the near and far planes and to the guard band. */
#ifndef GP_CLIP_H
#define GP_CLIP_H

#include "pipeline/resources/packet.h"

enum {
    GP_CLIP_LEFT,
    GP_CLIP_RIGHT,
    GP_CLIP_BOTTOM,
    GP_CLIP_TOP,
    GP_CLIP_NEAR,
    GP_CLIP_FAR,
    GP_CLIP_PLANES,
    GP_MAX_CLIPPED = 3 + GP_CLIP_PLANES, /* corners of a triangle cut by every plane */
};

/* The guard band seen from clip space: x/w and y/w outside these limits would leave the fixed-point
 * range after the viewport (R3). Triangles that only leave the viewport are not cut. */
typedef struct GpGuardBand {
    float left, right, bottom, top; /* left < -1 ... top > 1 */
} GpGuardBand;

typedef struct GpClipPolygon {
    int corners;     /* 0: nothing is left */
    bool cut;        /* some plane cut it: corners are new vertices */
    unsigned planes; /* bit i: some corner was outside plane i */
    GpVertex corner[GP_MAX_CLIPPED];
    double share[GP_MAX_CLIPPED][3]; /* of the triangle's vertices in a corner, in clip space */
} GpClipPolygon;

/* How the varyings of new corners are found; the others are linear in clip space. */
typedef struct GpClipVaryings {
    int components;
    uint64_t flat;   /* bit i: component i keeps the first vertex's value */
    uint64_t screen; /* bit i: component i is linear on the screen */
} GpClipVaryings;

/* Guard band for a viewport. */
GpGuardBand gp_guard_band(const GpViewport *viewport);

/* Clips one triangle.
 * in   clip-space vertices, the first one provoking
 * out  a convex polygon, same winding, starting at the first corner that is left
 * order planes near, far, left, right, bottom, top; a new corner is computed from the inside end of
 *      its edge to the outside end, so two triangles that share an edge share its cut
 * note a NaN in any position, or w <= 0 after clipping, leaves nothing (R10); nor does what
 *      rounding bends so that it would have more than GP_MAX_CLIPPED corners
 * source Sutherland and Hodgman, "Reentrant polygon clipping", CACM 17 (1974); OpenGL 4.6, section
 *      13.8.1, of what is linear on the screen; R3, R10 */
void gp_clip_triangle(const GpGuardBand *band, const GpVertex *const triangle[3],
                      const GpClipVaryings *varyings, GpClipPolygon *polygon);

/* Whether a point's vertex is kept: 0 <= z <= w, w > 0, no NaN (R12). */
bool gp_clip_point(const GpVertex *vertex);

#endif
