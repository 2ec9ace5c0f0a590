/* How depth images are looked at, and what their passes draw into. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_VIEW_H
#define APPS_DEPTH_IMAGES_DRAWING_VIEW_H

#include "apps/base/camera.h"
#include "apps/depth_images/depth_image.h"
#include "apps/frame/frame.h"

/* A light, world space; a picture without one shows colours as they are. */
typedef struct WarpLight {
    double position[3]; /* of a direction: towards the light, unit */
    bool directional;
    float color[3], ambient[3];
} WarpLight;

typedef struct WarpView {
    Camera camera; /* perspective or parallel */
    uint32_t width, height;
    const WarpLight *light; /* per pixel, Phong, from colours and normals; NULL: none. Borrowed */
} WarpView;

/* Where an image is drawn, over what is there. Pixels that it covers become its colour with alpha
 * 1, where its depth is less; depth is that of the view's camera, as a mesh would write it. */
typedef struct WarpTarget {
    GpSurface *color;
    /* D32F; NULL: images are drawn over each other, in the order of their calls */
    GpSurface *depth;
} WarpTarget;

/* Each method is a pair of files here, METHOD.h and METHOD.c:
 *
 *   GpResult METHOD_open(const DepthImage *image, METHOD *made, GpError *error);
 *       what is kept of the image: textures, grids; owned by the caller until METHOD_close
 *   GpResult METHOD_add(const METHOD *made, const METHODSetting *setting, const WarpView *view,
 *                       const WarpTarget *target, Frame *frame, GpError *error);
 *       appends the passes; a zeroed setting is sensible
 *   void METHOD_close(METHOD *made);
 */

#endif
