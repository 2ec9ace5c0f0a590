/* Meshes and point sets of the benchmark cases. */
#include "apps/bench/data.h"

#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh_file.h"

#include <math.h>
#include <string.h>

typedef struct BenchVertex {
    float position[3], normal[3];
} BenchVertex;

static GpGeometry mesh_of(const BenchVertex *vertices, uint32_t vertex_count,
                          const uint32_t *indices, uint32_t index_count)
{
    return (GpGeometry){
        .vertex_count = vertex_count,
        .indices = indices,
        .index_count = index_count,
        .streams = { [GP_POSITION] = { vertices->position, sizeof *vertices, 3, GP_FLOAT32 },
                     [GP_NORMAL] = { vertices->normal, sizeof *vertices, 3, GP_FLOAT32 } },
    };
}

/* --- models ----------------------------------------------------------------------------------- */

/* Centres the box of all vertices and makes its longest side 2. In binary32, as the peers do. */
static void normalize(GpMesh *mesh)
{
    float low[3], high[3], longest = 0;
    memcpy(low, mesh->positions, sizeof low);
    memcpy(high, mesh->positions, sizeof high);
    for (size_t i = 0; i < (size_t)mesh->vertex_count * 3; i++) {
        float x = mesh->positions[i];
        low[i % 3] = x < low[i % 3] ? x : low[i % 3];
        high[i % 3] = x > high[i % 3] ? x : high[i % 3];
    }
    for (int axis = 0; axis < 3; axis++)
        longest = high[axis] - low[axis] > longest ? high[axis] - low[axis] : longest;
    for (size_t i = 0; i < (size_t)mesh->vertex_count * 3; i++)
        mesh->positions[i] =
            (mesh->positions[i] - 0.5f * (low[i % 3] + high[i % 3])) * (2 / longest);
}

static GpGeometry keep_mesh(Frame *frame, const GpMesh *mesh)
{
    BenchVertex *vertices = frame_alloc(frame, mesh->vertex_count, sizeof *vertices);
    if (!vertices)
        return (GpGeometry){ .vertex_count = 0 };
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        memcpy(vertices[i].position, mesh->positions + 3 * i, sizeof vertices[i].position);
        memcpy(vertices[i].normal, mesh->normals + 3 * i, sizeof vertices[i].normal);
    }
    size_t index_bytes = (size_t)mesh->triangle_count * 3 * sizeof(uint32_t);
    return mesh_of(vertices, mesh->vertex_count, frame_copy(frame, mesh->indices, index_bytes),
                   mesh->triangle_count * 3);
}

GpResult bench_model(Frame *frame, const char *name, uint32_t vertices, uint32_t triangles,
                     GpGeometry *geometry, GpError *error)
{
    char path[4096];
    GpMesh mesh = { .positions = NULL };
    GpResult result = gp_data_find(name, path, sizeof path, error);
    if (!result)
        result = gp_mesh_read(path, GP_MESH_TRIANGLES, &mesh, error);
    if (!result && (mesh.vertex_count != vertices || mesh.triangle_count != triangles))
        result =
            gp_fail(error, GP_ERROR_FORMAT, "%s: %u vertices and %u triangles, expected %u and %u",
                    path, mesh.vertex_count, mesh.triangle_count, vertices, triangles);
    if (!result) {
        normalize(&mesh);
        result = gp_mesh_normals(&mesh, true);
    }
    if (!result)
        *geometry = keep_mesh(frame, &mesh);
    gp_mesh_free(&mesh);
    return result;
}

/* --- procedural ------------------------------------------------------------------------------- */

GpGeometry bench_torus(Frame *frame, int around, int across)
{
    const double large = 0.85, small = 0.42;
    uint32_t quads = (uint32_t)(around * across);
    BenchVertex *vertices = frame_alloc(frame, quads, sizeof *vertices), *vertex = vertices;
    uint32_t *indices = frame_alloc(frame, (size_t)quads * 6, sizeof *indices), *index = indices;
    if (!vertices || !indices)
        return (GpGeometry){ .vertex_count = 0 };
    for (int u = 0; u < around; u++) {
        double sin_u, cos_u;
        angle_sincos(360.0 * u / around, &sin_u, &cos_u);
        for (int v = 0; v < across; v++, vertex++) {
            double sin_v, cos_v;
            angle_sincos(360.0 * v / across, &sin_v, &cos_v);
            double radius = large + small * cos_v;
            *vertex = (BenchVertex){
                { (float)(radius * cos_u), (float)(radius * sin_u), (float)(small * sin_v) },
                { (float)(cos_v * cos_u), (float)(cos_v * sin_u), (float)sin_v },
            };

            int next_u = (u + 1) % around, next_v = (v + 1) % across;
            uint32_t a = (uint32_t)(u * across + v), b = (uint32_t)(next_u * across + v);
            uint32_t c = (uint32_t)(next_u * across + next_v), d = (uint32_t)(u * across + next_v);
            const uint32_t turns[6] = { a, b, c, a, c, d };
            memcpy(index, turns, sizeof turns);
            index += 6;
        }
    }
    return mesh_of(vertices, quads, indices, quads * 6);
}

GpGeometry bench_plane(void)
{
    static const BenchVertex vertices[4] = { { { -4, -1, 4 }, { 0, 1, 0 } },
                                             { { 4, -1, 4 }, { 0, 1, 0 } },
                                             { { 4, -1, -4 }, { 0, 1, 0 } },
                                             { { -4, -1, -4 }, { 0, 1, 0 } } };
    static const uint32_t indices[6] = { 0, 1, 2, 0, 2, 3 };
    return mesh_of(vertices, 4, indices, 6);
}

GpGeometry bench_points(const float *positions, uint32_t count)
{
    return (GpGeometry){
        .primitive = GP_POINTS,
        .vertex_count = count,
        .streams = { [GP_POSITION] = { positions, 0, 3, GP_FLOAT32 } },
    };
}
