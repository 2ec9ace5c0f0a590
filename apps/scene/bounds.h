/* Where a scene's objects are: boxes along the axes of the world. */
#ifndef APPS_SCENE_BOUNDS_H
#define APPS_SCENE_BOUNDS_H

#include "apps/base/bounds.h"
#include "apps/base/vector.h"
#include "apps/scene/scene.h"

#include <string.h>

static inline void draw_position(const GpDraw *draw, uint32_t vertex, double position[3])
{
    const GpStream *stream = &draw->geometry.streams[GP_POSITION];
    float p[3];
    memcpy(p, (const char *)stream->data + vertex * gp_stream_stride(stream), sizeof p);
    vector_set(position, (double)p[0], (double)p[1], (double)p[2]);
}

Bounds draw_bounds(const GpDraw *draw);
Bounds scene_bounds(const Scene *scene); /* of all objects of the first pass */

#endif
