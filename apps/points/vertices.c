#include "apps/points/vertices.h"

#include "apps/base/vector.h"
#include "apps/points/triangle.h"

#include <string.h>

typedef struct Vertex {
    double area, reach;
} Vertex;

static const float *corner_position(const GpMesh *mesh, size_t triangle, int corner)
{
    return mesh->positions + 3 * (size_t)mesh->indices[3 * triangle + (size_t)corner];
}

double mesh_triangle_area(const GpMesh *mesh, size_t triangle)
{
    return triangle_area(corner_position(mesh, triangle, 0), corner_position(mesh, triangle, 1),
                         corner_position(mesh, triangle, 2));
}

double mesh_area(const GpMesh *mesh)
{
    double area = 0;
    for (size_t t = 0; t < mesh->triangle_count; t++)
        area += mesh_triangle_area(mesh, t);
    return area;
}

bool mesh_has_area(const GpMesh *mesh)
{
    for (size_t t = 0; t < mesh->triangle_count; t++)
        if (mesh_triangle_area(mesh, t) > 0)
            return true;
    return false;
}

/* Gives each triangle's area and reach to its corners; returns the largest reach. */
static double measure(const GpMesh *mesh, Vertex *vertices)
{
    double largest = 0;
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        double side[3];
        for (int i = 0; i < 3; i++)
            side[i] =
                triangle_side(corner_position(mesh, t, i), corner_position(mesh, t, (i + 1) % 3));
        const double area = mesh_triangle_area(mesh, t),
                     reach = triangle_reach(side[0], side[1], side[2]);
        largest = reach > largest ? reach : largest;
        for (size_t i = 0; i < 3; i++) {
            Vertex *vertex = &vertices[mesh->indices[3 * t + i]];
            vertex->area += area / 3;
            vertex->reach = reach > vertex->reach ? reach : vertex->reach;
        }
    }
    return largest;
}

/* Rounded up, so that a hole does not open for half a unit in the last place. */
static float up(double radius)
{
    const float rounded = (float)radius;
    return (double)rounded < radius ? nextafterf(rounded, INFINITY) : rounded;
}

GpResult surfels_of_vertices(const GpMesh *mesh, bool each, Surfels *surfels)
{
    Vertex *vertices = gp_alloc(mesh->vertex_count, sizeof *vertices);
    Surfels made;
    if (!vertices || surfels_alloc(&made, mesh->vertex_count) != GP_OK) {
        gp_free(vertices);
        return GP_ERROR_MEMORY;
    }
    const double largest = measure(mesh, vertices);
    GP_ASSERT(largest > 0);
    for (size_t v = 0; v < made.count; v++) {
        Surfel *surfel = &made.surfels[v];
        memcpy(surfel->position, mesh->positions + 3 * v, sizeof surfel->position);
        double normal[3];
        for (int i = 0; i < 3; i++)
            normal[i] = (double)mesh->normals[3 * v + (size_t)i];
        vector_normalize(normal);
        for (int i = 0; i < 3; i++)
            surfel->normal[i] = (float)normal[i];
        surfel->radius = up(each && vertices[v].reach > 0 ? vertices[v].reach : largest);
        surfel->share = surfel_share(vertices[v].area, (double)surfel->radius);
        for (size_t i = 0; i < 3; i++)
            surfel->color[i] = mesh->colors ? color_byte(mesh->colors[4 * v + i]) : 255;
    }
    made.had_normals = mesh->had_normals;
    made.had_colors = mesh->colors != NULL;
    gp_free(vertices);
    *surfels = made;
    return GP_OK;
}
