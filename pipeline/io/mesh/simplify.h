/* Meshes with fewer triangles, by OpenMesh's decimater. */
#ifndef GP_IO_MESH_SIMPLIFY_H
#define GP_IO_MESH_SIMPLIFY_H

#include "pipeline/base/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A mesh to be simplified. Borrowed. */
typedef struct GpSimplifyInput {
    const float *positions;  /* [vertex_count][3], finite */
    const uint32_t *indices; /* [triangle_count][3], all below vertex_count */
    uint32_t vertex_count, triangle_count;
    uint32_t least_triangles; /* no more are taken away than down to so many */
} GpSimplifyInput;

/* The triangles that are left: their vertices are some of those that were there, where they were.
 * Owned by whoever made it, until gp_simplified_free; a zeroed one is empty. */
typedef struct GpSimplified {
    uint32_t *vertices; /* [vertex_count]: which of the mesh's, rising */
    uint32_t *indices;  /* [triangle_count][3], into vertices */
    uint32_t vertex_count, triangle_count;
} GpSimplified;

/* Moves one end of an edge to the other, the cheapest first, as long as no triangle turns over.
 * Vertices at open edges, and where OpenMesh cannot have a triangle (more than two at an edge),
 * stay.
 * order  the same result on every machine
 * errors GP_ERROR_UNSUPPORTED (OpenMesh is not there), GP_ERROR_MEMORY; owns: the caller
 * source Garland, Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997 */
GpResult gp_mesh_simplify(const GpSimplifyInput *input, GpSimplified *simplified, GpError *error);
void gp_simplified_free(GpSimplified *simplified);

/* What the library that is loaded for it calls itself by, `gp_mesh_openmesh`: as above, but for
 * errors GP_ERROR_MEMORY */
typedef GpResult GpSimplifyFn(const GpSimplifyInput *input, GpSimplified *simplified);

#ifdef __cplusplus
}
#endif

#endif
