/* A mesh that grows while its file is read (internal). */
#ifndef GP_IO_MESH_BUILDER_H
#define GP_IO_MESH_BUILDER_H

#include "pipeline/io/bytes.h"
#include "pipeline/io/mesh/mesh.h"

typedef enum GpMeshAttribute {
    GP_MESH_POSITION,
    GP_MESH_NORMAL,
    GP_MESH_TEXCOORD,
    GP_MESH_COLOR,
    GP_MESH_ATTRIBUTES
} GpMeshAttribute;

/* A vertex is a row of floats: x y z, nx ny nz, u v, r g b a. */
enum {
    GP_VERTEX_POSITION = 0,
    GP_VERTEX_NORMAL = 3,
    GP_VERTEX_TEXCOORD = 6,
    GP_VERTEX_COLOR = 8,
    GP_VERTEX_FLOATS = 12,
};

/* Starts with all zero. */
typedef struct GpMeshBuilder {
    bool has[GP_MESH_ATTRIBUTES];       /* beside positions; set before the first vertex */
    GpBytes values[GP_MESH_ATTRIBUTES]; /* floats of all vertices */
    GpBytes indices;                    /* of triangles */
    size_t vertex_count;
    size_t face_count;    /* of the file, with the skipped ones */
    size_t skipped_count; /* see GpMesh */

    /* The present face: how many corners came, the first and the latest of them. */
    size_t corner_count;
    uint32_t corner[2];
} GpMeshBuilder;

/* Makes room for so many, which is only a matter of speed. */
void gp_mesh_builder_reserve(GpMeshBuilder *mesh, size_t vertices, size_t triangles);

/* Appends a vertex: of the row, what mesh->has. */
void gp_mesh_add_vertex(GpMeshBuilder *mesh, const float vertex[GP_VERTEX_FLOATS]);

/* Room for so many more vertices behind the last.
 * out    rows: where the floats of each attribute that mesh->has go, the next vertex's first; of
 *        others NULL
 * returns false where memory is short */
bool gp_mesh_new_vertices(GpMeshBuilder *mesh, size_t count, float *rows[GP_MESH_ATTRIBUTES]);

/* Appends vertices that were put there. */
void gp_mesh_add_vertices(GpMeshBuilder *mesh, size_t count);

static inline void gp_mesh_begin_face(GpMeshBuilder *mesh)
{
    mesh->face_count++;
    mesh->corner_count = 0;
}

/* From the third corner on, each adds a triangle of the fan around the first. */
static inline void gp_mesh_add_corner(GpMeshBuilder *mesh, uint32_t vertex)
{
    if (mesh->corner_count >= 2) {
        const uint32_t triangle[3] = { mesh->corner[0], mesh->corner[1], vertex };
        gp_bytes_append(&mesh->indices, triangle, sizeof triangle);
    }
    mesh->corner[mesh->corner_count > 0] = vertex;
    mesh->corner_count++;
}

/* Hands over the arrays and empties the builder, also on failure.
 * out    mesh: as gp_mesh_read, but normals that the file lacks are (0, 0, 0); untouched on failure
 * errors GP_ERROR_MEMORY, also where memory was short before
 * owns   the caller frees the mesh with gp_mesh_free */
GpResult gp_mesh_builder_finish(GpMeshBuilder *builder, GpMesh *mesh);

void gp_mesh_builder_free(GpMeshBuilder *mesh);

#endif
