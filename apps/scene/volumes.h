/* Objects of a scene that are volumes: scanned ones, drawn by rays. */
#ifndef APPS_SCENE_VOLUMES_H
#define APPS_SCENE_VOLUMES_H

#include "apps/scene/loader.h"

/* An object with "volume", which is kept until the pass ends.
 * errors where the pass cannot have volumes: there is a viewport, or not one colour target of the
 *        pass's size */
void scene_read_volume(Loader *loader, Node *object, const SceneView *view);

/* What only volumes have is refused of an object that is none. */
void scene_refuse_without_volume(Node *object);

/* The end of a pass: its volumes over what it drew, the farthest first, each in a pass NAME-volume;
 * opaque things cut them by the pass's depth. Volumes that overlap are not mixed.
 * returns them */
SceneVolume *scene_draw_volumes(Loader *loader, const SceneView *view, const char *name);

/* Gives a blended draw the colours that it has through the volume before it, if there is one.
 * in   pass: for failures: that there is more than one, or that the draw's program is not phong */
void scene_see_through(Loader *loader, const Node *pass, SceneVolume *volumes,
                       const SceneView *view, GpDraw *draw);

#endif
