/* Windows of fragments that are in flight at once. */
#ifndef APPS_FRAGMENTS_DRAWING_WINDOWS_H
#define APPS_FRAGMENTS_DRAWING_WINDOWS_H

#include "apps/fragments/drawing/view.h"

/* Numbers all fragments of the mesh in the order of drawing, from 0: the window of a triangle is
 * its first fragment's number divided by `fragments`, whole part. So it is the same whoever draws.
 * out  windows: [vertex] of mesh->drawn: that of the triangle whose first corner it is
 * errors those of fragment_stream */
GpResult fragment_windows(const FragmentMesh *mesh, const FragmentView *view, uint32_t fragments,
                          float *windows, GpError *error);

#endif
