/* Procedural meshes and point sets: builtin:NAME.
 *
 * All are made with + - * / and square roots in double and rounded to float once, so they have the
 * same bits everywhere. Triangles turn counter-clockwise seen from outside, as in mesh files;
 * vertices that lie at one place have the same bits, so that no seam can open.
 */
#ifndef APPS_SCENE_SHAPES_H
#define APPS_SCENE_SHAPES_H

#include "pipeline/base/base.h"

typedef struct ShapeVertex {
    float position[3];
    float normal[3];   /* unit length, outwards */
    float texcoord[2]; /* (0, 0) is the top left of a picture */
    float color[4];
    float size; /* of points: the diameter */
} ShapeVertex;

/* Triangles with indices, or points without. Owned by the caller until shape_free. */
typedef struct Shape {
    ShapeVertex *vertices;
    uint32_t *indices; /* NULL: points */
    uint32_t vertex_count, index_count;
} Shape;

/* Makes a mesh: sphere, ball (a sphere of few triangles), cube, torus, knot, cylinder, cone (all
 * within about 1 of the origin), plane and disc (y = 0, facing +y), quad (z = 0, facing +z), teapot
 * (Newell's, standing on y = 0, 3.15 high). Colours are white, sizes 0.
 * errors GP_ERROR_INVALID (no such name), GP_ERROR_MEMORY */
GpResult shape_create(const char *name, Shape *shape);

/* Makes a point set: sphere (surfels in a Fibonacci spiral) or grid (a square on y = 0), with
 * normals. errors GP_ERROR_INVALID, GP_ERROR_MEMORY */
GpResult shape_create_points(const char *name, Shape *shape);

/* Allocates zeroed vertices (white, no normals) and indices. errors GP_ERROR_MEMORY */
GpResult shape_alloc(Shape *shape, uint32_t vertices, uint32_t indices);

/* Frees and zeroes; a zeroed shape is fine. */
void shape_free(Shape *shape);

/* Replaces all normals by the sum of the triangles' normals at each vertex, weighted by area. */
void shape_compute_normals(Shape *shape);

/* Names of the meshes, NULL at the end. */
extern const char *const shape_names[];

/* Control points of the teapot's bicubic patches, in rows. */
enum { SHAPE_TEAPOT_PATCHES = 32 };
void shape_teapot_control(float control[SHAPE_TEAPOT_PATCHES][4][4][3]);

/* --- for the files that make shapes ---------------------------------------------------------- */

typedef struct ShapePoint {
    double position[3], normal[3], texcoord[2];
} ShapePoint;

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

GpResult shape_teapot(Shape *shape);

#endif
