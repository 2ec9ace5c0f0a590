/* Textures from JSON: procedural pictures, files, and targets of earlier passes. */
#ifndef APPS_SCENE_TEXTURES_H
#define APPS_SCENE_TEXTURES_H

#include "apps/scene/loader.h"

/* One element of "textures". */
void scene_read_texture(Loader *loader, Node node, GpTexture *texture);

#endif
