/* Fixed-function state, cameras and viewports from JSON. */
#ifndef APPS_SCENE_STATE_H
#define APPS_SCENE_STATE_H

#include "apps/scene/loader.h"

/* "camera": changes what is given. */
void scene_read_camera(Node node, Camera *camera);

/* "state" of an object; `state` holds the defaults. World-space clip planes are turned into clip
 * space by the view. */
void scene_read_state(Node node, const SceneView *view, GpState *state);

/* "viewport" of a pass or an object. */
void scene_read_viewport(Node node, GpViewport *viewport);

#endif
