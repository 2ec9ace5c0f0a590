/* Object File Format, text: [ST][C][N]OFF, the counts, one vertex per line, one face per line.
 * source geomview.org "OFF Files"; OpenMesh 9's reader, which takes only this subset */
#include "pipeline/io/mesh/mesh_check.h"
#include "pipeline/io/mesh/mesh_text.h"

#include <string.h>

/* Comments end at the line's end; blanked, no reader trips over them. */
static void blank_comments(char *at, char *end)
{
    for (bool in_comment = false; at < end; at++) {
        in_comment = *at != '\n' && (in_comment || *at == '#');
        if (in_comment)
            *at = ' ';
    }
}

/* Reads "[ST][C][N]OFF". The counts may follow on the same line, where OpenMesh does not look for
 * them: the white space between becomes a newline. */
static GpResult check_keyword(GpMeshSource *source, GpText *text)
{
    GpWord word = { .text = NULL, .size = 0 };
    text->number = 1;
    text->line_end = memchr(text->next, '\n', source->file.size);
    if (!text->line_end)
        text->line_end = text->end;
    gp_text_word(text, &word);
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
    if (!gp_word_is(&rest, "OFF") || word.text != source->file.data)
        return gp_text_fail(text, GP_ERROR_FORMAT, "expected OFF, found '%s'",
                            gp_word_show(&word, shown));
    if (has[3] || has[4])
        return gp_text_fail(text, GP_ERROR_UNSUPPORTED, "vertices must have three dimensions");
    source->has_texcoords = has[0];
    source->has_colors = has[1];
    source->has_normals = has[2];

    char *after = text->next;
    if (gp_text_word(text, &rest) && gp_word_is(&rest, "BINARY"))
        return gp_text_fail(text, GP_ERROR_UNSUPPORTED, "binary OFF is not read");
    text->next = after;
    if (after < text->end && *after != '\n') {
        *after = '\n';
        text->number = 0; /* this newline was not in the file */
    }
    return GP_OK;
}

static GpResult check_counts(GpMeshSource *source, GpText *text)
{
    int64_t count[3] = { 0, 0, 0 };
    for (int i = 0; i < 3; i++) {
        GpWord word;
        if (!gp_text_any_word(text, &word) || !gp_word_integer(&word, &count[i]) || count[i] < 0 ||
            count[i] > GP_MESH_COUNT_MAX)
            return gp_text_fail(text, GP_ERROR_FORMAT,
                                "expected the counts of vertices, faces and edges");
    }
    /* "0 0 0\n" and "3 0 0 0\n" are the shortest vertex and face. */
    int64_t left = text->end - text->next;
    if (count[0] > left / 5 || count[1] > left / 7)
        return gp_text_fail(text, GP_ERROR_FORMAT,
                            "%lld vertices and %lld faces are promised, but only %lld "
                            "bytes follow",
                            (long long)count[0], (long long)count[1], (long long)left);
    source->vertex_count = (size_t)count[0];
    source->face_count = (size_t)count[1];
    char *newline = memchr(text->next, '\n', (size_t)left);
    text->line_end = newline ? newline : text->end;
    GpWord word;
    if (gp_text_word(text, &word))
        return gp_text_fail(text, GP_ERROR_FORMAT, "expected nothing after the counts");
    return GP_OK;
}

/* OpenMesh takes colours as integers in 0..255 where the first has no point, else as floats, and
 * finds their number by counting single spaces. */
static bool is_color(const GpWord *words, size_t count)
{
    bool is_float = memchr(words[0].text, '.', words[0].size) != NULL;
    for (size_t i = 0; i < count; i++) {
        int64_t integer;
        float number;
        if (is_float ? !gp_word_number(&words[i], &number)
                     : !gp_word_integer(&words[i], &integer) || integer < 0 || integer > 255)
            return false;
    }
    return true;
}

/* Writes the words of a line again with one space between them. */
static void squeeze(char *begin, char *end, const GpWord *words, size_t count)
{
    char *at = begin;
    for (size_t i = 0; i < count; i++) {
        if (i > 0)
            *at++ = ' ';
        memmove(at, words[i].text, words[i].size);
        at += words[i].size;
    }
    memset(at, ' ', (size_t)(end - at));
}

/* x y z [nx ny nz] [r g b [a]] [u v]; in plain OFF anything after that is for others. */
static GpResult check_vertex(const GpMeshSource *source, GpText *text, size_t index)
{
    char *begin = text->next;
    GpWord word[13];
    size_t count = 0;
    while (count < GP_COUNT(word) && gp_text_word(text, &word[count]))
        count++;
    size_t before = source->has_normals ? 6 : 3, after = source->has_texcoords ? 2 : 0;
    size_t least = before + (source->has_colors ? 3 : 0) + after;
    size_t most = least + (source->has_colors ? 1 : 0);
    bool is_open = !source->has_colors && !source->has_texcoords;
    if (count < least || (count > most && !is_open))
        return gp_text_fail(text, GP_ERROR_FORMAT,
                            "vertex %zu has %zu numbers, but %zu are expected", index, count,
                            least);
    char shown[44];
    for (size_t i = 0; i < (is_open ? before : count); i++) {
        float number;
        if (!gp_word_number(&word[i], &number))
            return gp_text_fail(text, GP_ERROR_FORMAT,
                                "vertex %zu: expected a finite number, found '%s'", index,
                                gp_word_show(&word[i], shown));
    }
    if (source->has_colors && !is_color(word + before, count - before - after))
        return gp_text_fail(text, GP_ERROR_FORMAT,
                            "vertex %zu: expected a colour of integers in 0..255 or of "
                            "numbers with decimal points",
                            index);
    squeeze(begin, text->line_end, word, is_open ? before : count);
    return GP_OK;
}

/* n i0 .. i(n-1), then perhaps a colour, which is blanked: OpenMesh misreads it in plain OFF. */
static GpResult check_face(const GpMeshSource *source, GpText *text, size_t index)
{
    GpWord word = { .text = NULL, .size = 0 };
    int64_t corners;
    char shown[44];
    if (!gp_text_word(text, &word) || !gp_word_integer(&word, &corners) || corners < 3)
        return gp_text_fail(text, GP_ERROR_FORMAT,
                            "face %zu: expected 3 or more corners, found '%s'", index,
                            gp_word_show(&word, shown));
    for (int64_t i = 0; i < corners; i++) {
        int64_t vertex;
        if (!gp_text_word(text, &word) || !gp_word_integer(&word, &vertex))
            return gp_text_fail(text, GP_ERROR_FORMAT,
                                "face %zu: expected %lld vertex numbers, found '%s'", index,
                                (long long)corners, gp_word_show(&word, shown));
        if (vertex < 0 || vertex >= (int64_t)source->vertex_count)
            return gp_text_fail(text, GP_ERROR_FORMAT,
                                "face %zu refers to vertex %lld, but there are %zu", index,
                                (long long)vertex, source->vertex_count);
    }
    memset(text->next, ' ', (size_t)(text->line_end - text->next));
    return GP_OK;
}

GpResult gp_mesh_check_off(GpMeshSource *source, GpError *error)
{
    GpText text = gp_text_begin(source->path, source->file.data, source->file.size, error);
    blank_comments(text.next, text.end);
    GpResult result = check_keyword(source, &text);
    if (result == GP_OK)
        result = check_counts(source, &text);
    size_t count = source->vertex_count + source->face_count;
    for (size_t i = 0; i < count && result == GP_OK; i++) {
        bool is_vertex = i < source->vertex_count;
        size_t index = is_vertex ? i : i - source->vertex_count;
        if (!gp_text_line(&text))
            return gp_text_fail(&text, GP_ERROR_FORMAT,
                                "the file ends, but %s %zu of %zu is expected",
                                is_vertex ? "vertex" : "face", index,
                                is_vertex ? source->vertex_count : source->face_count);
        result = is_vertex ? check_vertex(source, &text, index) : check_face(source, &text, index);
    }
    return result;
}
