#include "apps/points/subdivide.h"

#include "apps/base/camera.h"
#include "apps/base/vector.h"
#include "apps/points/creases.h"
#include "apps/points/sides.h"

#include <string.h>

/* With the attributes of another. */
static GpResult alloc_mesh(uint32_t vertices, uint32_t triangles, const GpMesh *like, GpMesh *mesh)
{
    const bool has_colors = like->colors != NULL;
    *mesh = (GpMesh){ .positions = gp_alloc_unset(3 * (size_t)vertices * sizeof(float)),
                      .normals = gp_alloc(3 * (size_t)vertices, sizeof(float)),
                      .colors =
                          has_colors ? gp_alloc_unset(4 * (size_t)vertices * sizeof(float)) : NULL,
                      .indices = gp_alloc_unset(3 * (size_t)triangles * sizeof(uint32_t)),
                      .vertex_count = vertices,
                      .triangle_count = triangles,
                      .had_normals = like->had_normals,
                      .had_colors = has_colors };
    if (mesh->positions && mesh->normals && (!has_colors || mesh->colors) && mesh->indices)
        return GP_OK;
    gp_mesh_free(mesh);
    return GP_ERROR_MEMORY;
}

static bool is_triangle(const uint32_t corner[3])
{
    return corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0];
}

/* Numbers the vertices that triangles use from 1 on, in their order; 0: not used. */
static uint32_t number_referenced(const GpMesh *mesh, uint32_t *number, uint32_t *triangles)
{
    uint32_t count = 0;
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const uint32_t *corner = mesh->indices + 3 * t;
        if (!is_triangle(corner))
            continue;
        ++*triangles;
        for (int i = 0; i < 3; i++)
            number[corner[i]] = 1;
    }
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        if (number[v])
            number[v] = ++count;
    }
    return count;
}

/* Vertices move down only. number: from number_referenced */
static void move_vertices(GpMesh *mesh, const uint32_t *number)
{
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        if (number[v] == 0)
            continue;
        const size_t to = number[v] - 1;
        memmove(mesh->positions + 3 * to, mesh->positions + 3 * v, 3 * sizeof(float));
        memmove(mesh->normals + 3 * to, mesh->normals + 3 * v, 3 * sizeof(float));
        if (mesh->colors)
            memmove(mesh->colors + 4 * to, mesh->colors + 4 * v, 4 * sizeof(float));
    }
}

static void move_triangles(GpMesh *mesh, const uint32_t *number)
{
    uint32_t *index = mesh->indices;
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        uint32_t corner[3];
        memcpy(corner, mesh->indices + 3 * t, sizeof corner); /* may be where it goes */
        for (int i = 0; is_triangle(corner) && i < 3; i++)
            *index++ = number[corner[i]] - 1;
    }
}

GpResult mesh_keep_referenced(GpMesh *mesh)
{
    uint32_t triangles = 0;
    uint32_t *number = gp_alloc(mesh->vertex_count, sizeof *number);
    if (!number)
        return GP_ERROR_MEMORY;
    const uint32_t count = number_referenced(mesh, number, &triangles);
    if (count < mesh->vertex_count || triangles < mesh->triangle_count) {
        move_triangles(mesh, number);
        move_vertices(mesh, number);
    }
    gp_free(number);
    gp_free(mesh->texcoords);
    mesh->texcoords = NULL;
    mesh->had_texcoords = false;
    mesh->vertex_count = count;
    mesh->triangle_count = triangles;
    return gp_mesh_normals(mesh, !mesh->had_normals);
}

GpResult mesh_copy(const GpMesh *mesh, GpMesh *copy)
{
    const size_t vertices = mesh->vertex_count, triangles = mesh->triangle_count;
    GpMesh made;
    if (alloc_mesh(mesh->vertex_count, mesh->triangle_count, mesh, &made) != GP_OK)
        return GP_ERROR_MEMORY;
    memcpy(made.positions, mesh->positions, 3 * vertices * sizeof(float));
    memcpy(made.normals, mesh->normals, 3 * vertices * sizeof(float));
    if (made.colors)
        memcpy(made.colors, mesh->colors, 4 * vertices * sizeof(float));
    memcpy(made.indices, mesh->indices, 3 * triangles * sizeof(uint32_t));
    *copy = made;
    return GP_OK;
}

static float middle(float a, float b)
{
    return (float)(((double)a + (double)b) / 2);
}

/* Of two normals; (0, 0, 0) where they are opposite. */
static void middle_normal(const float a[3], const float b[3], float to[3])
{
    double sum[3];
    for (int i = 0; i < 3; i++)
        sum[i] = (double)a[i] + (double)b[i];
    vector_normalize(sum);
    for (int i = 0; i < 3; i++)
        to[i] = (float)sum[i];
}

static void add_midpoints(const GpMesh *mesh, const Edges *edges, GpMesh *finer)
{
    const size_t count = mesh->vertex_count;
    memcpy(finer->positions, mesh->positions, 3 * count * sizeof(float));
    memcpy(finer->normals, mesh->normals, 3 * count * sizeof(float));
    if (mesh->colors)
        memcpy(finer->colors, mesh->colors, 4 * count * sizeof(float));
    for (size_t e = 0; e < edges->count; e++) {
        const size_t a = edges->ends[2 * e], b = edges->ends[2 * e + 1], to = count + e;
        for (size_t i = 0; i < 3; i++)
            finer->positions[3 * to + i] =
                middle(mesh->positions[3 * a + i], mesh->positions[3 * b + i]);
        middle_normal(mesh->normals + 3 * a, mesh->normals + 3 * b, finer->normals + 3 * to);
        for (size_t i = 0; mesh->colors && i < 4; i++)
            finer->colors[4 * to + i] = middle(mesh->colors[4 * a + i], mesh->colors[4 * b + i]);
    }
}

/* Takes the normals of midpoints away where an end's strays from a triangle at the edge. */
static void drop_strays(const GpMesh *mesh, const Edges *edges, GpMesh *finer)
{
    double sine, cosine, cross[3];
    angle_sincos(CREASE_DEGREES, &sine, &cosine);
    for (size_t s = 0; s < 3 * (size_t)mesh->triangle_count; s++) {
        const size_t corners[2] = { s, side_end(s) };
        triangle_cross(mesh, s / 3, cross);
        const double least = cosine * sqrt(vector_dot(cross, cross));
        for (int i = 0; i < 2; i++) {
            const float *end = mesh->normals + 3 * (size_t)mesh->indices[corners[i]];
            const double normal[3] = { (double)end[0], (double)end[1], (double)end[2] };
            if (vector_dot(normal, cross) < least)
                memset(finer->normals + 3 * ((size_t)mesh->vertex_count + edges->of_side[s]), 0,
                       3 * sizeof(float));
        }
    }
}

/* The triangles at the corners, in the order of the corners, then the middle one. */
static void cut_triangles(const GpMesh *mesh, const Edges *edges, GpMesh *finer)
{
    uint32_t *to = finer->indices;
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const uint32_t *corner = mesh->indices + 3 * t, *edge = edges->of_side + 3 * t;
        uint32_t middles[3];
        for (int i = 0; i < 3; i++)
            middles[i] = mesh->vertex_count + edge[i];
        for (int i = 0; i < 3; i++) {
            *to++ = corner[i];
            *to++ = middles[i];
            *to++ = middles[(i + 2) % 3];
        }
        for (int i = 0; i < 3; i++)
            *to++ = middles[i];
    }
}

GpResult mesh_subdivide(const GpMesh *mesh, GpMesh *finer)
{
    if (mesh->triangle_count > INT32_MAX / 12)
        return GP_ERROR_UNSUPPORTED;
    Edges edges;
    GpResult result = edges_find(mesh, &edges);
    if (result != GP_OK)
        return result;
    GpMesh made;
    result = alloc_mesh(mesh->vertex_count + edges.count, 4 * mesh->triangle_count, mesh, &made);
    if (result == GP_OK) {
        add_midpoints(mesh, &edges, &made);
        if (mesh->had_normals)
            drop_strays(mesh, &edges, &made);
        cut_triangles(mesh, &edges, &made);
    }
    edges_free(&edges);
    if (result == GP_OK && (result = gp_mesh_normals(&made, !made.had_normals)) != GP_OK)
        gp_mesh_free(&made);
    if (result == GP_OK)
        *finer = made;
    return result;
}
