/* The fragments of a mesh in the order in which the machine makes them, one by one, on the
 * processor. */
#ifndef APPS_FRAGMENTS_DRAWING_STREAM_H
#define APPS_FRAGMENTS_DRAWING_STREAM_H

#include "apps/fragments/drawing/view.h"

typedef struct StreamFragment {
    uint32_t triangle, x, y;
    float depth;
} StreamFragment;

/* Calls `take` with each, triangle by triangle: those that the reference executor tells of.
 * errors GP_ERROR_MEMORY, also where `take` says false, which is then not called again */
GpResult fragment_stream(const FragmentMesh *mesh, const FragmentView *view,
                         bool (*take)(void *context, const StreamFragment *fragment), void *context,
                         GpError *error);

#endif
