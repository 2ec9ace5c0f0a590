/* Splats of one pass, for the ternary depth test: the nearest surface replaces what lies behind it.
 *
 * The test knows one epsilon for a whole draw, in steps of depth; splats of one surface overlap by
 * footprints, which grow with the distance. So depth is the logarithm of the footprint R + F z (a
 * surfel's radius and the pixel filter's standard deviation at distance z): so many footprints
 * behind is then the same step everywhere, since R + F (z + e (R + F z)) = (R + F z) (1 + e F).
 * source Weyrich et al., "A hardware architecture for surface splatting", SIGGRAPH 2007; depth:
 *      ours
 */
#ifndef SHADERS_POINTS_TERNARY_H
#define SHADERS_POINTS_TERNARY_H

#include "shaders_c/points/splat.h"

typedef struct TernaryUniforms {
    SplatUniforms splat;
    float footprint[2]; /* R, F */
    float depth[2];     /* of a footprint: depth[0] + depth[1] log2 */
} TernaryUniforms;

/* Points that are added up, as those of splat.h are. */
extern const GpProgram ternary_color_program, ternary_surface_program;

#endif
