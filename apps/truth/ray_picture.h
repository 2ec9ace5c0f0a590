/* A picture of triangles as they are at each pixel's centre: the nearest one on the ray through it,
 * its colour and how far away it is, in double. What warped pictures are held against. */
#ifndef APPS_TRUTH_RAY_PICTURE_H
#define APPS_TRUTH_RAY_PICTURE_H

#include "apps/base/camera.h"
#include "apps/truth/mesh_paint.h"
#include "apps/truth/ray_scene.h"
#include "pipeline/base/pool.h"

typedef struct RayPictureScene {
    const TruthScene *triangles;
    Camera camera; /* nothing nearer than near or farther than far is seen */
    uint32_t width, height;
    TruthColor *color;
    const void *context;
} RayPictureScene;

typedef struct RayPicture {
    uint32_t width, height;
    double *color; /* [height][width][3]; 0 where nothing is */
    double *depth; /* [height][width]: along the view from the eye; INFINITY where nothing is */
} RayPicture;

/* Room for a picture of nothing. errors GP_ERROR_MEMORY; owns: the caller, until
 * ray_picture_free */
GpResult ray_picture_create(uint32_t width, uint32_t height, RayPicture *picture);

/* order  the same bits for any number of threads
 * errors GP_ERROR_MEMORY; owns: the caller, until ray_picture_free */
GpResult ray_picture_make(const RayPictureScene *scene, GpPool *pool, RayPicture *picture);

void ray_picture_free(RayPicture *picture); /* zeroes it; a zeroed one is fine */

#endif
