/* Splats of a scene as what casts shadows. */
#ifndef APPS_TECHNIQUES_SHADOW_DISCS_H
#define APPS_TECHNIQUES_SHADOW_DISCS_H

#include "apps/scene/scene.h"
#include "shaders_c/shadow/shadow_discs.h"

/* The scene with one pass, whose draws are those of the first one and, behind them, one for each
 * model that is drawn as splats: a square around the disc of each surfel, of two triangles with an
 * outside, so that all that looks at the objects of a scene sees them too.
 * in     scene: without passes of its own
 * out    made: refers to the scene and to the memory of `memory`
 * errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: over 2^29 surfels in a model */
GpResult shadow_scene_with_discs(const Scene *scene, Frame *memory, Scene *made, GpError *error);

/* Whether a draw is one of those. */
static inline bool shadow_is_disc(const GpDraw *draw)
{
    return draw->program == &shadow_disc_program;
}

#endif
