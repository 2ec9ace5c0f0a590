/* What all frames of a scene share of its lights: what casts under each, and its views. Both are
 * found from every vertex, and depend on no setting but the fit. */
#ifndef APPS_TECHNIQUES_SHADOW_KEPT_H
#define APPS_TECHNIQUES_SHADOW_KEPT_H

#include "apps/techniques/shadow/light_fit.h"

typedef struct ShadowKept ShadowKept;

/* Nothing is found yet.
 * in     scene: stays as it is; memory: an empty frame, or the one frame that all is for
 * owns   memory, which each light and fit adds to when it is first asked for; NULL without it */
ShadowKept *shadow_keep(const Scene *scene, Frame *memory);

/* The triangles that cast under a light, its number in the scene: frames refer to them. */
const SceneCasters *shadow_kept_casters(ShadowKept *kept, uint32_t light);

/* One view, or six of a light that shines around: [face]. */
const LightView *shadow_kept_views(ShadowKept *kept, uint32_t light, LightFit fit);

/* Whether all memory was there. errors GP_ERROR_MEMORY */
GpResult shadow_kept_result(const ShadowKept *kept, GpError *error);

#endif
