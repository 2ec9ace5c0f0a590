/* The body of a PLY file of a mesh: vertices, then faces, between what means nothing here. */
#include "pipeline/io/mesh/mesh_formats.h"
#include "pipeline/io/ply/ply_items.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void read_corners(const PlyItems *items, const PlyProperty *property, GpMeshBuilder *mesh)
{
    size_t length = gp_ply_length(items, property), count = mesh->vertex_count;
    if (length < 3)
        gp_ply_fail(items, "3 or more corners");
    gp_mesh_begin_face(mesh);
    for (size_t i = 0; i < length && items->input->result == GP_OK; i++) {
        double index = gp_ply_value(items, property->type);
        if (index >= 0 && index < (double)count && index == floor(index)) {
            gp_mesh_add_corner(mesh, (uint32_t)index);
            continue;
        }
        char expected[96];
        snprintf(expected, sizeof expected, "a vertex below %zu, but it refers to vertex %.17g",
                 count, index);
        gp_ply_fail(items, expected);
    }
}

/* Triangles, where faces are nothing but corners: a length of one byte, 3, and three numbers of
 * four in the machine's order. returns how many there are before any other item */
static size_t read_triangles(const PlyItems *items, GpMeshBuilder *mesh)
{
    enum { BYTES = 1 + 3 * sizeof(uint32_t) };
    const PlyElement *faces = items->element;
    const PlyProperty *list = &items->header->property[faces->first];
    GpInput *input = items->input;
    const size_t left = faces->count - items->item;
    const size_t stored = (size_t)(input->end - input->next) / BYTES;
    const size_t most = left < stored ? left : stored;
    if (faces->end - faces->first != 1 || list->role != PLY_CORNERS ||
        gp_ply_size(list->count_type) != 1 ||
        (list->type != PLY_INT32 && list->type != PLY_UINT32) || !gp_ply_is_native(items) ||
        !gp_bytes_reserve(&mesh->indices, most * 3 * sizeof(uint32_t)))
        return 0;
    char *to = mesh->indices.data + mesh->indices.size;
    size_t count = 0;
    for (const char *at = input->next; count < most; count++, at += BYTES) {
        uint32_t corner[3];
        memcpy(corner, at + 1, sizeof corner);
        if (*at != 3 || corner[0] >= mesh->vertex_count || corner[1] >= mesh->vertex_count ||
            corner[2] >= mesh->vertex_count)
            break;
        memcpy(to + count * sizeof corner, corner, sizeof corner);
    }
    mesh->indices.size += count * 3 * sizeof(uint32_t);
    mesh->face_count += count;
    input->next += count * BYTES;
    return count;
}

/* A block of vertices; returns how many, 0 where they want reading one by one. */
static size_t read_vertices(const PlyItems *items, GpMeshBuilder *mesh)
{
    float *rows[GP_MESH_ATTRIBUTES];
    uint8_t color[PLY_BLOCK][4];
    PlyColumn column[PLY_VERTEX_ROLES] = { { NULL, 0 } };
    if (!gp_ply_is_native(items) || !gp_mesh_new_vertices(mesh, gp_ply_block(items), rows))
        return 0;
    float *const position = rows[GP_MESH_POSITION], *const normal = rows[GP_MESH_NORMAL];
    float *const texcoord = rows[GP_MESH_TEXCOORD], *const rgba = rows[GP_MESH_COLOR];
    for (int i = 0; i < 3; i++) {
        column[PLY_X + i] = (PlyColumn){ position + i, 3 };
        column[PLY_NX + i] = (PlyColumn){ normal ? normal + i : NULL, 3 };
    }
    for (int i = 0; i < 2; i++)
        column[PLY_U + i] = (PlyColumn){ texcoord ? texcoord + i : NULL, 2 };
    for (int i = 0; i < 4; i++)
        column[PLY_RED + i] = (PlyColumn){ rgba ? &color[0][i] : NULL, 4 };
    if (rgba)
        memset(color, 255, sizeof color); /* where there is no alpha */
    const size_t count = gp_ply_read_block(items, column);
    for (size_t i = 0; i < 4 * count && rgba; i++)
        rgba[i] = (float)color[i / 4][i % 4] / 255.0f;
    gp_mesh_add_vertices(mesh, count);
    return count;
}

static void read_one(const PlyItems *items, GpMeshBuilder *mesh)
{
    float vertex[PLY_VERTEX_ROLES] = { [PLY_ALPHA] = 1 };
    for (size_t i = items->element->first; i < items->element->end; i++) {
        const PlyProperty *property = &items->header->property[i];
        if (property->role == PLY_CORNERS)
            read_corners(items, property, mesh);
        else if (property->role == PLY_IGNORED || property->role == PLY_RADIUS)
            gp_ply_skip(items, property);
        else if (property->role >= PLY_RED)
            vertex[property->role] = (float)gp_ply_color(items, property->type) / 255.0f;
        else
            vertex[property->role] = gp_ply_number(items, property->type);
    }
    if (items->element->kind == PLY_VERTEX && items->input->result == GP_OK)
        gp_mesh_add_vertex(mesh, vertex);
}

static size_t read_items(const PlyItems *items, void *context)
{
    size_t count = 0;
    if (items->element->kind == PLY_VERTEX)
        count = read_vertices(items, context);
    else if (items->element->kind == PLY_FACE)
        count = read_triangles(items, context);
    if (count == 0) {
        read_one(items, context);
        count = 1;
    }
    return count;
}

void gp_mesh_read_ply(GpInput *input, GpMeshBuilder *mesh)
{
    PlyHeader header;
    if (!gp_ply_header(input, &header))
        return;
    mesh->has[GP_MESH_NORMAL] = header.has[PLY_NX];
    mesh->has[GP_MESH_TEXCOORD] = header.has[PLY_U];
    mesh->has[GP_MESH_COLOR] = header.has[PLY_RED];
    for (size_t i = 0; i < header.element_count; i++) {
        const PlyElement *element = &header.element[i];
        gp_mesh_builder_reserve(mesh, element->kind == PLY_VERTEX ? element->count : 0,
                                element->kind == PLY_FACE ? element->count : 0);
    }
    gp_ply_items(input, &header, read_items, mesh);
}
