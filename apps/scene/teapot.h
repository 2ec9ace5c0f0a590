/* The Utah teapot. */
#ifndef APPS_SCENE_TEAPOT_H
#define APPS_SCENE_TEAPOT_H

#include "apps/scene/shape.h"

/* errors GP_ERROR_MEMORY */
GpResult teapot_create(Shape *shape);

/* Control points of its bicubic patches, in rows. */
enum { TEAPOT_PATCHES = 32 };
void teapot_control(float control[TEAPOT_PATCHES][4][4][3]);

#endif
