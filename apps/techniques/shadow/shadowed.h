/* Scenes that ask for shadows themselves, for commands that know of no technique. */
#ifndef APPS_TECHNIQUES_SHADOW_SHADOWED_H
#define APPS_TECHNIQUES_SHADOW_SHADOWED_H

#include "apps/scene/scene.h"

/* As scene_load; a scene with "shadows" has the passes that the technique draws it by where nothing
 * is set, with the background's alpha, or that of what was drawn last, in its picture.
 * errors those of scene_load and shadow_build; GP_ERROR_INVALID as GP_ERROR_FORMAT, with the
 *      file */
GpResult shadowed_scene_load(const char *path, const SceneOptions *options, Scene *scene,
                             GpError *error);

#endif
