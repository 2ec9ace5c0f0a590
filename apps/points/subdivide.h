/* Meshes made ready for points: without what no triangle uses, and finer. */
#ifndef APPS_POINTS_SUBDIVIDE_H
#define APPS_POINTS_SUBDIVIDE_H

#include "pipeline/io/mesh/mesh.h"

/* Copies a mesh, without its texture coordinates.
 * errors GP_ERROR_MEMORY
 * owns   the caller, until gp_mesh_free */
GpResult mesh_copy(const GpMesh *mesh, GpMesh *copy);

/* Takes from a mesh the triangles that do not have three different corners, vertices that no
 * triangle then uses, and texture coordinates; what is left keeps its order. Normals that the file
 * did not store are made again by gp_mesh_normals.
 * errors GP_ERROR_MEMORY */
GpResult mesh_keep_referenced(GpMesh *mesh);

/* Cuts each triangle into four at the midpoints of its sides. Vertices keep their numbers; the
 * midpoint of an edge is one vertex for all triangles at that edge and follows them in the order of
 * edges_find. Positions and colours of midpoints are means, and normals that the file stored are,
 * at unit length, where both ends' are within CREASE_DEGREES of the triangles at the edge. Others
 * are made again by gp_mesh_normals: a midpoint has that of the two triangles at it, so that its
 * disc lies as close to both as one disc can; the mean of its ends' would lean with triangles
 * farther away.
 * in     mesh: as mesh_keep_referenced leaves it
 * errors GP_ERROR_MEMORY, GP_ERROR_UNSUPPORTED (more than 2^31 sides)
 * owns   the caller, until gp_mesh_free */
GpResult mesh_subdivide(const GpMesh *mesh, GpMesh *finer);

#endif
