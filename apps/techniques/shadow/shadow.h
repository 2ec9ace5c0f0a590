/* Shadow maps: for each light a pass that draws its map, and one that lights the scene under it. */
#ifndef APPS_TECHNIQUES_SHADOW_SHADOW_H
#define APPS_TECHNIQUES_SHADOW_SHADOW_H

#include "apps/frame/frame.h"
#include "apps/techniques/shadow/kept.h"
#include "apps/techniques/shadow/setting.h"

/* Builds the frame of a scene whose objects have the program phong, textured_phong or mapped_phong,
 * but for what lies over them (scene.h): volumes, and in an order by depth what is blended.
 * in   kept: the scene's, which outlives the frame; NULL: the frame finds its own
 *      device: runs what an adaptive map asks first; frame: zeroed
 * out  frame->color: A8R8G8B8; with one light, alpha is its visibility; 0 where nothing was drawn
 * errors GP_ERROR_INVALID: the setting contradicts itself, the scene has passes of its own, no
 *        light or an object of another program, with the reason; *frame is then empty */
GpResult shadow_build(const Scene *scene, ShadowKept *kept, const ShadowSetting *setting,
                      GpDevice *device, Frame *frame, GpError *error);

#endif
