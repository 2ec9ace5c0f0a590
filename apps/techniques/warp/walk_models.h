/* Models for a walk among depth images: meshes by name, captured as cylinders with their caps. */
#ifndef APPS_TECHNIQUES_WARP_WALK_MODELS_H
#define APPS_TECHNIQUES_WARP_WALK_MODELS_H

#include "apps/depth_images/drawing/walk.h"
#include <glasspipe/glasspipe.h>

typedef struct WalkOptions {
    const char *const *names; /* of meshes, as everywhere */
    uint32_t name_count;      /* 0: builtin ones */
    uint32_t objects;
    uint32_t pixels; /* columns and rows of the cylinders */
} WalkOptions;

/* Captures the models, each in a colour of its own where its file has none, and lays them out.
 * errors those of model_mesh, capture_cylinder and walk_open; GP_ERROR_FORMAT: a model has no faces
 * owns   the caller, until walk_close */
GpResult walk_open_models(GpDevice *device, const WalkOptions *options, Walk *walk, GpError *error);

#endif
