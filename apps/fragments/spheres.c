#include "apps/fragments/spheres.h"

enum {
    COLUMNS = 200,
    ROWS = 100,
    VERTICES = COLUMNS * (ROWS - 1) + 2,
    WALL = 2, /* spheres a side */
};

_Static_assert(2 * COLUMNS * (ROWS - 1) == SPHERE_TRIANGLES, "a fan at each pole, quads between");

#define RADIUS 0.48

/* Rings from the top to the bottom, then both poles. */
static void place_vertices(const double centre[3], float *positions)
{
    double across, up, x, z;
    for (int row = 1; row < ROWS; row++) {
        angle_sincos(180.0 * row / ROWS, &across, &up);
        for (int column = 0; column < COLUMNS; column++, positions += 3) {
            angle_sincos(360.0 * column / COLUMNS, &z, &x);
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

static uint32_t *join_vertices(uint32_t first, uint32_t *index)
{
    const uint32_t top = first + VERTICES - 2, bottom = first + VERTICES - 1;
    for (uint32_t column = 0; column < COLUMNS; column++) {
        const uint32_t next = (column + 1) % COLUMNS, last = first + COLUMNS * (ROWS - 2);
        index = add_triangle(index, top, first + next, first + column);
        for (uint32_t ring = first; ring < last; ring += COLUMNS) {
            const uint32_t below = ring + COLUMNS;
            index = add_triangle(index, ring + column, ring + next, below + next);
            index = add_triangle(index, ring + column, below + next, below + column);
        }
        index = add_triangle(index, bottom, last + column, last + next);
    }
    return index;
}

GpResult spheres_make(uint32_t layers, GpMesh *mesh)
{
    const uint32_t count = layers / 2 * WALL * WALL;
    GpMesh made = { .positions = gp_alloc((size_t)count * VERTICES, 3 * sizeof(float)),
                    .normals = gp_alloc((size_t)count * VERTICES, 3 * sizeof(float)),
                    .indices = gp_alloc((size_t)count * SPHERE_TRIANGLES, 3 * sizeof(uint32_t)),
                    .vertex_count = count * VERTICES,
                    .triangle_count = count * SPHERE_TRIANGLES };
    if (!made.positions || !made.normals || !made.indices) {
        gp_mesh_free(&made);
        return GP_ERROR_MEMORY;
    }
    uint32_t *index = made.indices;
    for (uint32_t i = 0; i < count; i++) {
        const double centre[3] = { i % WALL - 0.5, i / WALL % WALL - 0.5,
                                   -(double)(i / (WALL * WALL)) };
        place_vertices(centre, made.positions + 3 * (size_t)i * VERTICES);
        index = join_vertices(i * VERTICES, index);
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
