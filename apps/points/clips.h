/* Clip lines: surfels on a crease end where their side of it does. */
#ifndef APPS_POINTS_CLIPS_H
#define APPS_POINTS_CLIPS_H

#include "apps/points/surfels.h"
#include "pipeline/io/mesh/mesh.h"

/* Finds the clip lines of vertices on creases, each side of which has its own vertices, and puts
 * those surfels last.
 *
 * Along a crease the side of a vertex is bounded by two edges, from the one before to the one
 * after. Its wedge is what lies inwards of both, or of either where it is wider than half a turn;
 * with one edge known, of that alone. The share's factor is the root of the whole disc's angle over
 * the wedge's: the surfel stands for its side's area alone, but no other is there to share the
 * weight on it.
 *
 * in     mesh: as mesh_split_creases left it, perhaps subdivided; degrees: as it was given
 * in/out surfels: of its vertices, in their order
 * errors GP_ERROR_MEMORY
 * source Zwicker, Raesaenen, Botsch, Dachsbacher and Pauly, "Perspective accurate splatting", GI
 *        2004: clip lines; wedges by edges of the mesh instead of by the other surfel's plane:
 *        ours */
GpResult surfels_clip(const GpMesh *mesh, double degrees, Surfels *surfels);

#endif
