/* The machine sorts the fragments of a pixel before it blends them: one pass, in which nothing is
 * lost. */
#ifndef APPS_FRAGMENTS_DRAWING_SORTED_H
#define APPS_FRAGMENTS_DRAWING_SORTED_H

#include "apps/fragments/drawing/view.h"

/* As view.h has it. errors GP_ERROR_MEMORY */
GpResult sorted_add(const FragmentMesh *mesh, const FragmentView *view, GpSurface *color,
                    GpSurface *depth, Frame *frame, GpError *error);

#endif
