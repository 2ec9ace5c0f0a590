/* Objects from JSON: geometry, brought to the world, with material and state. */
#ifndef APPS_SCENE_OBJECTS_H
#define APPS_SCENE_OBJECTS_H

#include "apps/scene/loader.h"
#include "apps/scene/shape.h"

/* One element of "objects": mesh or points, transformed to the world, with material and state, as a
 * draw of the frame's last pass; or splats (splats.h), a volume (volumes.h), or a depth image
 * (depth_images.h). */
void scene_read_object(Loader *loader, Node node, const SceneView *view);

/* "quad" of a pass: a rectangle over the whole viewport, in clip space, without depth test. */
void scene_read_quad(Loader *loader, Node node, const SceneView *view, GpDraw *draw);

/* Gives a shape to the frame, as draws have it; without memory there is none. The shape is empty
 * then. */
void scene_keep_shape(Frame *frame, Shape *shape, GpGeometry *geometry);

/* Adds what a program reads and a shape may lack: texture coordinates and sizes of 0, and white. */
void scene_complete_streams(Frame *frame, const GpProgram *program, GpGeometry *geometry);

#endif
