/* Splats as textured quads, four vertices a surfel: EWA in the surfel's own plane. A corner stands
 * on the axes of the filter, object-space: M = s^2 I + h (J^T J)^-1, and its texture coordinates
 * are counted
 * in standard deviations along them, so that perspective is exact.
 * source Ren, Pfister and Zwicker, "Object space EWA surface splatting", Eurographics 2002
 * DEVIATES: the Gaussian is computed, not read from a texture
 */
#ifndef SHADERS_POINTS_QUAD_H
#define SHADERS_POINTS_QUAD_H

#include "shaders_c/points/splat.h"

/* Triangles; texture coordinate 0 is the corner, -1 or 1 along both axes. As the programs of
 * splat.h. */
extern const GpProgram quad_visibility_program, quad_color_program, quad_surface_program;

#endif
