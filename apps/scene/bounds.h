/* Where a scene's objects are: boxes along the axes of the world. */
#ifndef APPS_SCENE_BOUNDS_H
#define APPS_SCENE_BOUNDS_H

#include "apps/base/bounds.h"
#include "apps/scene/scene.h"

void draw_position(const GpDraw *draw, uint32_t vertex, double position[3]);

Bounds draw_bounds(const GpDraw *draw);
Bounds scene_bounds(const Scene *scene); /* of all objects of the first pass */

#endif
