/* Meshes turned outwards: surfels are seen from in front only. */
#ifndef APPS_POINTS_ORIENT_H
#define APPS_POINTS_ORIENT_H

#include "pipeline/io/mesh/mesh.h"

/* Turns triangles, so that each part of a mesh has one outside, and shows it.
 *
 * A part is what edges connect, of whatever vertices at the same places. First its triangles are
 * made to turn one way: as most of its area does. Then
 *  - a part that is closed, or nearly, is turned so that its volume is above 0. It is nearly closed
 *    where its triangles' area vectors cancel out to 2 %, and the volume has one sign from wherever
 *    in its box it is measured;
 *  - but one inside the box of another such part is turned when that one is: it may be a cavity;
 *  - an open part that the file gives normals is turned where they, on the whole, look the other
 *  way;
 *  - other open parts, and what has no two sides (a Moebius strip), stay as they are.
 * Normals of the file that then look inwards on the whole of a part are turned with it; others are
 * made again by gp_mesh_normals where any triangle was turned.
 *
 * in/out mesh: as mesh_keep_referenced leaves it
 * out    turned: parts of which most was turned
 * errors GP_ERROR_MEMORY
 * source the sign of the volume: the divergence theorem */
GpResult mesh_orient(GpMesh *mesh, uint32_t *turned);

#endif
