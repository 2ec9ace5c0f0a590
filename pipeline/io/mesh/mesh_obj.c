/* Wavefront OBJ: vertices, normals, texture coordinates, polygons; the rest is passed over.
 * source Wavefront, "Object Files (.obj)", Advanced Visualizer manual, appendix B1 */
#include "pipeline/io/mesh/mesh_formats.h"

#include <string.h>

typedef enum Attribute {
    POSITION,
    TEXCOORD,
    NORMAL,
    ATTRIBUTES
} Attribute; /* in the order of a corner "v/vt/vn" */

/* A vertex of the mesh: one of the file, or its copy with other attributes. Attributes are numbers
 * of values, of which 0 is what corners have that name none. */
typedef struct Vertex {
    uint32_t attribute[ATTRIBUTES];
    uint32_t next_copy; /* 0: none */
    bool is_used;       /* by a face: the attributes are settled */
} Vertex;

typedef struct Obj {
    GpInput *input;
    GpMeshBuilder *mesh;
    GpBytes values[ATTRIBUTES]; /* rows of floats, the first of zeros; a position is x y z r g b */
    int64_t total[ATTRIBUTES];  /* in the whole file */
    int64_t seen[ATTRIBUTES];   /* up to the present line: negative indices count back from here */
    int64_t colors;
    GpBytes vertices;               /* Vertex: those of the file, then copies */
    uint32_t (*latest)[ATTRIBUTES]; /* what faces named last for the file's vertices */
    GpBytes corners;                /* uint32_t: the file's vertices in the present face */
} Obj;

static const struct {
    const char *name;
    size_t least, most, kept; /* numbers */
} attributes[ATTRIBUTES] = {
    [POSITION] = { "vertex", 3, 7, 6 },
    [TEXCOORD] = { "texture coordinate", 2, 3, 2 },
    [NORMAL] = { "normal", 3, 3, 3 },
};

/* Of a line's keyword; ATTRIBUTES: of none. */
static Attribute attribute_of(const GpWord *keyword)
{
    if (gp_word_is(keyword, "v"))
        return POSITION;
    if (gp_word_is(keyword, "vt"))
        return TEXCOORD;
    return gp_word_is(keyword, "vn") ? NORMAL : ATTRIBUTES;
}

static const float *value_of(const Obj *obj, Attribute attribute, uint32_t number)
{
    const float *values = (const float *)obj->values[attribute].data;
    return values + number * attributes[attribute].kept;
}

/* The numbers after v, vt or vn. A vertex may have a weight (4 numbers), which is ignored, or a
 * colour (6). */
static void read_numbers(Obj *obj, Attribute attribute)
{
    float number[8] = { 0 };
    size_t count = 0;
    GpWord word;
    for (; gp_input_word(obj->input, &word); count++) {
        char shown[44];
        if (!gp_word_number(&word, &number[count < 7 ? count : 7]))
            gp_input_fail(obj->input, GP_ERROR_FORMAT, "expected a finite number, found '%s'",
                          gp_word_show(&word, shown));
    }
    if (count < attributes[attribute].least || count > attributes[attribute].most ||
        (attribute == POSITION && count == 5))
        gp_input_fail(obj->input, GP_ERROR_FORMAT, "a %s has no %zu numbers",
                      attributes[attribute].name, count);
    if (attribute == POSITION && count == 7)
        gp_input_fail(obj->input, GP_ERROR_UNSUPPORTED,
                      "a vertex with weight and colour is not read");
    obj->colors += attribute == POSITION && count == 6;
    obj->total[attribute]++;
    gp_bytes_append(&obj->values[attribute], number, attributes[attribute].kept * sizeof(float));
}

/* One corner: v, v/vt, v//vn or v/vt/vn. */
static bool read_corner(Obj *obj, const GpWord *corner)
{
    const char *at = corner->text, *end = corner->text + corner->size;
    char shown[44];
    uint32_t vertex = 0;
    for (int attribute = 0; at <= end; attribute++) {
        const char *slash = memchr(at, '/', (size_t)(end - at));
        const char *stop = slash ? slash : end;
        GpWord part = { .text = (char *)at, .size = (size_t)(stop - at) };
        at = stop + 1;
        if (part.size == 0 && attribute == TEXCOORD && slash)
            continue;
        int64_t index;
        if (attribute >= ATTRIBUTES || !gp_word_integer(&part, &index))
            return gp_input_fail(obj->input, GP_ERROR_FORMAT,
                                 "face %lld: expected a corner like 1, 1/1, 1//1 or 1/1/1, "
                                 "found '%s'",
                                 (long long)obj->mesh->face_count, gp_word_show(corner, shown));
        int64_t absolute = index < 0 ? obj->seen[attribute] + index + 1 : index;
        if (absolute < 1 || absolute > obj->total[attribute])
            return gp_input_fail(
                obj->input, GP_ERROR_FORMAT, "face %lld refers to %s %lld, but there are %lld",
                (long long)obj->mesh->face_count, attributes[attribute].name, (long long)index,
                (long long)(index < 0 ? obj->seen[attribute] : obj->total[attribute]));
        if (attribute == POSITION)
            vertex = (uint32_t)absolute - 1;
        obj->latest[vertex][attribute] = (uint32_t)absolute;
    }
    gp_bytes_append(&obj->corners, &vertex, sizeof vertex);
    return true;
}

/* Leaves the first of each vertex among the corners; returns how many there are. */
static size_t drop_repeated(uint32_t *corners, size_t count)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        size_t at = 0;
        while (at < kept && corners[at] != corners[i])
            at++;
        if (at == kept)
            corners[kept++] = corners[i];
    }
    return kept;
}

static bool same_values(const Obj *obj, const uint32_t *a, const uint32_t *b)
{
    for (int attribute = TEXCOORD; attribute < ATTRIBUTES; attribute++) {
        const float *left = value_of(obj, (Attribute)attribute, a[attribute]);
        const float *right = value_of(obj, (Attribute)attribute, b[attribute]);
        for (size_t i = 0; i < attributes[attribute].kept; i++) {
            if (left[i] != right[i])
                return false;
        }
    }
    return true;
}

/* The mesh's vertex with the latest attributes of one of the file: itself where no face used it
 * before, a copy made earlier, or a new one. */
static uint32_t settle(Obj *obj, uint32_t number)
{
    Vertex wanted = { .is_used = true };
    memcpy(wanted.attribute, obj->latest[number], sizeof wanted.attribute);
    for (;;) {
        Vertex *vertex = (Vertex *)obj->vertices.data + number;
        if (!vertex->is_used)
            *vertex = wanted;
        if (same_values(obj, vertex->attribute, wanted.attribute))
            return number;
        if (vertex->next_copy == 0) {
            vertex->next_copy = (uint32_t)(obj->vertices.size / sizeof(Vertex));
            number = vertex->next_copy;
            gp_bytes_append(&obj->vertices, &wanted, sizeof wanted);
            return number;
        }
        number = vertex->next_copy;
    }
}

/* A polygon with fewer than three different vertices has no area and is skipped. */
static void read_face(Obj *obj)
{
    size_t corners = 0;
    GpWord word;
    obj->corners.size = 0;
    for (; gp_input_word(obj->input, &word); corners++) {
        if (!read_corner(obj, &word))
            return;
    }
    if (corners < 3)
        gp_input_fail(obj->input, GP_ERROR_FORMAT,
                      "face %zu has %zu corners, 3 or more are expected", obj->mesh->face_count,
                      corners);
    gp_mesh_begin_face(obj->mesh);
    if (obj->corners.failed)
        gp_input_fail(obj->input, GP_ERROR_MEMORY, "no memory for corners");
    if (obj->input->result != GP_OK)
        return;
    uint32_t *corner = (uint32_t *)obj->corners.data;
    size_t different = drop_repeated(corner, corners);
    if (different < 3)
        obj->mesh->skipped_count++;
    for (size_t i = 0; i < different && different >= 3 && obj->input->result == GP_OK; i++) {
        gp_mesh_add_corner(obj->mesh, settle(obj, corner[i]));
        if (obj->vertices.failed)
            gp_input_fail(obj->input, GP_ERROR_MEMORY, "no memory for vertices");
    }
}

/* True where a backslash ends the present line, which holds a character that is no space. */
static bool is_continued(const GpInput *input)
{
    const char *last = input->line_end - 1;
    while (last > input->next && (*last == '\r' || *last == ' '))
        last--;
    return *last == '\\';
}

/* First walk: the numbers. */
static void read_attributes(Obj *obj)
{
    GpInput *input = obj->input;
    while (input->result == GP_OK && gp_input_line(input)) {
        GpWord word = { .text = NULL, .size = 0 };
        if (is_continued(input))
            gp_input_fail(input, GP_ERROR_UNSUPPORTED, "lines continued with \\ are not read");
        gp_input_word(input, &word);
        if (gp_word_is(&word, "vc"))
            gp_input_fail(input, GP_ERROR_UNSUPPORTED,
                          "colours apart from vertices (vc) are not read");
        const Attribute attribute = attribute_of(&word);
        if (attribute < ATTRIBUTES)
            read_numbers(obj, attribute);
    }
}

/* Second walk: the faces. */
static void read_faces(Obj *obj)
{
    while (obj->input->result == GP_OK && gp_input_line(obj->input)) {
        GpWord word = { .text = NULL, .size = 0 };
        gp_input_word(obj->input, &word);
        const Attribute attribute = attribute_of(&word);
        if (attribute < ATTRIBUTES)
            obj->seen[attribute]++;
        else if (gp_word_is(&word, "f"))
            read_face(obj);
    }
}

/* Between the walks: what the numbers must be, and room for what faces name. */
static void prepare(Obj *obj)
{
    GpInput *input = obj->input;
    long long count = obj->total[POSITION], colors = obj->colors;
    size_t size = (size_t)count * sizeof(Vertex);
    if (input->result != GP_OK)
        return;
    if (count > GP_INPUT_COUNT_MAX)
        input->result =
            gp_fail(input->error, GP_ERROR_UNSUPPORTED, "%s: more than 2^31 vertices", input->path);
    else if (colors != 0 && colors != count)
        input->result =
            gp_fail(input->error, GP_ERROR_FORMAT, "%s: only %lld of %lld vertices have a colour",
                    input->path, colors, count);
    if (input->result != GP_OK)
        return;
    gp_bytes_append_zeros(&obj->vertices, size); /* unused */
    obj->latest = gp_alloc((size_t)count, sizeof *obj->latest);
    if (!obj->latest || obj->vertices.failed || obj->values[POSITION].failed ||
        obj->values[TEXCOORD].failed || obj->values[NORMAL].failed)
        gp_input_fail(input, GP_ERROR_MEMORY, "no memory for vertices");
    obj->mesh->has[GP_MESH_COLOR] = colors > 0;
    obj->mesh->has[GP_MESH_TEXCOORD] = obj->total[TEXCOORD] > 0;
    obj->mesh->has[GP_MESH_NORMAL] = obj->total[NORMAL] > 0;
}

/* Vertices that no face names are white where the others have colours, and points have normals
 * where the file has as many as vertices. */
static void add_vertices(const Obj *obj)
{
    GpMeshBuilder *mesh = obj->mesh;
    const Vertex *vertices = (const Vertex *)obj->vertices.data;
    size_t count = obj->vertices.size / sizeof(Vertex), in_file = (size_t)obj->total[POSITION];
    bool are_points = obj->mesh->face_count == 0;
    bool have_normals = are_points && obj->total[NORMAL] == obj->total[POSITION];
    gp_mesh_builder_reserve(mesh, count, 0);
    for (size_t i = 0; i < count; i++) {
        const uint32_t *number = vertices[i].is_used ? vertices[i].attribute : obj->latest[i];
        uint32_t own = i < in_file ? (uint32_t)i + 1 : number[POSITION];
        float row[GP_VERTEX_FLOATS] = { [GP_VERTEX_COLOR] = 1, 1, 1, 1 };
        const float *position = value_of(obj, POSITION, own);
        memcpy(row, position, 3 * sizeof(float));
        if (number[POSITION] != 0 || are_points)
            memcpy(row + GP_VERTEX_COLOR, position + 3, 3 * sizeof(float));
        memcpy(row + GP_VERTEX_NORMAL, value_of(obj, NORMAL, have_normals ? own : number[NORMAL]),
               3 * sizeof(float));
        memcpy(row + GP_VERTEX_TEXCOORD, value_of(obj, TEXCOORD, number[TEXCOORD]),
               2 * sizeof(float));
        gp_mesh_add_vertex(mesh, row);
    }
}

void gp_mesh_read_obj(GpInput *input, GpMeshBuilder *mesh)
{
    static const float zeros[6] = { 0 };
    const GpInput start = *input;
    Obj obj = { .input = input, .mesh = mesh };
    for (int i = 0; i < ATTRIBUTES; i++)
        gp_bytes_append(&obj.values[i], zeros, attributes[i].kept * sizeof(float));
    read_attributes(&obj);
    prepare(&obj);
    if (input->result == GP_OK) {
        *input = start;
        read_faces(&obj);
    }
    if (input->result == GP_OK)
        add_vertices(&obj);
    for (int i = 0; i < ATTRIBUTES; i++)
        gp_free(obj.values[i].data);
    gp_free(obj.vertices.data);
    gp_free(obj.corners.data);
    gp_free(obj.latest);
}
