/* Runs of compressed surfels: one draw each, with the frame of its patch. */
#ifndef APPS_POINTS_DRAWING_COMPRESSED_H
#define APPS_POINTS_DRAWING_COMPRESSED_H

#include "apps/points/drawing/view.h"

/* What a pass of two-pass splatting draws. */
typedef enum SplatPass { SPLAT_VISIBILITY, SPLAT_COLORS, SPLAT_SURFACES, SPLAT_PASSES } SplatPass;

/* The vertex texture of the printed form's radii, in the frame; NULL where the form has none. */
GpSurface *compressed_radii(const Compressed *compressed, Frame *frame);

/* Draws every run to the frame's last pass, with its filter's uniforms.
 * in   source: with radii, of compressed_radii */
void compressed_draw_runs(const SplatSource *source, const FilterUniforms *uniforms, SplatPass pass,
                          const GpState *state, Frame *frame);

#endif
