/* Object File Format, text: [ST][C][N]OFF, the counts, one vertex per line, one face per line.
 * source geomview.org "OFF Files", of which this is the subset that is in use */
#include "pipeline/io/mesh/mesh_formats.h"

#include <string.h>

/* Comments end at the line's end. */
static void blank_comments(char *at, char *end)
{
    for (bool in_comment = false; at < end; at++) {
        in_comment = *at != '\n' && (in_comment || *at == '#');
        if (in_comment)
            *at = ' ';
    }
}

/* "[ST][C][N]OFF"; the counts may follow on the same line. */
static bool read_keyword(GpInput *input, GpMeshBuilder *mesh)
{
    char *begin = input->next;
    GpWord word = { .text = NULL, .size = 0 };
    input->number = 1;
    input->line_end = memchr(begin, '\n', (size_t)(input->end - begin));
    if (!input->line_end)
        input->line_end = input->end;
    gp_input_word(input, &word);
    GpWord rest = word;
    const char *letter[] = { "ST", "C", "N", "4", "n" };
    bool has[GP_COUNT(letter)];
    for (size_t i = 0; i < GP_COUNT(letter); i++) {
        size_t size = strlen(letter[i]);
        has[i] = rest.size >= size && memcmp(rest.text, letter[i], size) == 0;
        rest.text += has[i] ? size : 0;
        rest.size -= has[i] ? size : 0;
    }
    char shown[44];
    if (!gp_word_is(&rest, "OFF") || word.text != begin)
        return gp_input_fail(input, GP_ERROR_FORMAT, "expected OFF, found '%s'",
                             gp_word_show(&word, shown));
    if (has[3] || has[4])
        return gp_input_fail(input, GP_ERROR_UNSUPPORTED, "vertices must have three dimensions");
    mesh->has[GP_MESH_TEXCOORD] = has[0];
    mesh->has[GP_MESH_COLOR] = has[1];
    mesh->has[GP_MESH_NORMAL] = has[2];

    char *after = input->next;
    if (gp_input_word(input, &rest) && gp_word_is(&rest, "BINARY"))
        return gp_input_fail(input, GP_ERROR_UNSUPPORTED, "binary OFF is not read");
    input->next = after;
    return true;
}

static bool read_counts(GpInput *input, int64_t count[3])
{
    for (int i = 0; i < 3; i++) {
        GpWord word;
        if (!gp_input_any_word(input, &word) || !gp_word_integer(&word, &count[i]) ||
            count[i] < 0 || count[i] > GP_INPUT_COUNT_MAX)
            return gp_input_fail(input, GP_ERROR_FORMAT,
                                 "expected the counts of vertices, faces and edges");
    }
    /* "0 0 0\n" and "3 0 0 0\n" are the shortest vertex and face. */
    int64_t left = input->end - input->next;
    if (count[0] > left / 5 || count[1] > left / 7)
        return gp_input_fail(input, GP_ERROR_FORMAT,
                             "%lld vertices and %lld faces are promised, but only %lld "
                             "bytes follow",
                             (long long)count[0], (long long)count[1], (long long)left);
    char *newline = memchr(input->next, '\n', (size_t)left);
    input->line_end = newline ? newline : input->end;
    GpWord word;
    if (gp_input_word(input, &word))
        return gp_input_fail(input, GP_ERROR_FORMAT, "expected nothing after the counts");
    return true;
}

/* Integers in 0..255 where the first has no point, else floats as they are. */
static bool read_color(const GpWord *words, size_t count, float *color)
{
    bool is_float = memchr(words[0].text, '.', words[0].size) != NULL;
    for (size_t i = 0; i < count; i++) {
        int64_t integer = 0;
        if (is_float ? !gp_word_number(&words[i], &color[i])
                     : !gp_word_integer(&words[i], &integer) || integer < 0 || integer > 255)
            return false;
        if (!is_float)
            color[i] = (float)integer / 255.0f;
    }
    return true;
}

/* x y z [nx ny nz] [r g b [a]] [u v]; in plain OFF anything after that is for others. */
static bool read_vertex(GpInput *input, GpMeshBuilder *mesh)
{
    GpWord word[13];
    size_t count = 0, index = mesh->vertex_count;
    while (count < GP_COUNT(word) && gp_input_word(input, &word[count]))
        count++;
    bool has_color = mesh->has[GP_MESH_COLOR], has_texcoord = mesh->has[GP_MESH_TEXCOORD];
    size_t before = mesh->has[GP_MESH_NORMAL] ? 6 : 3, after = has_texcoord ? 2 : 0;
    size_t least = before + (has_color ? 3 : 0) + after;
    size_t most = least + (has_color ? 1 : 0);
    bool is_open = !has_color && !has_texcoord;
    if (count < least || (count > most && !is_open))
        return gp_input_fail(input, GP_ERROR_FORMAT,
                             "vertex %zu has %zu numbers, but %zu are expected", index, count,
                             least);
    if (is_open)
        count = before;
    char shown[44];
    float number[GP_VERTEX_FLOATS], vertex[GP_VERTEX_FLOATS] = { [GP_VERTEX_COLOR + 3] = 1 };
    for (size_t i = 0; i < count; i++) {
        if (!gp_word_number(&word[i], &number[i]))
            return gp_input_fail(input, GP_ERROR_FORMAT,
                                 "vertex %zu: expected a finite number, found '%s'", index,
                                 gp_word_show(&word[i], shown));
    }
    memcpy(vertex, number, before * sizeof(float));
    memcpy(vertex + GP_VERTEX_TEXCOORD, number + count - after, after * sizeof(float));
    if (has_color && !read_color(word + before, count - before - after, vertex + GP_VERTEX_COLOR))
        return gp_input_fail(input, GP_ERROR_FORMAT,
                             "vertex %zu: expected a colour of integers in 0..255 or of "
                             "numbers with decimal points",
                             index);
    gp_mesh_add_vertex(mesh, vertex);
    return true;
}

/* n i0 .. i(n-1); a colour may follow, which is not used. */
static bool read_face(GpInput *input, GpMeshBuilder *mesh)
{
    GpWord word = { .text = NULL, .size = 0 };
    int64_t corners;
    size_t index = mesh->face_count;
    char shown[44];
    if (!gp_input_word(input, &word) || !gp_word_integer(&word, &corners) || corners < 3)
        return gp_input_fail(input, GP_ERROR_FORMAT,
                             "face %zu: expected 3 or more corners, found '%s'", index,
                             gp_word_show(&word, shown));
    gp_mesh_begin_face(mesh);
    for (int64_t i = 0; i < corners; i++) {
        int64_t vertex;
        if (!gp_input_word(input, &word) || !gp_word_integer(&word, &vertex))
            return gp_input_fail(input, GP_ERROR_FORMAT,
                                 "face %zu: expected %lld vertex numbers, found '%s'", index,
                                 (long long)corners, gp_word_show(&word, shown));
        if (vertex < 0 || vertex >= (int64_t)mesh->vertex_count)
            return gp_input_fail(input, GP_ERROR_FORMAT,
                                 "face %zu refers to vertex %lld, but there are %zu", index,
                                 (long long)vertex, mesh->vertex_count);
        gp_mesh_add_corner(mesh, (uint32_t)vertex);
    }
    return true;
}

void gp_mesh_read_off(GpInput *input, GpMeshBuilder *mesh)
{
    int64_t count[3] = { 0, 0, 0 }; /* vertices, faces, edges */
    blank_comments(input->next, input->end);
    if (!read_keyword(input, mesh) || !read_counts(input, count))
        return;
    gp_mesh_builder_reserve(mesh, (size_t)count[0], (size_t)count[1]);
    for (int64_t i = 0; i < count[0] + count[1] && input->result == GP_OK; i++) {
        bool is_vertex = i < count[0];
        if (!gp_input_line(input))
            gp_input_fail(input, GP_ERROR_FORMAT, "the file ends, but %s %lld of %lld is expected",
                          is_vertex ? "vertex" : "face", (long long)(is_vertex ? i : i - count[0]),
                          (long long)count[is_vertex ? 0 : 1]);
        else if (is_vertex)
            read_vertex(input, mesh);
        else
            read_face(input, mesh);
    }
}
