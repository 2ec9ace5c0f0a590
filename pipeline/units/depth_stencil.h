/* Depth and stencil test, two-sided (R18, R21, R38, R39). */
#ifndef GP_DEPTH_STENCIL_H
#define GP_DEPTH_STENCIL_H

#include "pipeline/resources/packet.h"

typedef struct GpDepthStencil {
    GpSurface *surface; /* depth target, or NULL: every pixel passes */
    GpDepthState depth;
    GpStencilState stencil;
    float min_depth, max_depth; /* of the viewport; depth is clamped to them (R18) */
} GpDepthStencil;

/* Tests one quad and updates the surface.
 * in   quad: depth, mask, front
 * out  surviving pixels in the mask; those of them that replace in `replaced`; operands and
 *      verdicts
 *      in depth_*, stencil_*; depth and stencil of pixels that were alive are written at their
 *      place
 * order quads of one pixel arrive in submission order; stencil first, then depth
 * source Direct3D 9 depth and stencil states; compared as stored codes (R21). Ternary: Weyrich et
 *      al., "A hardware architecture for surface splatting" (2007) */
void gp_depth_stencil(const GpDepthStencil *unit, GpQuad *quad);

/* The code of a depth that is further away by epsilon, which may be past the format's last; the
 * ternary test compares it with codes. Unorm formats add epsilon's own code. */
uint32_t gp_depth_put_back(GpFormat format, uint32_t code, float epsilon);

/* A stencil operation on a stored value, write mask apart (R39). */
uint8_t gp_stencil_apply(GpStencilOp op, uint8_t stored, uint8_t reference);

#endif
