/* Objects of a scene that are drawn as splats. */
#ifndef APPS_SCENE_SPLATS_H
#define APPS_SCENE_SPLATS_H

#include "apps/scene/loader.h"

/* An object with "method": its points, or its mesh's, are kept until the pass ends.
 * errors where the pass cannot have splats: rays are parallel, there is a viewport, no depth, or
 *        not one colour target, all of the pass's size */
void scene_read_splats(Loader *loader, Node *object, const SceneView *view);

/* The end of a pass: all its splats, over what it drew, in passes NAME-visibility, NAME-splats and
 * NAME-surface; they are one surface, lit by the first light as phong is. */
void scene_draw_splats(Loader *loader, const SceneView *view, const char *name);

#endif
