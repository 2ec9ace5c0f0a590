#include "apps/fragments/spheres.h"

#define RADIUS 0.48

enum { WALL = 2 }; /* spheres a side */

_Static_assert(SPHERE_COLUMNS *(SPHERE_COLUMNS - 2) == SPHERE_TRIANGLES,
               "a fan at each pole, two triangles between rows");

static uint32_t vertices_of(uint32_t columns)
{
    return columns * (columns / 2 - 1) + 2;
}

/* Rings from the top to the bottom, then both poles. */
static void place_vertices(const double centre[3], uint32_t columns, float *positions)
{
    const uint32_t rows = columns / 2;
    double across, up, x, z;
    for (uint32_t row = 1; row < rows; row++) {
        angle_sincos(180.0 * row / rows, &across, &up);
        for (uint32_t column = 0; column < columns; column++, positions += 3) {
            angle_sincos(360.0 * column / columns, &z, &x);
            positions[0] = (float)(centre[0] + RADIUS * across * x);
            positions[1] = (float)(centre[1] + RADIUS * up);
            positions[2] = (float)(centre[2] + RADIUS * across * z);
        }
    }
    for (int pole = 0; pole < 2; pole++, positions += 3)
        for (int k = 0; k < 3; k++)
            positions[k] = (float)(centre[k] + (k == 1 ? RADIUS * (1 - 2 * pole) : 0));
}

static uint32_t *add_triangle(uint32_t *index, uint32_t a, uint32_t b, uint32_t c)
{
    index[0] = a;
    index[1] = b;
    index[2] = c;
    return index + 3;
}

static uint32_t *join_vertices(uint32_t first, uint32_t columns, uint32_t *index)
{
    const uint32_t bottom = first + vertices_of(columns) - 1, top = bottom - 1;
    const uint32_t last = top - columns; /* ring */
    for (uint32_t column = 0; column < columns; column++) {
        const uint32_t next = (column + 1) % columns;
        index = add_triangle(index, top, first + next, first + column);
        for (uint32_t ring = first; ring < last; ring += columns) {
            const uint32_t below = ring + columns;
            index = add_triangle(index, ring + column, ring + next, below + next);
            index = add_triangle(index, ring + column, below + next, below + column);
        }
        index = add_triangle(index, bottom, last + column, last + next);
    }
    return index;
}

GpResult spheres_make(uint32_t layers, uint32_t columns, GpMesh *mesh)
{
    const uint32_t vertices = vertices_of(columns), triangles = columns * (columns - 2);
    const uint32_t count = layers / 2 * WALL * WALL;
    GpMesh made = { .positions = gp_alloc((size_t)count * vertices, 3 * sizeof(float)),
                    .normals = gp_alloc((size_t)count * vertices, 3 * sizeof(float)),
                    .indices = gp_alloc((size_t)count * triangles, 3 * sizeof(uint32_t)),
                    .vertex_count = count * vertices,
                    .triangle_count = count * triangles };
    if (!made.positions || !made.normals || !made.indices) {
        gp_mesh_free(&made);
        return GP_ERROR_MEMORY;
    }
    uint32_t *index = made.indices;
    for (uint32_t i = 0; i < count; i++) {
        const double centre[3] = { i % WALL - 0.5, i / WALL % WALL - 0.5,
                                   -(double)(i / (WALL * WALL)) };
        place_vertices(centre, columns, made.positions + 3 * (size_t)i * vertices);
        index = join_vertices(i * vertices, columns, index);
    }
    *mesh = made;
    return gp_mesh_normals(mesh, true);
}

Camera spheres_camera(uint32_t layers)
{
    return (Camera){
        .eye = { 0, 0, 2 }, .up = { 0, 1, 0 }, .height = 2.1, .near = 1, .far = 2.5 + layers / 2
    };
}
