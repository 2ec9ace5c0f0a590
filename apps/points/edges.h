/* The edges of a triangle mesh, each once. */
#ifndef APPS_POINTS_EDGES_H
#define APPS_POINTS_EDGES_H

#include "pipeline/io/mesh/mesh.h"

/* Sides are numbered by triangle: 3 t + i goes from corner i to corner i + 1. A side begins at the
 * corner of its own number, and ends at this. */
static inline size_t side_end(size_t side)
{
    return side % 3 < 2 ? side + 1 : side - 2;
}

/* Of an edge, its lower vertex and its higher, and its sides in their order. */
typedef void (*EdgeFn)(void *context, const uint32_t ends[2], const uint32_t *sides, size_t count);

/* Visits the edges, by their lower vertex, then by their higher.
 * in     mesh: its counts matter; corners: [3 * triangle_count] its indices, or as corners_weld
 *        makes them
 * errors GP_ERROR_MEMORY: none was visited */
GpResult edges_visit(const GpMesh *mesh, const uint32_t *corners, EdgeFn visit, void *context);

/* Numbered in that order. */
typedef struct Edges {
    /* [3 * triangle_count] the edge from corner i to corner i + 1 of a triangle */
    uint32_t *of_side;
    uint32_t *ends; /* [2 * count] lower vertex, higher vertex */
    uint32_t count;
} Edges;

/* Finds them.
 * in     mesh: its triangles have three different corners each
 * errors GP_ERROR_MEMORY
 * owns   the caller, until edges_free */
GpResult edges_find(const GpMesh *mesh, Edges *edges);

/* Frees and zeroes; a zeroed one is fine. */
void edges_free(Edges *edges);

#endif
