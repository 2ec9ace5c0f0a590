/* What the passes of all methods have in common. */
#ifndef APPS_FRAGMENTS_DRAWING_PASSES_H
#define APPS_FRAGMENTS_DRAWING_PASSES_H

#include "apps/fragments/drawing/view.h"
#include "shaders_c/fragments/fragment.h"

typedef struct FragmentPasses {
    const FragmentMesh *mesh;
    const FragmentView *view;
    GpSurface *color, *depth; /* as a method is given them */
    Frame *frame;
    FragmentUniforms uniforms;
} FragmentPasses;

FragmentPasses fragment_passes(const FragmentMesh *mesh, const FragmentView *view, GpSurface *color,
                               GpSurface *depth, Frame *frame);

/* Of the picture's size, the frame's. */
GpSurface *fragment_surface(const FragmentPasses *passes, GpFormat format);

/* As layers have it that have been put together: light, and in alpha what is let through, which
 * glass makes more than 1 on its way. Halves, or floats of glass. */
extern const float fragment_nothing[4];

GpSurface *fragment_layers(const FragmentPasses *passes);

/* A pass that the mesh is drawn in, behind whose opaque things nothing is seen; clears the target
 * to a number in all channels. */
GpPass *fragment_pass(const FragmentPasses *passes, const char *name, GpSurface *target,
                      float clear);

/* Draws the mesh by one of a pair of programs. */
GpDraw *fragment_draw(const FragmentPasses *passes, const GpProgram *plain, const GpProgram *glass);

/* What a pass over all pixels reads in place, slots from 0 on, and draws into, targets from 0
 * on. */
typedef struct FragmentSlots {
    GpSurface *const *read;
    int reads;
    GpSurface *const *target;
    int targets;
} FragmentSlots;

/* Draws all pixels by copied uniforms, as a pass that keeps what its targets have. */
GpDraw *fragment_whole(const FragmentPasses *passes, const char *name, const GpProgram *program,
                       const void *uniforms, FragmentSlots slots);

/* The same of layers, behind those of another surface. */
void fragment_put_under(const FragmentPasses *passes, GpSurface *from, GpSurface *to);

/* Puts layers over the picture. */
void fragment_put_over(const FragmentPasses *passes, GpSurface *layers);

/* Writes the depth of opaque things, if any, into the depth buffer of a pass that has its own. */
void fragment_begin_depth(const FragmentPasses *passes);

/* Of such layers: another behind what is there, and before it. */
extern const GpBlend fragment_under, fragment_before;

/* Of colours multiplied by alpha: before what is there. */
extern const GpBlend fragment_over;

/* The alpha of all triangles. errors GP_ERROR_INVALID: they have several */
GpResult fragment_same_alpha(const FragmentMesh *mesh, float *alpha, GpError *error);

#endif
