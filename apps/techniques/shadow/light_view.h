/* What a light sees by itself: matrices and nothing else. */
#ifndef APPS_TECHNIQUES_SHADOW_LIGHT_VIEW_H
#define APPS_TECHNIQUES_SHADOW_LIGHT_VIEW_H

#include "apps/scene/casters.h"

typedef struct LightView {
    double clip[4][4]; /* world to the map's clip space */
    bool parallel;     /* its rays are; w is 1 everywhere */
    double near, far;  /* along the light's view, world units */
    double width;      /* of what the map sees, where w is 1: texels are width / size there */
} LightView;

/* Whether a light shines to all sides; it then has six views, the faces of a cube map. */
bool light_shines_around(const SceneLight *light);

/* A light's own view of its scene.
 * in   face: number 0..5 of the cube map's face (+x -x +y -y +z -z), where the light shines around
 *      tight: near and far enclose the scene's vertices even where the scene names them
 * note what the scene leaves open (near, far, height) follows from the box of its vertices */
LightView light_view(const SceneCasters *casters, int face, bool tight);

#endif
