/* Procedural pictures: builtin:NAME as a texture. The same bits everywhere. */
#ifndef APPS_SCENE_PATTERNS_H
#define APPS_SCENE_PATTERNS_H

#include "pipeline/resources/surface.h"

/* The i'th name; NULL behind the last. */
const char *pattern_name(size_t i);

/* Makes a 256x256 picture, A8R8G8B8 or (srgb) A8R8G8B8_SRGB.
 *   checker   8x8 squares, light and dark            gradient  red to the right, green downwards
 *   bricks    a wall, the next brick half way on     uv        8x8 squares with their column, row
 *   noise     value noise, grey                      dots      white spots, alpha 0 between them
 *   leaf      a leaf with alpha 0 around it          glow      white, alpha falls from the centre
 *   levels    a checker, another colour in each mip level
 * in   mips: with all levels down to 1x1, averaged (levels: drawn)
 * errors GP_ERROR_INVALID (no such name), GP_ERROR_MEMORY
 * owns the caller destroys the surface */
GpResult pattern_create(const char *name, bool srgb, bool mips, GpSurface **surface,
                        GpError *error);

#endif
