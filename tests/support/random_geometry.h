/* Random geometry: soups of triangles of any size, dense meshes of small ones, layers of
 * full-screen quads, clouds of points. */
#ifndef TESTS_RANDOM_GEOMETRY_H
#define TESTS_RANDOM_GEOMETRY_H

#include "pipeline/resources/geometry.h"
#include "tests/support/random.h"

/* Positions in clip space, a colour, and a texture coordinate for each vertex. `vertices` and
 * `indices` are the caller's to free (gp_free); indices may be NULL.
 * returns false when memory is short */
bool random_geometry(Random *r, bool points, GpGeometry *geometry, float **vertices,
                     uint32_t **indices);

/* True in so many cases of a hundred. */
bool random_chance(Random *r, int percent);

#endif
