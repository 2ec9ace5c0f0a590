/* Textures from JSON: procedural pictures, files, and targets of earlier passes. */
#ifndef APPS_SCENE_TEXTURES_H
#define APPS_SCENE_TEXTURES_H

#include "apps/scene/loader.h"

/* A picture as a texture: builtin:NAME (patterns.h), or a file, looked for beside the scene's first
 * (NULL: it has none).
 * errors those of pattern_create, gp_data_find_beside and picture_read_surface; owns as they say */
GpResult scene_open_picture(const char *scene, const char *name, bool srgb, bool mips,
                            GpSurface **surface, GpError *error);

/* One element of "textures". */
void scene_read_texture(Loader *loader, Node node, GpTexture *texture);

#endif
