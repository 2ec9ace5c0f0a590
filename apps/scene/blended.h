/* What of a pass lets things behind it be seen, where more is drawn than the pass itself draws. */
#ifndef APPS_SCENE_BLENDED_H
#define APPS_SCENE_BLENDED_H

#include "apps/scene/loader.h"

/* Draws that are blended, out of the pass that was read. */
typedef struct SceneBlended {
    GpDraw *draws;
    uint32_t count;
    GpOrder order;
} SceneBlended;

/* Takes them out of the last pass where it has an order by depth, and splats, volumes or shadows:
 * opaque things come first, then splats and volumes, and what is blended at the end, each pixel by
 * depth. In other passes there is nothing to take.
 * in   pass: for failures, of an order that this is not */
SceneBlended scene_take_blended(Loader *loader, Node *pass);

/* Draws them over all that, in a pass NAME-sorted, seen through the volumes. */
void scene_draw_blended(Loader *loader, const Node *pass, const SceneBlended *blended,
                        SceneVolume *volumes, const SceneView *view, const char *name);

#endif
