/* What a light's shadow map sees: matrices and nothing else. */
#ifndef APPS_TECHNIQUES_SHADOW_LIGHT_VIEW_H
#define APPS_TECHNIQUES_SHADOW_LIGHT_VIEW_H

#include "apps/scene/scene.h"

/* How the map's texels are shared out. */
typedef enum LightFit {
    LIGHT_FIT_LIGHT,    /* over what the light shines at, as the scene has it */
    LIGHT_FIT_CASTERS,  /* over the box of what can cast a shadow */
    LIGHT_FIT_EYE,      /* over what of that is seen, more of them where the eye is near */
    LIGHT_FIT_ADAPTIVE, /* over the box, and tiles of it again, finer, where the eye needs them */
    LIGHT_FITS
} LightFit;

typedef struct LightView {
    double clip[4][4]; /* world to the map's clip space */
    bool parallel;     /* its rays are; w is 1 everywhere */
    double near, far;  /* along the light's view, world units */
    double width;      /* of what the map sees, where w is 1: texels are width / size there */
} LightView;

/* Chooses a light's view of a scene.
 * in   side: number 0..5 of the light's side (+x -x +y -y +z -z), where it does not aim
 * note what the scene leaves open (near, far, height) follows from the box of its vertices */
LightView light_view(const Scene *scene, const SceneLight *light, int side, LightFit fit);

#endif
