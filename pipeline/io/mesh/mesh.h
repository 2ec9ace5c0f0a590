/* Triangle meshes in memory. */
#ifndef GP_IO_MESH_H
#define GP_IO_MESH_H

#include "pipeline/base/base.h"

/* Arrays are packed and belong to the mesh.
 *
 * Vertices are those of the file in its order, unreferenced ones included, except that
 *  - STL has no vertices, only corners: equal positions are welded, and vertices are numbered by
 *    their first use; -0 and numbers up to the least normal one count as 0 there;
 *  - OBJ corners that give one vertex different normals or texture coordinates get copies of the
 *    vertex, which are appended after all vertices of the file.
 * Triangles are in file order; a polygon v0 v1 v2 v3 .. is the fan (v0 v1 v2) (v0 v2 v3) .. */
typedef struct GpMesh {
    float *positions;  /* [3 * vertex_count], finite, the file's own unit and axes */
    float *normals;    /* [3 * vertex_count], never absent, see gp_mesh_read */
    float *colors;     /* [4 * vertex_count] r g b a as stored, 1 for white; NULL without */
    float *texcoords;  /* [2 * vertex_count] u v, v as in the file; NULL without */
    uint32_t *indices; /* [3 * triangle_count], all < vertex_count */
    uint32_t vertex_count, triangle_count;
    /* faces without area that are left out: STL corners that weld, OBJ polygons with fewer than
     * three different vertices */
    uint32_t skipped_count;
    bool had_normals, had_colors, had_texcoords; /* the file stored them for its vertices */
} GpMesh;

/* Computes vertex normals for all vertices (all true) or those whose normal is (0, 0, 0).
 * in/out mesh: positions and indices are read, normals are written
 * order  the sum over a vertex's triangles of their cross products (so weighted by area) runs in
 *        triangle order, in double; a sum of length zero gives (0, 0, 1)
 * errors GP_ERROR_MEMORY
 * source ours */
GpResult gp_mesh_normals(GpMesh *mesh, bool all);

/* Frees the arrays and empties *mesh; NULL and empty meshes are fine. */
void gp_mesh_free(GpMesh *mesh);

#endif
