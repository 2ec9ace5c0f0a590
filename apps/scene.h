/* Scenes: a JSON description turned into surfaces, geometry and a list of passes. */
#ifndef APPS_SCENE_H
#define APPS_SCENE_H

#include "pipeline/glasspipe.h"

typedef struct SceneOptions {
    uint32_t width, height; /* 0: the scene's own size */
} SceneOptions;

/* Everything that a scene's list points to. Owned by the caller until scene_free. */
typedef struct Scene {
    GpList list;
    GpSurface *picture;       /* the colour target that `render` writes */
    GpSurface *depth;         /* its depth target, or NULL */
    struct SceneStore *store; /* meshes, textures, uniforms, draws: private */
} Scene;

/* Reads a scene file and everything it names.
 * errors GP_ERROR_IO (file); GP_ERROR_FORMAT (JSON, unknown keys, wrong types, numbers out of
 *        range, missing meshes and pictures) with the JSON path and the line, such as
 *        "x.json:12: objects[1].material.shininess: expected a number in [0, 10000]";
 *        GP_ERROR_MEMORY */
GpResult scene_load(const char *path, const SceneOptions *options, Scene *scene, GpError *error);

/* Frees everything and zeroes the struct; a zeroed scene is fine. */
void scene_free(Scene *scene);

#endif
