#include "pipeline/io/mesh/mesh_builder.h"

static const struct {
    size_t first, size; /* floats in the row of a vertex */
} columns[GP_MESH_ATTRIBUTES] = {
    [GP_MESH_POSITION] = { .first = GP_VERTEX_POSITION, .size = 3 },
    [GP_MESH_NORMAL] = { .first = GP_VERTEX_NORMAL, .size = 3 },
    [GP_MESH_TEXCOORD] = { .first = GP_VERTEX_TEXCOORD, .size = 2 },
    [GP_MESH_COLOR] = { .first = GP_VERTEX_COLOR, .size = 4 },
};

static size_t row_bytes(const GpMeshBuilder *mesh, int attribute)
{
    const bool has = attribute == GP_MESH_POSITION || mesh->has[attribute];
    return has ? columns[attribute].size * sizeof(float) : 0;
}

bool gp_mesh_new_vertices(GpMeshBuilder *mesh, size_t count, float *rows[GP_MESH_ATTRIBUTES])
{
    bool has_room = true;
    for (int i = 0; i < GP_MESH_ATTRIBUTES; i++) {
        GpBytes *values = &mesh->values[i];
        const size_t bytes = count * row_bytes(mesh, i);
        has_room &= gp_bytes_reserve(values, bytes);
        rows[i] = has_room && bytes ? (float *)(void *)(values->data + values->size) : NULL;
    }
    return has_room;
}

void gp_mesh_add_vertices(GpMeshBuilder *mesh, size_t count)
{
    for (int i = 0; i < GP_MESH_ATTRIBUTES; i++)
        mesh->values[i].size += count * row_bytes(mesh, i);
    mesh->vertex_count += count;
}

void gp_mesh_builder_reserve(GpMeshBuilder *mesh, size_t vertices, size_t triangles)
{
    float *rows[GP_MESH_ATTRIBUTES];
    gp_mesh_new_vertices(mesh, vertices, rows);
    gp_bytes_reserve(&mesh->indices, triangles * 3 * sizeof(uint32_t));
}

void gp_mesh_add_vertex(GpMeshBuilder *mesh, const float vertex[GP_VERTEX_FLOATS])
{
    for (int i = 0; i < GP_MESH_ATTRIBUTES; i++) {
        const size_t bytes = row_bytes(mesh, i);
        if (bytes > 0)
            gp_bytes_append(&mesh->values[i], vertex + columns[i].first, bytes);
    }
    mesh->vertex_count++;
}

GpResult gp_mesh_builder_finish(GpMeshBuilder *builder, GpMesh *mesh)
{
    /* Every mesh has normals, and indices be there none. */
    size_t zeros = builder->has[GP_MESH_NORMAL] ? 0 : 3 * builder->vertex_count * sizeof(float);
    gp_bytes_append_zeros(&builder->values[GP_MESH_NORMAL], zeros);
    gp_bytes_reserve(&builder->indices, 1);
    bool failed = builder->indices.failed;
    for (int i = 0; i < GP_MESH_ATTRIBUTES; i++)
        failed |= builder->values[i].failed;
    if (failed) {
        gp_mesh_builder_free(builder);
        return GP_ERROR_MEMORY;
    }
    *mesh = (GpMesh){ .positions = (float *)builder->values[GP_MESH_POSITION].data,
                      .normals = (float *)builder->values[GP_MESH_NORMAL].data,
                      .colors = (float *)builder->values[GP_MESH_COLOR].data,
                      .texcoords = (float *)builder->values[GP_MESH_TEXCOORD].data,
                      .indices = (uint32_t *)builder->indices.data,
                      .vertex_count = (uint32_t)builder->vertex_count,
                      .triangle_count = (uint32_t)(builder->indices.size / (3 * sizeof(uint32_t))),
                      .skipped_count = (uint32_t)builder->skipped_count,
                      .had_normals = builder->has[GP_MESH_NORMAL],
                      .had_colors = builder->has[GP_MESH_COLOR],
                      .had_texcoords = builder->has[GP_MESH_TEXCOORD] };
    *builder = (GpMeshBuilder){ .vertex_count = 0 };
    return GP_OK;
}

void gp_mesh_builder_free(GpMeshBuilder *mesh)
{
    for (int i = 0; i < GP_MESH_ATTRIBUTES; i++)
        gp_free(mesh->values[i].data);
    gp_free(mesh->indices.data);
    *mesh = (GpMeshBuilder){ .vertex_count = 0 };
}
