/* The edges of a triangle mesh, each once. */
#ifndef APPS_POINTS_EDGES_H
#define APPS_POINTS_EDGES_H

#include "pipeline/io/mesh/mesh.h"

/* Edges are numbered by their lower vertex, then by their higher. */
typedef struct Edges {
    uint32_t
        *of_side;   /* [3 * triangle_count] the edge from corner i to corner i + 1 of a triangle */
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
