/* How volumes are looked at, and what their passes draw into. */
#ifndef APPS_VOLUMES_DRAWING_VIEW_H
#define APPS_VOLUMES_DRAWING_VIEW_H

#include "apps/base/camera.h"
#include "apps/frame/frame.h"
#include "apps/volumes/transfer.h"

typedef struct VolumeView {
    Camera camera; /* in the field's space, perspective or parallel */
    uint32_t width, height;
    bool lit;            /* by a light beside the eye, from gradients of the values */
    float background[4]; /* multiplied by its alpha */
} VolumeView;

/* What is drawn. Borrowed until the frame has run. */
typedef struct VolumeSource {
    const Field *field;
    const Transfer *transfer;
} VolumeSource;

/* Where a volume is drawn among other things: their colour, and their depth, which cuts it. Pixels
 * become volume + (1 - alpha) * colour; alpha likewise. Depth is read and left as it is. */
typedef struct VolumeTarget {
    GpSurface *color; /* any format that blends */
    GpSurface *depth; /* D32F of the view's camera; NULL: nothing stands in the volume */
} VolumeTarget;

#endif
