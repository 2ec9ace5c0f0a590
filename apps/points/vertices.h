/* Surfels of the vertices of a mesh. */
#ifndef APPS_POINTS_VERTICES_H
#define APPS_POINTS_VERTICES_H

#include "apps/points/surfels.h"
#include "pipeline/io/mesh/mesh.h"

/* A surfel a vertex, in their order, with its normal and colour. It stands for a third of the area
 * of the triangles at it.
 *
 * The radius is one for all: the smallest at which discs around the vertices leave no hole, which
 * is the largest triangle_reach. Or (each) a vertex has that of the triangles at it, so that a few
 * large triangles do not widen all discs.
 * in     mesh: with an area, as mesh_keep_referenced leaves it
 * errors GP_ERROR_MEMORY
 * owns   the caller, until surfels_free */
GpResult surfels_of_vertices(const GpMesh *mesh, bool each, Surfels *surfels);

/* A colour of a mesh in 256 steps. */
static inline uint8_t color_byte(float color)
{
    return (uint8_t)(color >= 1 ? 255 : color > 0 ? color * 255 + 0.5F : 0);
}

/* The area of a triangle, and of all. */
double mesh_triangle_area(const GpMesh *mesh, size_t triangle);
double mesh_area(const GpMesh *mesh);
bool mesh_has_area(const GpMesh *mesh);

#endif
