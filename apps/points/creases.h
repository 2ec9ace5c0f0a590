/* Meshes cut along their creases: one normal cannot tell of two faces. */
#ifndef APPS_POINTS_CREASES_H
#define APPS_POINTS_CREASES_H

#include "pipeline/io/mesh/mesh.h"

#define CREASE_DEGREES 40 /* where no other angle is asked for: rounded surfaces bend by less */

/* Gives a vertex on a crease a copy for each side, with the normal of that side's triangles,
 * weighted by area; copies follow all other vertices. A crease is an edge of two triangles, found
 * by places as in sides.h, whose normals are more than so many degrees apart; a side is what is
 * connected around the vertex without crossing one. Sides as near to each other as that are one; so
 * is, with its normal, a vertex whose normal of the file is as near to all of its sides: it is
 * meant to look round.
 *
 * in/out mesh: as mesh_orient leaves it; its triangles keep their places
 * errors GP_ERROR_MEMORY, GP_ERROR_UNSUPPORTED: more than 2^30 corners; the mesh is as before
 *      then */
GpResult mesh_split_creases(GpMesh *mesh, double degrees);

#endif
