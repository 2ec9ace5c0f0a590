/* Procedural meshes and point sets: builtin:NAME.
 *
 * All are made with + - * / and square roots in double and rounded to float once, so they have the
 * same bits everywhere. Triangles turn counter-clockwise seen from outside, as in mesh files;
 * vertices that lie at one place have the same bits, so that no seam can open.
 */
#ifndef APPS_SCENE_SHAPES_H
#define APPS_SCENE_SHAPES_H

#include "apps/scene/shape.h"

/* The i'th name of a mesh, of a point set; NULL behind the last. */
const char *shape_name(size_t i);
const char *shape_points_name(size_t i);

/* Makes a mesh: sphere, ball (a sphere of few triangles), cube, torus, knot, cylinder, cone (all
 * within about 1 of the origin), plane and disc (y = 0, facing +y), quad (z = 0, facing +z), teapot
 * (Newell's, standing on y = 0, 3.15 high). Colours are white, sizes 0.
 * errors GP_ERROR_INVALID (no such name), GP_ERROR_MEMORY */
GpResult shape_create(const char *name, Shape *shape);

/* Makes a point set: sphere (surfels in a Fibonacci spiral) or grid (a square on y = 0), with
 * normals. errors GP_ERROR_INVALID, GP_ERROR_MEMORY */
GpResult shape_create_points(const char *name, Shape *shape);

#endif
