/* How a light's map is shared out: what of the light's view the texels go to. */
#ifndef APPS_TECHNIQUES_SHADOW_LIGHT_FIT_H
#define APPS_TECHNIQUES_SHADOW_LIGHT_FIT_H

#include "apps/techniques/shadow/light_view.h"

typedef enum LightFit {
    LIGHT_FIT_LIGHT,   /* over what the light shines at, as the scene has it */
    LIGHT_FIT_CASTERS, /* over the box of what can cast a shadow */
    LIGHT_FIT_EYE,     /* over what of that is seen, more of them where the eye is near */
    LIGHT_FIT_ADAPTIVE /* over the box, and tiles of it again, finer, where the eye needs them */
} LightFit;

/* The view that a light's map has of its scene under a fit. A cube map (light_shines_around) is not
 * fitted: each face has its quarter turn. */
LightView light_fit(const SceneCasters *casters, int face, LightFit fit);

#endif
