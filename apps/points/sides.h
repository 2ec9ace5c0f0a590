/* Which triangles meet at an edge, wherever vertices at one place are counted as one: files and patches
 * of surfaces have several there, for normals or texture coordinates. */
#ifndef APPS_POINTS_SIDES_H
#define APPS_POINTS_SIDES_H

#include "apps/points/edges.h"

#define NO_SIDE UINT32_MAX

/* Sides are numbered by triangle: 3 t + i goes from corner i to corner i + 1. */
typedef struct Sides {
    uint32_t
        *corners;   /* [3 * triangle_count] of the mesh's indices: the first vertex at the place */
    uint32_t *mate; /* [3 * triangle_count] the other side at the edge; NO_SIDE: none or several */
    Edges edges;    /* of `corners` */
} Sides;

/* in     mesh: as mesh_of_referenced makes it
 * errors GP_ERROR_MEMORY
 * owns   the caller, until sides_free */
GpResult sides_find(const GpMesh *mesh, Sides *sides);

void sides_free(Sides *sides); /* zeroes; a zeroed one is fine */

/* The corner at which a side ends; it begins at the corner of its own number. */
static inline size_t side_end(size_t side)
{
    return side - side % 3 + (side % 3 + 1) % 3;
}

/* The cross product of two sides of a triangle: its normal, of twice the area's length. */
void triangle_cross(const GpMesh *mesh, size_t triangle, double cross[3]);

#endif
