/* Meshes made ready for points: without what no triangle uses, and finer. */
#ifndef APPS_POINTS_SUBDIVIDE_H
#define APPS_POINTS_SUBDIVIDE_H

#include "pipeline/io/mesh/mesh.h"

/* Copies a mesh without the triangles that do not have three different corners and without vertices
 * that no triangle then uses; what is left keeps its order. Normals and colours are copied; normals that
 * the file did not store are made again by gp_mesh_normals. Texture coordinates are left out.
 * errors GP_ERROR_MEMORY
 * owns   the caller, until gp_mesh_free */
GpResult mesh_of_referenced(const GpMesh *mesh, GpMesh *referenced);

/* Cuts each triangle into four at the midpoints of its sides. Vertices keep their numbers; the midpoint
 * of an edge is one vertex for all triangles at that edge and follows them in the order of edges_find.
 * Positions and colours of midpoints are means, and normals that the file stored are, at unit length,
 * where both ends' are within CREASE_DEGREES of the triangles at the edge. Others are made again by gp_mesh_normals: a midpoint has that of the two triangles at it, so that its
 * disc lies as close to both as one disc can; the mean of its ends' would lean with triangles farther
 * away.
 * in     mesh: as mesh_of_referenced makes it
 * errors GP_ERROR_MEMORY, GP_ERROR_UNSUPPORTED (more than 2^31 sides)
 * owns   the caller, until gp_mesh_free */
GpResult mesh_subdivide(const GpMesh *mesh, GpMesh *finer);

#endif
