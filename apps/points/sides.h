/* Which triangles meet at an edge, wherever vertices at one place are counted as one: files and
 * patches of surfaces have several there, for normals or texture coordinates. */
#ifndef APPS_POINTS_SIDES_H
#define APPS_POINTS_SIDES_H

#include "apps/points/edges.h"

#define NO_SIDE UINT32_MAX

/* Makes one vertex of those at a place.
 * in     mesh: as mesh_keep_referenced leaves it
 * out    welded: [3 * triangle_count] the mesh's indices, but the first vertex at each place; NULL
 *        where no two are at one, so that the mesh's own are that
 * errors GP_ERROR_MEMORY
 * owns   the caller, until gp_free */
GpResult corners_weld(const GpMesh *mesh, uint32_t **welded);

/* Sides are numbered as in edges.h. */
typedef struct Sides {
    const uint32_t *corners; /* [3 * triangle_count] the first vertex at the place */
    uint32_t *mate; /* [3 * triangle_count] the other side at the edge; NO_SIDE: none or several */
    uint32_t *welded;
} Sides;

/* in     mesh: as mesh_keep_referenced leaves it; `corners` may be its own
 * errors GP_ERROR_MEMORY
 * owns   the caller, until sides_free */
GpResult sides_find(const GpMesh *mesh, Sides *sides);

void sides_free(Sides *sides); /* zeroes; a zeroed one is fine */

/* The cross product of two sides of a triangle: its normal, of twice the area's length. */
void triangle_cross(const GpMesh *mesh, size_t triangle, double cross[3]);

#endif
