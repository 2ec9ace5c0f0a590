/* Depth peeling: the nearest fragments, then the nearest behind them, and so on, front to back.
 * source Everitt, "Interactive order-independent transparency", NVIDIA 2001 */
#ifndef APPS_FRAGMENTS_DRAWING_PEEL_H
#define APPS_FRAGMENTS_DRAWING_PEEL_H

#include "apps/fragments/drawing/view.h"

typedef struct PeelSetting {
    uint32_t layers; /* passes over the mesh; fragments behind so many are not seen */
} PeelSetting;

/* As view.h has it. Of fragments of one depth the first in the order of triangles is seen.
 * errors GP_ERROR_MEMORY */
GpResult peel_add(const FragmentMesh *mesh, const PeelSetting *setting, const FragmentView *view,
                  GpSurface *color, GpSurface *depth, Frame *frame, GpError *error);

#endif
