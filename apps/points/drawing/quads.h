/* Surfels as quads: four vertices each. */
#ifndef APPS_POINTS_DRAWING_QUADS_H
#define APPS_POINTS_DRAWING_QUADS_H

#include "apps/points/drawing/view.h"

/* Vertices and indices of all runs, in the frame's memory, for programs of shaders_c/points/quad.h.
 * Empty where memory runs short, which the frame then says. */
GpGeometry splat_quads(const SplatSource *source, Frame *frame);

#endif
