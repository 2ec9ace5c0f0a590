/* The finer tiles of an adaptive shadow map. */
#ifndef APPS_TECHNIQUES_SHADOW_ADAPTIVE_H
#define APPS_TECHNIQUES_SHADOW_ADAPTIVE_H

#include "apps/techniques/shadow/light.h"

/* After the pass that draws the map: passes that ask for finer tiles of it, and one that draws
 * those. To know which, it runs the passes up to there.
 * out  light->table and what follows
 * errors GP_ERROR_MEMORY, and those of gp_device_run */
GpResult shadow_draw_tiles(const ShadowBuild *build, ShadowLight *light, GpError *error);

#endif
