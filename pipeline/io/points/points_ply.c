/* The vertices of a PLY file as points. */
#include "pipeline/io/ply/ply_items.h"
#include "pipeline/io/points/points_formats.h"

static void read_item(const PlyItems *items, void *context)
{
    GpPointsBuilder *points = context;
    float row[PLY_VERTEX_ROLES] = { 0 };
    uint8_t color[3] = { 0 };
    for (size_t i = items->element->first; i < items->element->end; i++) {
        const PlyProperty *property = &items->header->property[i];
        const PlyRole role = property->role;
        if (role >= PLY_RED && role <= PLY_BLUE)
            color[role - PLY_RED] = gp_ply_color(items, property->type);
        else if (role <= PLY_NZ || role == PLY_RADIUS)
            row[role] = gp_ply_number(items, property->type);
        else
            gp_ply_skip(items, property);
    }
    if (row[PLY_RADIUS] < 0)
        gp_ply_fail(items, "a radius of 0 or more");
    if (items->element->kind != PLY_VERTEX || items->input->result != GP_OK)
        return;
    gp_bytes_append(&points->positions, row + PLY_X, 3 * sizeof(float));
    if (points->has_normals)
        gp_bytes_append(&points->normals, row + PLY_NX, 3 * sizeof(float));
    if (points->has_radii)
        gp_bytes_append(&points->radii, row + PLY_RADIUS, sizeof(float));
    if (points->has_colors)
        gp_bytes_append(&points->colors, color, sizeof color);
}

/* What it takes at least in the file, so that a promise of too many is refused before memory is
 * taken for them. */
static size_t least_size(const PlyHeader *header, const PlyElement *element)
{
    size_t size = 0;
    for (size_t i = element->first; i < element->end; i++) {
        const PlyProperty *property = &header->property[i];
        size += header->encoding == PLY_ASCII ? 2 /* "0 " */
                : property->is_list           ? gp_ply_size(property->count_type)
                                              : gp_ply_size(property->type);
    }
    return size;
}

void gp_points_read_ply(GpInput *input, GpPointsBuilder *points)
{
    PlyHeader header;
    if (!gp_ply_header(input, &header))
        return;
    points->has_normals = header.has[PLY_NX];
    points->has_radii = header.has[PLY_RADIUS];
    points->has_colors = header.has[PLY_RED];
    for (size_t i = 0; i < header.element_count; i++) {
        const PlyElement *element = &header.element[i];
        const size_t left = (size_t)(input->end - input->next) + 1; /* the last may end without */
        const size_t size = least_size(&header, element), count = element->count;
        if (size * count > left) {
            gp_input_fail(input, GP_ERROR_FORMAT,
                          "%zu %s are promised, which need %zu bytes, but only %zu follow", count,
                          element->kind == PLY_VERTEX ? "points" : "elements", size * count,
                          left - 1);
            return;
        }
        if (element->kind == PLY_FACE)
            points->face_count = count;
        if (element->kind != PLY_VERTEX)
            continue;
        gp_bytes_reserve(&points->positions, count * 3 * sizeof(float));
        gp_bytes_reserve(&points->normals, points->has_normals ? count * 3 * sizeof(float) : 0);
        gp_bytes_reserve(&points->radii, points->has_radii ? count * sizeof(float) : 0);
        gp_bytes_reserve(&points->colors, points->has_colors ? count * 3 : 0);
    }
    gp_ply_items(input, &header, read_item, points);
}
