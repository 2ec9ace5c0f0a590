/* Passes from JSON: targets, and the draws into them. */
#ifndef APPS_SCENE_PASSES_H
#define APPS_SCENE_PASSES_H

#include "apps/scene/loader.h"

/* "size" of the scene or of a pass. */
void scene_read_size(Node node, SceneView *view);

/* One element of "passes": appends a pass. */
void scene_read_pass(Loader *loader, Node node);

/* What a pass and a scene without "passes" share: targets, depth, viewport, objects, quad; appends
 * a pass of this name. */
void scene_read_pass_body(Loader *loader, Node *node, const SceneView *view, const char *name);

#endif
