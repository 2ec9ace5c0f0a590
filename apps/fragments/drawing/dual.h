/* Dual depth peeling: the nearest and the farthest fragments, then those next to them, and so on.
 * source Bavoil and Myers, "Order independent transparency with dual depth peeling", NVIDIA 2008 */
#ifndef APPS_FRAGMENTS_DRAWING_DUAL_H
#define APPS_FRAGMENTS_DRAWING_DUAL_H

#include "apps/fragments/drawing/view.h"

typedef struct DualSetting {
    uint32_t layers; /* that are seen: two for each pass over the mesh but the first */
} DualSetting;

/* As view.h has it. Fragments of one depth become one, of each channel the greatest.
 * errors GP_ERROR_MEMORY */
GpResult dual_add(const FragmentMesh *mesh, const DualSetting *setting, const FragmentView *view,
                  GpSurface *color, GpSurface *depth, Frame *frame, GpError *error);

#endif
