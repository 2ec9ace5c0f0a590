/* Scenes that move: what a path file says of each moment, as changes of the scene's text.
 *
 * A path has keys, each with a time and with values of the scene as it is then: members of the
 * camera, of lights by their number, of objects by their name. Each number has its own way through
 * the keys that name it: straight from one to the next, or smoothly, by cubic Hermite curves whose
 * slope at a key is that from the key before to the key after it (Catmull and Rom 1974, for times
 * that are not even). Before its first and after its last key it rests. What is no number changes
 * at its keys. All in binary64, by + - * / alone, so that a moment has the same scene on every
 * machine.
 */
#ifndef APPS_SCENE_PATH_H
#define APPS_SCENE_PATH_H

#include "pipeline/base/base.h"

#include <jansson.h>

/* A zeroed one is empty. Owned by whoever opened it, until path_close. */
typedef struct ScenePath {
    double rate;   /* frames a second */
    double *times; /* [count], rising */
    json_t **keys; /* [count], objects: "camera", "lights", "objects" */
    size_t count;
    bool smooth;
    json_t *root; /* private: what the keys are of */
} ScenePath;

/* Reads a path file.
 * errors those of scene_load, with file and line */
GpResult path_open(const char *file, ScenePath *path, GpError *error);
void path_close(ScenePath *path);

/* What is different at a time, in seconds: for path_change. The caller owns it; NULL: out of
 * memory. */
json_t *path_at(const ScenePath *path, double time);

/* Puts changes into a scene's text: members of objects into objects, a light's by its number, an
 * object's into all objects of its name, of all passes.
 * errors GP_ERROR_FORMAT: no such light or object, of which what says the name */
GpResult path_change(json_t *scene, const json_t *changes, GpError *error);

#endif
