/* Surfels in a picture that has been drawn already: they and what is there hide each other, pixel
 * by pixel.
 *
 * Visibility begins with what is there, pushed back as splats push their surface back; sums are as
 * ever; what they make lies over the picture by its alpha, where the depth test says that it is
 * nearer, and leaves its depth where it covers half of a pixel (shaders_c/points/over.h).
 */
#ifndef APPS_POINTS_DRAWING_OVER_H
#define APPS_POINTS_DRAWING_OVER_H

#include "apps/points/drawing/view.h"

/* Names of the passes: what hides, what is added up, what is drawn over the picture. */
typedef struct SplatNames {
    const char *visibility, *sums, *surface;
} SplatNames;

/* Surfels of several models, as one surface. */
typedef struct SplatGroup {
    const SplatSource *sources;
    uint32_t source_count;
    SplatView view; /* perspective, of the picture's size; lit */
    SplatSetting setting;
} SplatGroup;

/* What lights them: uniforms that begin with NormalizeUniforms, all but which belong to the
 * caller. */
typedef struct SplatShading {
    const GpProgram *program;
    void *uniforms;
    /* others for the draw that leaves depth, and alpha of its own; NULL: the same ones, and alpha
     * stays that of the picture */
    void *solid;
    GpTexture map;    /* slot 1, where the program has a shadow map there */
    int surface_slot; /* of the sums of normals and distances */
} SplatShading;

/* How splats shine in scenes: as phong where nothing is said. */
#define SPLAT_SPECULAR  0.3f
#define SPLAT_SHININESS 32

/* The mean radius of the run that has the largest. */
float splat_largest_radius(const SplatGroup *group);

/* Appends three passes, the last of which draws over `color` and `depth`.
 * in   depth: of the picture's size, of any depth format
 *      shading: its normalization is filled in, but for light, specular and shininess */
void splat_build_over(const SplatGroup *group, const SplatNames *names, const SplatShading *shading,
                      GpSurface *color, GpSurface *depth, Frame *frame);

#endif
