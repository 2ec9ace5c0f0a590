/* A picture of triangles as it is on average over each pixel: many samples a pixel, each the
 * nearest triangle at its place, in double. What splats of the triangles' vertices are held
 * against.
 */
#ifndef APPS_TRUTH_MESH_PICTURE_H
#define APPS_TRUTH_MESH_PICTURE_H

#include "apps/base/camera.h"
#include "apps/truth/mesh_paint.h"
#include "pipeline/base/pool.h"

typedef struct MeshPictureScene {
    const float *positions;  /* three a vertex */
    size_t stride;           /* bytes from vertex to vertex */
    const uint32_t *indices; /* three a triangle, both sides of which are seen */
    uint32_t triangle_count;
    Camera camera; /* perspective */
    uint32_t width, height;
    uint32_t samples; /* a side of a pixel, 1 to 15 */
    TruthColor *color;
    const void *context;
} MeshPictureScene;

typedef struct MeshPicture {
    uint32_t width, height;
    uint32_t samples;
    double *color; /* [height][width][3]: mean of the samples that meet a triangle; 0 without any */
    uint8_t *covered; /* [height][width]: so many samples do */
} MeshPicture;

/* errors GP_ERROR_MEMORY; owns: the caller, until mesh_picture_free */
GpResult mesh_picture_make(const MeshPictureScene *scene, GpPool *pool, MeshPicture *picture);

/* Frees and zeroes; a zeroed one is fine. */
void mesh_picture_free(MeshPicture *picture);

/* Whether a pixel and its eight neighbours are wholly covered; at the picture's border they are
 * not. */
bool mesh_picture_is_interior(const MeshPicture *picture, uint32_t x, uint32_t y);

#endif
