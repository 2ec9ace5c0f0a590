/* Lights from JSON, and what their shadow maps see. */
#ifndef APPS_SCENE_LIGHTS_H
#define APPS_SCENE_LIGHTS_H

#include "apps/base/json_reader.h"
#include "apps/scene/scene.h"

/* "lights" of a scene; where there are none, a direction from above. */
void scene_read_lights(Scene *scene, Node node);

#endif
