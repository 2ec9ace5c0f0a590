/* A reader of C's struct declarations, as far as shaders use them: members of float, int32_t,
 * uint32_t, int or of such structs, with up to three dimensions, which are numbers or named
 * ones. */
#include "apps/inspect/uniforms.h"

#include "apps/base/json.h"
#include "apps/inspect/sources.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_MEMBERS = 160, NAME = 96, DEPTH = 4 };

typedef struct Member {
    char name[NAME];
    bool is_float, is_signed;
    int word, rows, columns; /* rows 0: a number or a vector */
} Member;

typedef struct Layout {
    Member member[MOST_MEMBERS];
    int count, words;
    bool failed;
} Layout;

/* --- words of the source ---------------------------------------------------------------------- */

/* The next word, number or sign; comments are skipped. returns what follows it */
static const char *next_token(const char *at, char token[NAME])
{
    for (;;) {
        while (isspace((unsigned char)*at))
            at++;
        if (strncmp(at, "/*", 2) != 0)
            break;
        const char *end = strstr(at + 2, "*/");
        at = end ? end + 2 : at + strlen(at);
    }
    size_t length = 0;
    while (isalnum((unsigned char)at[length]) || at[length] == '_')
        length++;
    if (!length && *at)
        length = 1;
    snprintf(token, NAME, "%.*s", (int)length, at);
    return at + length;
}

/* Where a word stands after another text, in the shaders' sources: "typedef struct "
 * "PhongUniforms". */
static const char *find(const char *before, const char *word, const char *after)
{
    char text[2 * NAME];
    snprintf(text, sizeof text, "%s%s%s", before, word, after);
    for (const PageFile *file = page_files; file->path; file++) {
        const char *at =
            strncmp(file->path, "shaders_c/", 10) == 0 ? strstr(file->begin, text) : NULL;
        if (at)
            return at + strlen(text);
    }
    return NULL;
}

/* A number, or one that an enumeration or a macro names. returns 0 where it is not understood */
static int number_of(const char *token)
{
    char value[NAME];
    if (isdigit((unsigned char)token[0]))
        return atoi(token);
    const char *at = find(" ", token, " = ");
    if (!at)
        at = find("#define ", token, " ");
    if (!at)
        return 0;
    at = next_token(at, value);
    const int number = isdigit((unsigned char)value[0]) ? atoi(value) : number_of(value);
    at = next_token(at, value);
    if (value[0] != '+')
        return number;
    next_token(at, value);
    return number + atoi(value);
}

/* --- structs ---------------------------------------------------------------------------------- */

static void add_struct(Layout *layout, const char *type, const char *prefix, int depth);

static void add_member(Layout *layout, const char *prefix, const char *type, const char *name,
                       const int dimension[2], int depth)
{
    char whole[NAME];
    const bool is_float = strcmp(type, "float") == 0;
    const bool is_signed = strcmp(type, "int") == 0 || strcmp(type, "int32_t") == 0;
    const int rows = dimension[1] ? dimension[0] : 0;
    const int columns = dimension[1] ? dimension[1] : dimension[0] ? dimension[0] : 1;
    snprintf(whole, sizeof whole, "%.40s%.50s", prefix, name);
    if (!is_float && !is_signed && strcmp(type, "uint32_t") != 0) {
        for (int i = 0; i < (dimension[0] ? dimension[0] : 1); i++) {
            char inner[NAME];
            if (dimension[0])
                snprintf(inner, sizeof inner, "%.80s[%d].", whole, i);
            else
                snprintf(inner, sizeof inner, "%.90s.", whole);
            add_struct(layout, type, inner, depth + 1);
        }
        return;
    }
    if (layout->count == MOST_MEMBERS) {
        layout->failed = true;
        return;
    }
    Member *member = &layout->member[layout->count++];
    *member = (Member){ .is_float = is_float,
                        .is_signed = is_signed,
                        .word = layout->words,
                        .rows = rows,
                        .columns = columns };
    memcpy(member->name, whole, sizeof whole);
    layout->words += (rows ? rows : 1) * columns;
}

/* "[4][SIZE]"; of three the first two are one. */
static const char *read_dimensions(Layout *layout, const char *at, int dimension[2])
{
    char token[NAME];
    dimension[0] = dimension[1] = 0;
    for (int i = 0; i < 3; i++) {
        const char *next = next_token(at, token);
        if (token[0] != '[')
            return at;
        next = next_token(next, token);
        const int number = number_of(token);
        layout->failed = layout->failed || number <= 0;
        if (i == 2)
            dimension[0] *= dimension[1];
        dimension[i < 2 ? i : 1] = number;
        at = next_token(next, token);
        layout->failed = layout->failed || token[0] != ']';
    }
    return at;
}

static const char *add_body(Layout *layout, const char *at, const char *prefix, int depth);

/* "struct { float position[3]; } lights[4];" from behind its brace. returns what follows its
 * semicolon */
static const char *add_nameless(Layout *layout, const char *body, const char *prefix, int depth)
{
    char token[NAME], name[NAME], inner[NAME];
    int dimension[2];
    Layout dry = *layout; /* to find its end, where its name is */
    const char *at = add_body(&dry, body, prefix, depth);
    at = next_token(at, name);
    at = read_dimensions(layout, at, dimension);
    for (int i = 0; i < (dimension[0] ? dimension[0] : 1); i++) {
        if (dimension[0])
            snprintf(inner, sizeof inner, "%.40s%.40s[%d].", prefix, name, i);
        else
            snprintf(inner, sizeof inner, "%.40s%.40s.", prefix, name);
        add_body(layout, body, inner, depth);
    }
    return next_token(at, token);
}

/* The members behind a brace. returns what follows the closing one */
static const char *add_body(Layout *layout, const char *at, const char *prefix, int depth)
{
    char token[NAME], of[NAME], name[NAME];
    while (!layout->failed) {
        at = next_token(at, of);
        if (of[0] == '}' || !of[0])
            break;
        if (strcmp(of, "const") == 0)
            at = next_token(at, of);
        if (strcmp(of, "struct") == 0 && *next_token(at, token) && token[0] == '{') {
            at = add_nameless(layout, next_token(at, token), prefix, depth + 1);
            continue;
        }
        do {
            int dimension[2];
            at = next_token(at, name);
            at = read_dimensions(layout, at, dimension);
            add_member(layout, prefix, of, name, dimension, depth);
            at = next_token(at, token);
        } while (token[0] == ',' && !layout->failed);
        layout->failed = layout->failed || token[0] != ';';
    }
    return at;
}

static void add_struct(Layout *layout, const char *type, const char *prefix, int depth)
{
    const char *at = depth < DEPTH ? find("typedef struct ", type, " {") : NULL;
    if (at)
        add_body(layout, at, prefix, depth);
    else
        layout->failed = true;
}

/* What is looked for among a shader's files: a struct of uniforms that has the program's size. */
typedef struct Search {
    const GpProgram *program;
    Layout *layout;
    int found;
    char type[NAME];
} Search;

static bool fits(const GpProgram *program, const char *type, Layout *layout)
{
    *layout = (Layout){ .count = 0 };
    add_struct(layout, type, "", 0);
    return !layout->failed && (size_t)layout->words * 4 == program->uniform_bytes;
}

static bool search_file(void *user, const PageFile *file)
{
    static const char begins[] = "typedef struct ";
    Search *search = user;
    for (const char *at = strstr(file->begin, begins); at; at = strstr(at, begins)) {
        char type[NAME];
        at = next_token(at + strlen(begins), type);
        if (strstr(type, "Uniforms") && strcmp(type, search->type) != 0 &&
            fits(search->program, type, search->layout)) {
            search->found++;
            memcpy(search->type, type, sizeof type);
        }
    }
    return false;
}

/* vertex_shader(vs, Uniforms, ..) names it; behind a macro it is the one struct of the right
 * size. */
static bool find_layout(const GpProgram *program, Layout *layout)
{
    const PageFile *file = source_of_program(program->name);
    char text[2 * NAME], name[NAME];
    snprintf(text, sizeof text, "(%s,", program->name);
    const char *at = file ? strstr(file->begin, text) : NULL;
    if (at) {
        next_token(at + strlen(text), name);
        snprintf(text, sizeof text, "(%s,", name);
        at = strstr(file->begin, text);
        if (at) {
            next_token(at + strlen(text), name);
            if (fits(program, name, layout))
                return true;
        }
    }
    Search search = { .program = program, .layout = layout };
    if (file)
        source_each_include(file, search_file, &search);
    return search.found == 1 && fits(program, search.type, layout);
}

bool uniforms_are_known(const GpProgram *program)
{
    Layout layout = { .count = 0 };
    return program->uniform_bytes == 0 || find_layout(program, &layout);
}

/* --- telling ---------------------------------------------------------------------------------- */

static json_t *word_json(const Member *member, const void *uniforms, int word)
{
    uint32_t bits;
    memcpy(&bits, (const char *)uniforms + 4 * (size_t)word, sizeof bits);
    if (member->is_float)
        return json_number((double)gp_bits_float(bits));
    return json_integer(member->is_signed ? (json_int_t)(int32_t)bits : (json_int_t)bits);
}

static json_t *row_json(const Member *member, const void *uniforms, int word)
{
    json_t *row = json_array();
    for (int i = 0; i < member->columns; i++)
        json_array_append_new(row, word_json(member, uniforms, word + i));
    return row;
}

static json_t *member_json(const Member *member, const void *uniforms)
{
    json_t *value = member->rows ? json_array() : row_json(member, uniforms, member->word);
    for (int i = 0; i < member->rows; i++)
        json_array_append_new(value,
                              row_json(member, uniforms, member->word + i * member->columns));
    return json_pack("{s:s, s:i, s:i, s:o}", "name", member->name, "word", member->word, "words",
                     (member->rows ? member->rows : 1) * member->columns, "value", value);
}

json_t *uniforms_tell(const GpDraw *draw)
{
    json_t *told = json_array();
    Layout layout = { .count = 0 };
    if (!draw->uniforms || !draw->program->uniform_bytes)
        return told;
    if (!find_layout(draw->program, &layout)) {
        layout.count = 1;
        layout.member[0] = (Member){ .name = "uniforms",
                                     .is_float = true,
                                     .columns = (int)(draw->program->uniform_bytes / 4) };
    }
    for (int i = 0; i < layout.count; i++)
        json_array_append_new(told, member_json(&layout.member[i], draw->uniforms));
    return told;
}
