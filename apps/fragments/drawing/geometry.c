#include "apps/fragments/drawing/geometry.h"

#include "apps/base/vector.h"

#include <math.h>
#include <string.h>

void fragment_normal(const float *positions, const uint32_t corner[3], double normal[3])
{
    double at[3][3], edge[2][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            at[i][k] = (double)positions[3 * (size_t)corner[i] + (size_t)k];
    vector_subtract(at[1], at[0], edge[0]);
    vector_subtract(at[2], at[0], edge[1]);
    vector_cross(edge[0], edge[1], normal);
    vector_normalize(normal);
}

static void set_normal(const FragmentMesh *mesh, const uint32_t corner[3], float normal[3])
{
    double across[3];
    fragment_normal(&mesh->positions[0][0], corner, across);
    for (int k = 0; k < 3; k++)
        normal[k] = (float)across[k];
}

/* The corner that is the first: one whose vertex is no other triangle's first; 3 where there is
 * none. */
static int find_free(const bool *is_first, const uint32_t corner[3])
{
    int free = 0;
    while (free < 3 && is_first[corner[free]])
        free++;
    return free;
}

/* Vertices that are the first of several triangles are there several times. */
static void fill(const FragmentMesh *mesh, bool *is_first, FragmentGeometry *geometry)
{
    uint32_t count = mesh->vertex_count;
    memcpy(geometry->positions, mesh->positions, count * sizeof *geometry->positions);
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *corner = mesh->indices + 3 * (size_t)i;
        uint32_t *drawn = geometry->indices + 3 * (size_t)i;
        const int free = find_free(is_first, corner);
        for (int k = 0; k < 3; k++)
            drawn[k] = corner[(free + k) % 3];
        if (free < 3)
            is_first[drawn[0]] = true;
        else {
            memcpy(geometry->positions[count], mesh->positions[drawn[0]], sizeof *mesh->positions);
            drawn[0] = count++;
        }
        memcpy(geometry->colors[drawn[0]], mesh->colors[i], sizeof *mesh->colors);
        if (geometry->normals)
            set_normal(mesh, corner, geometry->normals[drawn[0]]);
        memcpy(geometry->reversed + 3 * (size_t)(mesh->triangle_count - 1 - i), drawn,
               3 * sizeof *drawn);
    }
    geometry->drawn.vertex_count = count;
}

static GpStream stream_of(const void *data, uint8_t components)
{
    return (GpStream){ .data = data, .components = components };
}

GpResult fragment_geometry_make(const FragmentMesh *mesh, bool has_normals,
                                FragmentGeometry *geometry, GpError *error)
{
    const size_t room = (size_t)mesh->vertex_count + mesh->triangle_count;
    FragmentGeometry made = { .positions = gp_alloc(room, sizeof *made.positions),
                              .colors = gp_alloc(room, sizeof *made.colors),
                              .normals = has_normals ? gp_alloc(room, sizeof *made.normals) : NULL,
                              .indices = gp_alloc(mesh->triangle_count, 3 * sizeof(uint32_t)),
                              .reversed = gp_alloc(mesh->triangle_count, 3 * sizeof(uint32_t)) };
    bool *is_first = gp_alloc(mesh->vertex_count, sizeof *is_first);
    if (!made.positions || !made.colors || (has_normals && !made.normals) || !made.indices ||
        !made.reversed || !is_first) {
        fragment_geometry_free(&made);
        gp_free(is_first);
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for %u triangles", mesh->triangle_count);
    }
    fill(mesh, is_first, &made);
    gp_free(is_first);
    made.drawn.indices = made.indices;
    made.drawn.index_count = 3 * mesh->triangle_count;
    made.drawn.streams[GP_POSITION] = stream_of(made.positions, 3);
    made.drawn.streams[GP_COLOR] = stream_of(made.colors, 4);
    if (has_normals)
        made.drawn.streams[GP_NORMAL] = stream_of(made.normals, 3);
    made.backwards = made.drawn;
    made.backwards.indices = made.reversed;
    *geometry = made;
    return GP_OK;
}

void fragment_geometry_free(FragmentGeometry *geometry)
{
    gp_free(geometry->positions);
    gp_free(geometry->colors);
    gp_free(geometry->normals);
    gp_free(geometry->indices);
    gp_free(geometry->reversed);
    *geometry = (FragmentGeometry){ .indices = NULL };
}
