/* Points spread evenly over a mesh. */
#ifndef APPS_POINTS_SAMPLE_H
#define APPS_POINTS_SAMPLE_H

#include "pipeline/io/mesh/mesh.h"
#include "pipeline/io/points/points.h"

/* Spreads points over the triangles so that none is much nearer to another than they are on
 * average.
 *
 * Three times as many candidates are laid out, by area along the triangles and by a sequence that
 * fills each triangle evenly. Passes over them, each of sweeps over the whole surface, take those
 * that keep a distance from all that were taken. It begins at 0.9 of that of the densest lattice
 * and shrinks from pass to pass until there are enough. Points whose triangles look opposite ways
 * do not keep others away, so that both sides of a thin sheet have theirs.
 *
 * in     mesh: with an area; count: 1 to 2^30
 * out    points: so many, or less where floats do not tell so many places apart; with normals, and
 *        colours where the mesh has them, between those of the corners
 * order  always the same points
 * errors GP_ERROR_MEMORY, GP_ERROR_INVALID (a count out of range, a mesh without area)
 * owns   the caller, until gp_points_free
 * source dart throwing by shrinking distances: McCool and Fiume, "Hierarchical Poisson disk
 *        sampling distributions", 1992; the sequence: Roberts, 2018 */
GpResult mesh_sample(const GpMesh *mesh, uint32_t count, GpPoints *points);

#endif
