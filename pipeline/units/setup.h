/* Set-up: culls triangles and computes what stays constant inside them; squares for points. */
#ifndef GP_SETUP_H
#define GP_SETUP_H

#include "pipeline/resources/packet.h"

typedef enum GpSetupResult {
    GP_SETUP_DRAWN,
    GP_SETUP_ZERO_AREA, /* snaps to nothing (R4, R8) */
    GP_SETUP_CULLED,    /* faces the culled way */
    GP_SETUP_OUTSIDE,   /* holds no pixel centre of the viewport */
} GpSetupResult;

/* Sets up one triangle from snapped corners.
 * in   corner: screen vertices, the first one provoking; rect: pixels allowed
 * out  triangle, unless culled or of zero area
 * source R2-R5, R8, R16, R22; the order of operations is in CONVENTIONS.md, "Inside a triangle" */
GpSetupResult gp_setup_triangle(const GpScreenVertex corner[3], const GpRasterState *state,
                                const GpRect *rect, GpTriangle *triangle);

/* Twice the signed area in sub-pixels squared; positive is clockwise with y down. Exact. */
int64_t gp_signed_area2(const GpScreenVertex corner[3]);

/* Sets up one point sprite of a side of `size` pixels round its vertex (R12); sizes are clamped to
 * [0, GP_MAX_POINT_SIZE], and NaN draws nothing. */
GpSetupResult gp_setup_point(const GpScreenVertex *center, float size, const GpRect *rect,
                             GpPointSprite *sprite);

#endif
