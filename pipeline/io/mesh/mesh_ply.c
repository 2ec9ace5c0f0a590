/* The body of a PLY file of a mesh: vertices, then faces, between what means nothing here. */
#include "pipeline/io/mesh/mesh_formats.h"
#include "pipeline/io/ply/ply_items.h"

#include <math.h>
#include <stdio.h>

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

static void read_item(const PlyItems *items, void *context)
{
    GpMeshBuilder *mesh = context;
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
    gp_ply_items(input, &header, read_item, mesh);
}
