/* Objects of a scene that are depth images: surfaces as others are, with textures of their own. */
#ifndef APPS_SCENE_DEPTH_IMAGES_H
#define APPS_SCENE_DEPTH_IMAGES_H

#include "apps/scene/loader.h"

/* An object with "depth_image": a draw of the frame's last pass for each image of it, whose
 * vertices are
 * in the world as a mesh's are, at the step that the camera asks for. Whatever draws meshes under a
 * material, and their shadows, draws it too. */
void scene_read_depth_image(Loader *loader, Node *object, const SceneView *view);

#endif
