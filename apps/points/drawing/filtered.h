/* Surfels as splats that are added up.
 *
 * Three passes (paper 004, section 3): visibility leaves the surface's depth, pushed back by
 * epsilon; splats that lie before it add their weighted attributes; the sums are divided by the
 * weights, and lit. With the ternary depth test the first two are one.
 */
#ifndef APPS_POINTS_DRAWING_FILTERED_H
#define APPS_POINTS_DRAWING_FILTERED_H

#include "apps/points/drawing/view.h"
#include "shaders_c/points/normalize.h"

/* Appends the passes; frame->color is the picture, frame->depth its depth, where surfels are
 * lit. */
void splat_build_filtered(const SplatSource *source, const SplatEye *eye, const SplatView *view,
                          const SplatSetting *setting, Frame *frame);

/* --- what other sequences of passes are made of ----------------------------------------------- */

/* Two surfaces for the sums, or one where surfels are not lit. */
void splat_make_sums(const SplatView *view, const SplatSetting *setting, GpSurface *sums[2],
                     Frame *frame);

/* Draws what leaves visibility to the frame's last pass, which has depth alone. */
void splat_draw_hiders(const SplatSource *source, const FilterUniforms *uniforms,
                       const SplatSetting *setting, Frame *frame);

/* Appends a pass that adds attributes up, from 0; splats behind `visible` are left out. */
GpPass *splat_begin_sums(GpSurface *const sums[2], GpSurface *visible, Frame *frame);

/* Draws all splats to it. */
void splat_draw_sums(const SplatSource *source, const FilterUniforms *uniforms,
                     const SplatView *view, const SplatSetting *setting, Frame *frame);

/* Gives a draw of the last pass what it reads: normalize.h. */
void splat_bind_sums(GpDraw *draw, GpSurface *const sums[2], int surface_slot, GpSurface *hides);

/* Without background. */
NormalizeUniforms splat_normalize_uniforms(const SplatEye *eye, const SplatView *view,
                                           const SplatSetting *setting);

/* One triangle over the whole viewport. */
GpGeometry splat_whole_picture(void);

#endif
