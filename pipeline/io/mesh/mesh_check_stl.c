/* Stereolithography, text and binary.
 * source 3D Systems, "StereoLithography Interface Specification", 1989 */
#include "pipeline/io/bytes.h"
#include "pipeline/io/mesh/mesh_check.h"
#include "pipeline/io/mesh/mesh_text.h"

#include <math.h>
#include <string.h>

enum {
    HEADER_SIZE = 84, /* 80 bytes of text and the count */
    FACET_SIZE = 50,  /* normal, three corners, two bytes of anything */
};

static GpResult check_binary(GpMeshSource *source, GpError *error)
{
    const char *data = source->file.data;
    size_t size = source->file.size;
    if (size < HEADER_SIZE)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: byte 0: expected 'solid' or a header of 84 bytes, but there are %zu",
                       source->path, size);
    size_t count = gp_load_little(data + 80, 4);
    if (HEADER_SIZE + FACET_SIZE * count != size)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: byte 80: %zu triangles need %zu bytes, but the file has %zu",
                       source->path, count, HEADER_SIZE + FACET_SIZE * count, size);
    for (size_t face = 0; face < count; face++) {
        for (size_t i = 0; i < 9; i++) {
            size_t at = HEADER_SIZE + FACET_SIZE * face + 12 + 4 * i;
            if (!isfinite(gp_bits_float((uint32_t)gp_load_little(data + at, 4))))
                return gp_fail(error, GP_ERROR_FORMAT,
                               "%s: byte %zu: corner %zu of face %zu is not finite", source->path,
                               at, i / 3, face);
        }
    }
    source->vertex_count = 3 * count;
    source->face_count = count;
    source->is_binary = true;
    return GP_OK;
}

/* The lines of a facet: a star stands for a finite number, a question mark for anything (facet
 * normals are not used, and often nan). OpenMesh takes the three lines after "outer" for corners
 * whatever they say, so no line may be missing or doubled. */
static const char *const facet_lines[] = {
    "facet normal ? ? ?", "outer loop", "vertex * * *", "vertex * * *",
    "vertex * * *",       "endloop",    "endfacet",
};

/* Keywords may have any case in the file; they are made small, since OpenMesh misses "Outer". */
static bool word_matches(const GpWord *word, const char *expected)
{
    float number;
    if (*expected == '?')
        return true;
    if (*expected == '*')
        return gp_word_number(word, &number);
    if (!gp_word_is_any_case(word, expected))
        return false;
    memcpy(word->text, expected, word->size);
    return true;
}

static bool line_matches(GpText *text, const char *pattern)
{
    char *begin = text->next;
    GpWord word = { .text = NULL, .size = 0 };
    bool matches = true;
    while (*pattern && matches) {
        char expected[12] = "";
        size_t length = strcspn(pattern, " ");
        memcpy(expected, pattern, length);
        pattern += length + (pattern[length] == ' ');
        matches = gp_text_word(text, &word) && word_matches(&word, expected);
    }
    matches = matches && !gp_text_word(text, &word);
    text->next = begin;
    return matches;
}

/* "solid name" and "endsolid name": the name is blanked, it might be "outer". */
static bool take_bracket(GpText *text, const char *keyword)
{
    char *begin = text->next;
    GpWord word = { .text = NULL, .size = 0 };
    gp_text_word(text, &word);
    if (!gp_word_is_any_case(&word, keyword)) {
        text->next = begin;
        return false;
    }
    memset(text->next, ' ', (size_t)(text->line_end - text->next));
    return true;
}

static GpResult check_text(GpMeshSource *source, GpError *error)
{
    GpText text = gp_text_begin(source->path, source->file.data, source->file.size, error);
    bool is_open = false;     /* between solid and endsolid */
    size_t line = 0;          /* of facet_lines, next to come */
    size_t previous_line = 0; /* of the file */
    while (gp_text_line(&text)) {
        bool follows = text.number == previous_line + 1 || line == 0;
        previous_line = text.number;
        if (line == 0 && take_bracket(&text, is_open ? "endsolid" : "solid")) {
            is_open = !is_open;
            continue;
        }
        if (!is_open || !follows || !line_matches(&text, facet_lines[line]))
            return gp_text_fail(&text, GP_ERROR_FORMAT, "face %zu: expected '%s'",
                                source->face_count, is_open ? facet_lines[line] : "solid");
        line = (line + 1) % GP_COUNT(facet_lines);
        source->face_count += line == 0;
    }
    if (is_open)
        return gp_text_fail(&text, GP_ERROR_FORMAT, "the file ends inside a solid, after %zu faces",
                            source->face_count);
    source->vertex_count = 3 * source->face_count;
    return GP_OK;
}

GpResult gp_mesh_check_stl(GpMeshSource *source, GpError *error)
{
    /* Binary files may start with "solid" too; their size gives them away. */
    const char *data = source->file.data;
    size_t size = source->file.size;
    if (size >= HEADER_SIZE && HEADER_SIZE + FACET_SIZE * gp_load_little(data + 80, 4) == size)
        return check_binary(source, error);
    GpText text = gp_text_begin(source->path, source->file.data, size, error);
    GpWord word = { .text = NULL, .size = 0 };
    gp_text_any_word(&text, &word);
    return gp_word_is_any_case(&word, "solid") ? check_text(source, error)
                                               : check_binary(source, error);
}
