/* Weighted blended transparency: one pass, no order.
 * source McGuire and Bavoil, "Weighted blended order-independent transparency", JCGT 2(2), 2013 */
#ifndef APPS_FRAGMENTS_DRAWING_WEIGHTED_H
#define APPS_FRAGMENTS_DRAWING_WEIGHTED_H

#include "apps/fragments/drawing/view.h"

/* As view.h has it, but for the order; without glass. errors GP_ERROR_MEMORY */
GpResult weighted_add(const FragmentMesh *mesh, const FragmentView *view, GpSurface *color,
                      GpSurface *depth, Frame *frame, GpError *error);

#endif
