/* Splats that are exact in perspective, for wide views and close up.
 *
 * EWA takes the projection for affine around a surfel's centre. But the ray of a pixel at an offset
 * d from it meets the surfel's plane at k times the centre's distance, with k = 1 / (1 + g d),
 * where g = (nx, ny) / (f n (x/z, y/z, 1)); and what is there lies, by the affine projection, at k
 * d. So the exact splat is exp(-1/2 k^2 d^T V^-1 d), of the same height: a Gaussian of variance
 * J^-1 V J^-T on the plane.
 * source Botsch, Spernat and Kobbelt, "Phong splatting", PBG 2004, and Weyrich et al., "A hardware
 *        architecture for surface splatting", SIGGRAPH 2007, for rays against planes
 * DEVIATES: they take the larger one of the surfel's and the pixel's Gaussian; here the pixel's is
 *        added to the variance as in EWA, on the plane, so that weights still add up to 1
 */
#ifndef SHADERS_POINTS_PERSPECTIVE_H
#define SHADERS_POINTS_PERSPECTIVE_H

#include "shaders_c/points/splat.h"

/* As those of splat.h, with its uniforms; depths are those of the planes, pixel by pixel. */
extern const GpProgram perspective_visibility_program, perspective_color_program,
    perspective_surface_program;

#endif
