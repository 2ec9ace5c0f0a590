/* Planar depth images as meshes in the world: a triangle for every three pixels side by side, moved
 * by one matrix, under the depth test; or the same simplified. Colours and normals are fetched at
 * each pixel.
 *
 * source Pajarola, Sainz, Meng, "DMesh: fast depth-image meshing and warping", International
 *        Journal of Image and Graphics 4(4), 2004. DEVIATES: its adaptive mesh is restricted
 *        quadtrees; here OpenMesh collapses edges
 */
#ifndef APPS_DEPTH_IMAGES_RIVALS_DMESH_H
#define APPS_DEPTH_IMAGES_RIVALS_DMESH_H

#include "apps/depth_images/drawing/textures.h"
#include "apps/depth_images/drawing/view.h"

/* How an image becomes a mesh. All zero: every triangle, cut as peers do. */
typedef struct DmeshDetail {
    /* triangles whose depths differ by more than this share of the nearest are left out; 0: 0.02;
     * below 0: none is */
    double cut;
    /* of the triangles that are kept, at least: they are simplified; 0: all are kept */
    double share;
} DmeshDetail;

/* A zeroed one is empty, and draws nothing. Owned by whoever made it, until dmesh_close. */
typedef struct Dmesh {
    float (*positions)[3]; /* world */
    float (*texcoords)[2];
    uint32_t *indices;
    uint32_t vertex_count, triangle_count;
    DepthTextures textures;
} Dmesh;

/* All zero: as it is meant. */
typedef struct DmeshSetting {
    const char *name; /* of the pass, borrowed; NULL: "dmesh" */
} DmeshSetting;

/* in     detail: NULL: all zero
 * errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: a cylinder; simplified, and OpenMesh is not
 *        there */
GpResult dmesh_open_detailed(const DepthImage *image, const DmeshDetail *detail, Dmesh *dmesh,
                             GpError *error);
GpResult dmesh_open(const DepthImage *image, Dmesh *dmesh, GpError *error);
void dmesh_close(Dmesh *dmesh);

/* Appends a pass. errors GP_ERROR_MEMORY */
GpResult dmesh_add(const Dmesh *dmesh, const DmeshSetting *setting, const WarpView *view,
                   const WarpTarget *target, Frame *frame, GpError *error);

#endif
