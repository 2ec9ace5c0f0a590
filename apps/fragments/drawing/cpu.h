/* The A-buffer on the processor: a list of fragments for each pixel, sorted, and put together.
 * source Carpenter, "The A-buffer, an antialiased hidden surface method", SIGGRAPH 1984 */
#ifndef APPS_FRAGMENTS_DRAWING_CPU_H
#define APPS_FRAGMENTS_DRAWING_CPU_H

#include "apps/fragments/drawing/view.h"

/* As view.h has it, without glass. The lists are made here; the frame's pass puts the finished
 * layers over the picture.
 * errors GP_ERROR_UNSUPPORTED: something opaque is there; GP_ERROR_MEMORY */
GpResult cpu_add(const FragmentMesh *mesh, const FragmentView *view, GpSurface *color,
                 GpSurface *depth, Frame *frame, GpError *error);

#endif
