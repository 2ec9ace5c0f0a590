/* Wavefront OBJ: vertices, normals, texture coordinates, polygons; the rest is passed over.
 * source Wavefront, "Object Files (.obj)", Advanced Visualizer manual, appendix B1 */
#include "pipeline/io/mesh/mesh_check.h"
#include "pipeline/io/mesh/mesh_text.h"

#include <string.h>

typedef enum Attribute {
    POSITION,
    TEXCOORD,
    NORMAL,
    ATTRIBUTES
} Attribute; /* in the order of a corner "v/vt/vn" */

typedef struct ObjCheck {
    GpText text;
    int64_t total[ATTRIBUTES]; /* in the whole file */
    int64_t seen[ATTRIBUTES];  /* up to the present line: negative indices count back from here */
    int64_t colors, faces;
} ObjCheck;

static const struct {
    const char *keyword, *name;
    size_t least, most;
} attributes[ATTRIBUTES] = {
    [POSITION] = { .keyword = "v", .name = "vertex", .least = 3, .most = 7 },
    [TEXCOORD] = { .keyword = "vt", .name = "texture coordinate", .least = 2, .most = 3 },
    [NORMAL] = { .keyword = "vn", .name = "normal", .least = 3, .most = 3 },
};

/* The numbers after v, vt or vn. A vertex may have a weight (4 numbers), which is ignored, a colour
 * (6) or both (7), of which OpenMesh would make a wrong colour. */
static GpResult check_numbers(ObjCheck *check, Attribute attribute)
{
    size_t count = 0;
    GpWord word;
    for (; gp_text_word(&check->text, &word); count++) {
        char shown[44];
        float number;
        if (!gp_word_number(&word, &number))
            return gp_text_fail(&check->text, GP_ERROR_FORMAT,
                                "expected a finite number, found '%s'", gp_word_show(&word, shown));
    }
    if (count < attributes[attribute].least || count > attributes[attribute].most ||
        (attribute == POSITION && count == 5))
        return gp_text_fail(&check->text, GP_ERROR_FORMAT, "a %s has no %zu numbers",
                            attributes[attribute].name, count);
    if (attribute == POSITION && count == 7)
        return gp_text_fail(&check->text, GP_ERROR_UNSUPPORTED,
                            "a vertex with weight and colour is not read");
    check->colors += attribute == POSITION && count == 6;
    check->total[attribute]++;
    return GP_OK;
}

/* One corner: v, v/vt, v//vn or v/vt/vn. */
static GpResult check_corner(const ObjCheck *check, const GpWord *corner)
{
    const char *at = corner->text, *end = corner->text + corner->size;
    char shown[44];
    for (int attribute = 0; at <= end; attribute++) {
        const char *slash = memchr(at, '/', (size_t)(end - at));
        const char *stop = slash ? slash : end;
        GpWord part = { .text = (char *)at, .size = (size_t)(stop - at) };
        at = stop + 1;
        if (part.size == 0 && attribute == TEXCOORD && slash)
            continue;
        int64_t index;
        if (attribute >= ATTRIBUTES || !gp_word_integer(&part, &index))
            return gp_text_fail(&check->text, GP_ERROR_FORMAT,
                                "face %lld: expected a corner like 1, 1/1, 1//1 or 1/1/1, "
                                "found '%s'",
                                (long long)check->faces, gp_word_show(corner, shown));
        int64_t absolute = index < 0 ? check->seen[attribute] + index + 1 : index;
        if (absolute < 1 || absolute > check->total[attribute])
            return gp_text_fail(
                &check->text, GP_ERROR_FORMAT, "face %lld refers to %s %lld, but there are %lld",
                (long long)check->faces, attributes[attribute].name, (long long)index,
                (long long)(index < 0 ? check->seen[attribute] : check->total[attribute]));
    }
    return GP_OK;
}

static GpResult check_face(ObjCheck *check)
{
    size_t corners = 0;
    GpWord word;
    for (; gp_text_word(&check->text, &word); corners++) {
        GpResult result = check_corner(check, &word);
        if (result != GP_OK)
            return result;
    }
    if (corners < 3)
        return gp_text_fail(&check->text, GP_ERROR_FORMAT,
                            "face %lld has %zu corners, 3 or more are expected",
                            (long long)check->faces, corners);
    check->faces++;
    return GP_OK;
}

/* True where a backslash ends the present line, which holds a character that is no space. */
static bool is_continued(const GpText *text)
{
    const char *last = text->line_end - 1;
    while (last > text->next && (*last == '\r' || *last == ' '))
        last--;
    return *last == '\\';
}

/* First walk: count and check the numbers. Materials are blanked, since OpenMesh would open the
 * files that they name; a continued line is not known to it. */
static GpResult check_attributes(ObjCheck *check)
{
    while (gp_text_line(&check->text)) {
        if (is_continued(&check->text))
            return gp_text_fail(&check->text, GP_ERROR_UNSUPPORTED,
                                "lines continued with \\ are not read");
        GpWord word = { .text = NULL, .size = 0 };
        gp_text_word(&check->text, &word);
        if (gp_word_is(&word, "mtllib") || gp_word_is(&word, "usemtl"))
            memset(word.text, ' ', (size_t)(check->text.line_end - word.text));
        if (gp_word_is(&word, "vc"))
            return gp_text_fail(&check->text, GP_ERROR_UNSUPPORTED,
                                "colours apart from vertices (vc) are not read");
        for (int i = 0; i < ATTRIBUTES; i++) {
            if (!gp_word_is(&word, attributes[i].keyword))
                continue;
            GpResult result = check_numbers(check, (Attribute)i);
            if (result != GP_OK)
                return result;
        }
    }
    return GP_OK;
}

/* Second walk: every index of every face. */
static GpResult check_faces(ObjCheck *check)
{
    while (gp_text_line(&check->text)) {
        GpWord word = { .text = NULL, .size = 0 };
        gp_text_word(&check->text, &word);
        for (int i = 0; i < ATTRIBUTES; i++)
            check->seen[i] += gp_word_is(&word, attributes[i].keyword);
        if (!gp_word_is(&word, "f"))
            continue;
        GpResult result = check_face(check);
        if (result != GP_OK)
            return result;
    }
    return GP_OK;
}

GpResult gp_mesh_check_obj(GpMeshSource *source, GpError *error)
{
    GpText start = gp_text_begin(source->path, source->file.data, source->file.size, error);
    ObjCheck check = { .text = start };
    GpResult result = check_attributes(&check);
    if (result != GP_OK)
        return result;
    if (check.total[POSITION] > GP_MESH_COUNT_MAX)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: more than 2^31 vertices", source->path);
    if (check.colors != 0 && check.colors != check.total[POSITION])
        return gp_fail(error, GP_ERROR_FORMAT, "%s: only %lld of %lld vertices have a colour",
                       source->path, (long long)check.colors, (long long)check.total[POSITION]);
    check.text = start;
    result = check_faces(&check);
    if (result != GP_OK)
        return result;
    source->vertex_count = (size_t)check.total[POSITION];
    source->face_count = (size_t)check.faces;
    source->has_colors = check.colors > 0;
    source->has_texcoords = check.total[TEXCOORD] > 0;
    source->has_normals = check.total[NORMAL] > 0;
    return GP_OK;
}
