/* The vertices of a PLY file as points. */
#include "pipeline/io/ply/ply_items.h"
#include "pipeline/io/points/points_formats.h"

/* The builder's arrays, as far as the points have them, and bytes of a point in each. */
typedef enum Attribute { POSITION, NORMAL, RADIUS, COLOR, ATTRIBUTES } Attribute;
static const size_t row_bytes[ATTRIBUTES] = {
    [POSITION] = 3 * sizeof(float),
    [NORMAL] = 3 * sizeof(float),
    [RADIUS] = sizeof(float),
    [COLOR] = 3,
};

static void arrays_of(GpPointsBuilder *points, GpBytes *array[ATTRIBUTES])
{
    array[POSITION] = &points->positions;
    array[NORMAL] = points->has_normals ? &points->normals : NULL;
    array[RADIUS] = points->has_radii ? &points->radii : NULL;
    array[COLOR] = points->has_colors ? &points->colors : NULL;
}

/* Room behind the last of them for so many more points.
 * out    rows: where it is, of each array; NULL: there is no such array
 * returns false where memory is short */
static bool new_rows(GpBytes *const array[ATTRIBUTES], size_t count, void *rows[ATTRIBUTES])
{
    bool has_room = true;
    for (int i = 0; i < ATTRIBUTES; i++) {
        has_room &= !array[i] || gp_bytes_reserve(array[i], count * row_bytes[i]);
        rows[i] = array[i] && has_room && count ? array[i]->data + array[i]->size : NULL;
    }
    return has_room;
}

static void add_rows(GpBytes *const array[ATTRIBUTES], size_t count)
{
    for (int i = 0; i < ATTRIBUTES; i++)
        if (array[i])
            array[i]->size += count * row_bytes[i];
}

/* A block of points; returns how many, 0 where they want reading one by one. */
static size_t read_block(const PlyItems *items, GpPointsBuilder *points)
{
    GpBytes *array[ATTRIBUTES];
    void *rows[ATTRIBUTES];
    PlyColumn column[PLY_VERTEX_ROLES] = { { NULL, 0 } };
    char *const first = items->input->next;
    arrays_of(points, array);
    if (!new_rows(array, gp_ply_block(items), rows))
        return 0;
    float *const position = rows[POSITION], *const normal = rows[NORMAL];
    const float *const radius = rows[RADIUS];
    uint8_t *const color = rows[COLOR];
    column[PLY_RADIUS] = (PlyColumn){ rows[RADIUS], 1 };
    for (int i = 0; i < 3; i++) {
        column[PLY_X + i] = (PlyColumn){ position + i, 3 };
        column[PLY_NX + i] = (PlyColumn){ normal ? normal + i : NULL, 3 };
        column[PLY_RED + i] = (PlyColumn){ color ? color + i : NULL, 3 };
    }
    const size_t count = gp_ply_read_block(items, column);
    bool valid = true;
    for (size_t i = 0; i < count && radius; i++)
        valid &= radius[i] >= 0;
    if (!valid) {
        items->input->next = first;
        return 0;
    }
    add_rows(array, count);
    return count;
}

static void read_one(const PlyItems *items, GpPointsBuilder *points)
{
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
    const void *const values[ATTRIBUTES] = { row + PLY_X, row + PLY_NX, row + PLY_RADIUS, color };
    GpBytes *array[ATTRIBUTES];
    arrays_of(points, array);
    for (int i = 0; i < ATTRIBUTES; i++)
        if (array[i])
            gp_bytes_append(array[i], values[i], row_bytes[i]);
}

static size_t read_items(const PlyItems *items, void *context)
{
    const size_t count = items->element->kind == PLY_VERTEX ? read_block(items, context) : 0;
    if (count > 0)
        return count;
    read_one(items, context);
    return 1;
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
    for (size_t i = 0; i < header.element_count; i++)
        if (header.element[i].kind == PLY_FACE)
            points->face_count = header.element[i].count;
    if (points->face_count > 0) /* a mesh, of which no more is asked */
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
        if (element->kind != PLY_VERTEX)
            continue;
        GpBytes *array[ATTRIBUTES];
        void *rows[ATTRIBUTES];
        arrays_of(points, array);
        new_rows(array, count, rows);
    }
    gp_ply_items(input, &header, read_items, points);
}
