/* What all ways of drawing surfels share: the eye, the light, uniforms and runs. */
#ifndef APPS_POINTS_DRAWING_VIEW_H
#define APPS_POINTS_DRAWING_VIEW_H

#include "apps/frame/frame.h"
#include "apps/points/drawing/setting.h"
#include "shaders_c/points/splat.h"

/* Axes of an eye that looks along z, with y down the picture. */
typedef struct SplatEye {
    double axis[3][3]; /* right, down, forward */
    double focal;      /* pixels */
    double depth[2];   /* depth of a distance z: depth[0] + depth[1] / z */
} SplatEye;

SplatEye splat_eye(const SplatView *view);

/* The light of a view that is lit, which stands to the left of the eye and above it, without
 * end. */
typedef struct SplatLight {
    double towards[3]; /* world, unit length */
    double ambient, specular, shininess;
} SplatLight;

SplatLight splat_light(const SplatView *view);

/* in   filter: SPLAT_RECONSTRUCTION and SPLAT_LOW_PASS leave one out, all others none */
SplatUniforms splat_uniforms(const SplatEye *eye, const SplatView *view,
                             const SplatSetting *setting, SplatMethod filter);

/* Uniforms for each filter that a run may have, of leaves and of merged surfels, in the frame's
 * memory. */
typedef struct FilterUniforms {
    const void *of[2][SPLAT_METHODS];
} FilterUniforms;

static inline const void *splat_run_uniforms(const FilterUniforms *uniforms, const SplatRun *run)
{
    return uniforms->of[run->merged][run->filter];
}

FilterUniforms splat_filter_uniforms(const SplatEye *eye, const SplatView *view,
                                     const SplatSetting *setting, Frame *frame);

/* Surfels of a run as points; a position's fourth component is the radius behind it. */
GpGeometry splat_run_geometry(const SplatSource *source, const SplatRun *run);

/* Draws every run to the frame's last pass, with its filter's uniforms. */
void splat_draw_runs(const SplatSource *source, const FilterUniforms *uniforms,
                     const GpProgram *program, const GpState *state, Frame *frame);

#endif
