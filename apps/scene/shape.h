/* Meshes and points as scenes draw them, and how procedural ones are made of grids.
 *
 * Triangles turn counter-clockwise seen from outside, as in mesh files; vertices of grids that lie
 * at one place have the same bits, so that no seam can open.
 */
#ifndef APPS_SCENE_SHAPE_H
#define APPS_SCENE_SHAPE_H

#include "pipeline/base/base.h"

/* Triangles with indices, or points without. Arrays are packed, of gp_alloc, and owned by the
 * caller until shape_free. */
typedef struct Shape {
    float *positions;  /* [3 * vertex_count] */
    float *normals;    /* [3 * vertex_count] of unit length, outwards */
    float *texcoords;  /* [2 * vertex_count] (0, 0) is the top left of a picture; NULL: all are 0 */
    float *colors;     /* [4 * vertex_count]; NULL: white */
    float *sizes;      /* [vertex_count] of points: diameters; NULL: 0 */
    uint32_t *indices; /* NULL: points */
    uint32_t vertex_count, index_count;
} Shape;

/* Allocates zeroed positions, normals, texture coordinates, and indices. errors GP_ERROR_MEMORY */
GpResult shape_alloc(Shape *shape, uint32_t vertices, uint32_t indices);

/* Makes colors, white, where there are none. errors GP_ERROR_MEMORY */
GpResult shape_need_colors(Shape *shape);

/* Frees and zeroes; a zeroed shape is fine. */
void shape_free(Shape *shape);

/* Replaces all normals by the sum of the triangles' normals at each vertex, weighted by area. */
void shape_compute_normals(Shape *shape);

/* --- grids ------------------------------------------------------------------------------------ */

typedef struct ShapePoint {
    double position[3], normal[3], texcoord[2];
} ShapePoint;

/* Sets vertex i; of a normal only the direction counts, and it is brought to unit length. */
void shape_set_vertex(Shape *shape, uint32_t i, ShapePoint *point);

/* A grid of columns x rows quads on a surface. Seen from outside, columns run to the right and rows
 * down. */
typedef struct ShapePatch ShapePatch;
struct ShapePatch {
    /* Fills position and normal (any length); texcoord already runs 0..1 over the patch. */
    void (*evaluate)(const ShapePatch *patch, uint32_t column, uint32_t row, ShapePoint *point);
    uint32_t columns, rows;
    bool columns_close, rows_close; /* the last column (row) lies on the first */
    const double *data;             /* the maker's own */
};

/* One shape of all patches. Triangles that shrink to an edge (at poles) are left out.
 * errors GP_ERROR_MEMORY */
GpResult shape_from_patches(const ShapePatch *patches, int count, Shape *shape);

#endif
