/* The ground of a walk. Where no object can throw its shadow it is drawn without one, which spares
 * most of it the reading of the map, and shows the same. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_WALK_GROUND_H
#define APPS_DEPTH_IMAGES_DRAWING_WALK_GROUND_H

#include "apps/depth_images/drawing/walk.h"

/* The shadow of a ball on the ground: an ellipse. */
typedef struct WalkShadow {
    double center[3];     /* on the ground */
    double way[2];        /* x and z, unit: in which light goes on, and it is longer */
    double along, across; /* half axes */
} WalkShadow;

/* in   more: added to the radius of the ball about the object */
WalkShadow walk_shadow(const WalkObject *object, const WarpLight *sun, double more);

typedef struct WalkGround {
    const WarpLight *sun;   /* from without end, above the ground */
    const double (*map)[4]; /* [4]: world to the shadow map; NULL: there is none */
    GpTexture texture;      /* the map */
    double texel;           /* in the world: how much wider shadows are in the map than they are */
} WalkGround;

/* Appends its draws to the frame's last pass. */
void walk_ground_draw(const Walk *walk, const WarpView *view, const WalkGround *ground,
                      Frame *frame);

#endif
