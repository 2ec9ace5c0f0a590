/* What a view has no part of, by balls. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_VIEW_PLANES_H
#define APPS_DEPTH_IMAGES_DRAWING_VIEW_PLANES_H

#include "apps/depth_images/drawing/view.h"

/* Of a view: unit normals that point into it, and what is added; sides, near, far. */
typedef struct ViewPlanes {
    double plane[6][4];
} ViewPlanes;

ViewPlanes view_planes(const WarpView *view);

/* Whether some of a ball may be in the view. */
bool view_planes_may_see(const ViewPlanes *planes, const double center[3], double radius);

/* Whether some of what a ball sweeps on its straight way may be. */
bool view_planes_may_see_way(const ViewPlanes *planes, const double from[3], const double to[3],
                             double radius);

#endif
