/* Where a scene's objects are: boxes along the axes of the world, and who can shade whom. */
#ifndef APPS_SCENE_BOUNDS_H
#define APPS_SCENE_BOUNDS_H

#include "apps/base/bounds.h"
#include "apps/scene/scene.h"

void draw_position(const GpDraw *draw, uint32_t vertex, double position[3]);

Bounds draw_bounds(const GpDraw *draw);
Bounds scene_bounds(const Scene *scene); /* of all objects of the first pass */

/* Whether an object cannot cast: a level floor under everything but the light shades nothing, since
 * the light is above it as is all that it could shade. The same for walls along the axes. */
bool only_receives(const Scene *scene, const SceneLight *light, const GpDraw *draw);

#endif
