/* How many fragments there are. */
#ifndef APPS_FRAGMENTS_DRAWING_COUNT_H
#define APPS_FRAGMENTS_DRAWING_COUNT_H

#include "apps/fragments/drawing/view.h"

typedef struct FragmentCount {
    uint64_t fragments; /* of all pixels */
    uint32_t layers;    /* of the pixel that has most */
} FragmentCount;

/* Draws them on a device, and counts. Those that peel, or keep lists, would ask hardware after each
 * pass whether anything is left; here they are told before.
 * in   depth: as a method is given it
 * errors GP_ERROR_MEMORY */
GpResult fragment_count(const FragmentMesh *mesh, const FragmentView *view, GpSurface *depth,
                        GpDevice *device, FragmentCount *count, GpError *error);

#endif
