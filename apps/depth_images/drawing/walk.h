/* A walk among depth images: a field of objects on the ground, each one of a few models at a place
 * and a size of its own, under a light with a shadow map that is drawn anew for each frame.
 *
 * source paper 001, section 4 (walk-through); how a field is laid out: ours
 */
#ifndef APPS_DEPTH_IMAGES_DRAWING_WALK_H
#define APPS_DEPTH_IMAGES_DRAWING_WALK_H

#include "apps/depth_images/drawing/surface.h"

/* Images that are one object. */
typedef struct WalkModel {
    DepthSurface surfaces[DEPTH_MODEL_IMAGES];
    uint32_t count;
    double base[3];           /* the middle of its foot, in its own space */
    double size;              /* of the largest side of its box */
    double center[3], radius; /* of a ball about it */
} WalkModel;

/* A model's own space is turned about y, scaled and moved to the world. */
typedef struct WalkObject {
    uint32_t model;
    double foot[3]; /* where the base is */
    double sine, cosine, scale;
    double center[3], radius; /* of a ball about it, in the world */
} WalkObject;

/* Owned by whoever made it, until walk_close; a zeroed one is empty. */
typedef struct Walk {
    WalkModel *models;
    WalkObject *objects;
    uint32_t model_count, object_count;
    /* of the field's side, about 0, 0, 0; y is up, objects are 1.2 to 2.4 high or wide */
    double half;
    GpSurface *grass; /* the ground's colours */
} Walk;

/* All zero: as it is meant. */
typedef struct WalkSetting {
    uint32_t map; /* texels a side of the shadow map; 0: 2048 */
    bool no_shadows;
    uint32_t step; /* of all images; 0: of each so that vertices are one to two pixels apart */
} WalkSetting;

/* What a frame draws. */
typedef struct WalkCounts {
    uint32_t objects, triangles, shadow_triangles;
} WalkCounts;

/* Lays out a field: a square grid, a little at random; models take turns.
 * in     models: upright along y; of at least one that shows something
 * errors those of surface_open; GP_ERROR_INVALID: a model shows nothing */
GpResult walk_open(const DepthModel *models, uint32_t model_count, uint32_t object_count,
                   Walk *walk, GpError *error);
void walk_close(Walk *walk);

/* The camera of a closed path, at a share 0..1 of it: among the objects at 0, and above all of them
 * half way. */
Camera walk_camera(const Walk *walk, double share);

/* Appends the passes "map" and "walk", and makes frame->color (A8R8G8B8) and frame->depth.
 * out    counts: NULL: not asked for
 * errors GP_ERROR_MEMORY */
GpResult walk_add(const Walk *walk, const WalkSetting *setting, const Camera *camera,
                  uint32_t width, uint32_t height, Frame *frame, WalkCounts *counts,
                  GpError *error);

#endif
