/* Stereolithography, text and binary.
 * source 3D Systems, "StereoLithography Interface Specification", 1989 */
#include "pipeline/io/mesh/mesh_formats.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum {
    HEADER_SIZE = 84, /* 80 bytes of text and the count */
    FACET_SIZE = 50,  /* normal, three corners, two bytes of anything */
};

static const uint64_t MULTIPLIER = 0x9e3779b97f4a7c15u; /* of the hash: the golden ratio */

/* Corners become vertices by a hash table of vertex numbers + 1 with linear probing. Its size is a
 * power of two and more than twice the corners that a file of this size can have. */
typedef struct Weld {
    GpMeshBuilder *mesh;
    uint32_t *slots;
    size_t slot_count;
} Weld;

/* What is welded has equal keys: the bits of coordinates, where nothing up to the smallest normal
 * number differs from 0. */
static void make_key(const float position[3], uint32_t key[3])
{
    for (int i = 0; i < 3; i++)
        key[i] = fabsf(position[i]) <= FLT_MIN ? 0 : gp_float_bits(position[i]);
}

/* The vertex at a position, a new one where there is none. */
static uint32_t weld_corner(Weld *weld, const float position[3])
{
    GpMeshBuilder *mesh = weld->mesh;
    const float *known = (const float *)mesh->values[GP_MESH_POSITION].data;
    uint32_t key[3], other[3];
    make_key(position, key);
    uint64_t hash = ((key[0] * MULTIPLIER + key[1]) * MULTIPLIER + key[2]) * MULTIPLIER >> 32;
    size_t at = (size_t)hash & (weld->slot_count - 1);
    for (; known && weld->slots[at] != 0; at = (at + 1) & (weld->slot_count - 1)) {
        make_key(known + 3 * (size_t)(weld->slots[at] - 1), other);
        if (memcmp(key, other, sizeof key) == 0)
            return weld->slots[at] - 1;
    }
    float vertex[GP_VERTEX_FLOATS] = { position[0], position[1], position[2] };
    gp_mesh_add_vertex(mesh, vertex);
    weld->slots[at] = (uint32_t)mesh->vertex_count;
    return weld->slots[at] - 1;
}

/* A facet whose corners weld has no area and is skipped; its vertices stay. */
static bool add_facet(Weld *weld, const float corners[9])
{
    GpMeshBuilder *mesh = weld->mesh;
    uint32_t corner[3];
    for (size_t i = 0; i < 3; i++)
        corner[i] = weld_corner(weld, corners + 3 * i);
    gp_mesh_begin_face(mesh);
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) {
        mesh->skipped_count++;
    } else {
        for (size_t i = 0; i < 3; i++)
            gp_mesh_add_corner(mesh, corner[i]);
    }
    /* Without positions nothing is left to compare with. */
    return !mesh->values[GP_MESH_POSITION].failed;
}

static void read_binary(Weld *weld, GpInput *input)
{
    size_t size = (size_t)(input->end - input->begin);
    input->number = 0;
    const char *header = gp_input_take(input, HEADER_SIZE);
    if (!header) {
        gp_input_fail(input, GP_ERROR_FORMAT,
                      "expected 'solid' or a header of 84 bytes, but there are %zu", size);
        return;
    }
    size_t count = gp_load_little(header + 80, 4);
    input->place = header + 80;
    if (HEADER_SIZE + FACET_SIZE * count != size) {
        gp_input_fail(input, GP_ERROR_FORMAT, "%zu triangles need %zu bytes, but the file has %zu",
                      count, HEADER_SIZE + FACET_SIZE * count, size);
        return;
    }
    gp_mesh_builder_reserve(weld->mesh, count / 2, count); /* a closed mesh has half as many */
    for (size_t face = 0; face < count && input->result == GP_OK; face++) {
        const char *facet = gp_input_take(input, FACET_SIZE);
        float corners[9];
        for (size_t i = 0; i < 9; i++) {
            input->place = facet + 12 + 4 * i;
            corners[i] = gp_bits_float((uint32_t)gp_load_little(input->place, 4));
            if (!isfinite(corners[i]))
                gp_input_fail(input, GP_ERROR_FORMAT, "corner %zu of face %zu is not finite", i / 3,
                              face);
        }
        if (input->result == GP_OK && !add_facet(weld, corners))
            gp_input_fail(input, GP_ERROR_MEMORY, "no memory for vertices");
    }
}

/* The lines of a facet: a star stands for a finite number, a question mark for anything (facet
 * normals are not used, and often nan). */
static const char *const facet_lines[] = {
    "facet normal ? ? ?", "outer loop", "vertex * * *", "vertex * * *",
    "vertex * * *",       "endloop",    "endfacet",
};

enum { FIRST_CORNER = 2, LAST_CORNER = 4 }; /* of facet_lines */

/* Keywords may have any case. The numbers in place of the stars go to number. */
static bool line_matches(GpInput *input, const char *pattern, float *number)
{
    GpWord word = { .text = NULL, .size = 0 };
    bool matches = true;
    while (*pattern && matches) {
        char expected[12] = "";
        size_t length = strcspn(pattern, " ");
        memcpy(expected, pattern, length);
        pattern += length + (pattern[length] == ' ');
        matches = gp_input_word(input, &word);
        if (matches && *expected == '*')
            matches = gp_word_number(&word, number++);
        else if (matches && *expected != '?')
            matches = gp_word_is_any_case(&word, expected);
    }
    return matches && !gp_input_word(input, &word);
}

/* "solid name" and "endsolid name" */
static bool take_bracket(GpInput *input, const char *keyword)
{
    char *begin = input->next;
    GpWord word = { .text = NULL, .size = 0 };
    gp_input_word(input, &word);
    if (gp_word_is_any_case(&word, keyword))
        return true;
    input->next = begin;
    return false;
}

static void read_text(Weld *weld, GpInput *input)
{
    float corners[9] = { 0 };
    bool is_open = false;     /* between solid and endsolid */
    size_t line = 0;          /* of facet_lines, next to come */
    size_t previous_line = 0; /* of the file */
    while (input->result == GP_OK && gp_input_line(input)) {
        bool follows = input->number == previous_line + 1 || line == 0;
        previous_line = input->number;
        if (line == 0 && take_bracket(input, is_open ? "endsolid" : "solid")) {
            is_open = !is_open;
            continue;
        }
        bool is_corner = line >= FIRST_CORNER && line <= LAST_CORNER;
        float *number = corners + (is_corner ? 3 * (line - FIRST_CORNER) : 0);
        if (!is_open || !follows || !line_matches(input, facet_lines[line], number))
            gp_input_fail(input, GP_ERROR_FORMAT, "face %zu: expected '%s'", weld->mesh->face_count,
                          is_open ? facet_lines[line] : "solid");
        line = (line + 1) % GP_COUNT(facet_lines);
        if (line == 0 && !add_facet(weld, corners))
            gp_input_fail(input, GP_ERROR_MEMORY, "no memory for vertices");
    }
    if (is_open)
        gp_input_fail(input, GP_ERROR_FORMAT, "the file ends inside a solid, after %zu faces",
                      weld->mesh->face_count);
}

/* Binary files may start with "solid" too; their size gives them away. */
static bool is_text(GpInput input)
{
    size_t size = (size_t)(input.end - input.begin);
    if (size >= HEADER_SIZE &&
        HEADER_SIZE + FACET_SIZE * gp_load_little(input.begin + 80, 4) == size)
        return false;
    GpWord word = { .text = NULL, .size = 0 };
    gp_input_any_word(&input, &word);
    return gp_word_is_any_case(&word, "solid");
}

void gp_mesh_read_stl(GpInput *input, GpMeshBuilder *mesh)
{
    Weld weld = { .mesh = mesh, .slot_count = 64 };
    while (weld.slot_count <= (size_t)(input->end - input->begin) / FACET_SIZE * 3 * 2)
        weld.slot_count *= 2;
    weld.slots = gp_alloc(weld.slot_count, sizeof(uint32_t));
    if (!weld.slots)
        gp_input_fail(input, GP_ERROR_MEMORY, "no memory for vertices");
    else if (is_text(*input))
        read_text(&weld, input);
    else
        read_binary(&weld, input);
    gp_free(weld.slots);
}
