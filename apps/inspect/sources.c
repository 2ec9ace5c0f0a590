#include "apps/inspect/sources.h"

#include <stdio.h>
#include <string.h>

const PageFile *source_find(const char *path)
{
    for (const PageFile *file = page_files; file->path; file++)
        if (strcmp(file->path, path) == 0)
            return file;
    return NULL;
}

/* Where a line ends but for its comment and white space; its first character where it is nothing
 * else. */
static const char *code_end(const char *begin, const char *end)
{
    for (const char *at = begin; at + 1 < end; at++)
        if (at[0] == '/' && (at[1] == '*' || at[1] == '/'))
            end = at;
    while (end > begin && strchr(" \t\n\\", end[-1]))
        end--;
    return end;
}

int source_statement_line(const PageFile *file, int line)
{
    if (!file)
        return line;
    const char *begin = file->begin;
    for (int i = 1; i < line && begin; i++)
        begin = strchr(begin, '\n') ? strchr(begin, '\n') + 1 : NULL;
    while (begin && begin > file->begin && line > 1) {
        const char *before = begin - 1; /* the line above, which ends here */
        while (before > file->begin && before[-1] != '\n')
            before--;
        const char *end = code_end(before, begin - 1);
        if (end == before || strchr(";{}:", end[-1]))
            break;
        begin = before;
        line--;
    }
    return line;
}

/* Whether a header declares a program: "extern const GpProgram one, two;" */
static bool declares(const PageFile *header, const char *program)
{
    static const char words[] = "extern const GpProgram ";
    const size_t length = strlen(program);
    for (const char *at = strstr(header->begin, words); at; at = strstr(at, words)) {
        const char *end = strchr(at, ';');
        for (at += strlen(words); at && at < end;
             at = strpbrk(at, " ,;"), at += at ? strspn(at, " ,\n") : 0)
            if (strncmp(at, program, length) == 0 && strchr(" ,;[", at[length]))
                return true;
            else if (*at == ';')
                break;
    }
    return false;
}

/* Programs that macros make are in the file beside the header that declares them. */
static const PageFile *beside_header(const char *program)
{
    for (const PageFile *file = page_files; file->path; file++) {
        char path[256];
        const int stem = (int)strlen(file->path) - 2;
        if (strcmp(file->path + stem, ".h") != 0 || !declares(file, program))
            continue;
        snprintf(path, sizeof path, "%.*s.c", stem, file->path);
        return source_find(path);
    }
    return NULL;
}

const PageFile *source_of_program(const char *program)
{
    char text[128];
    snprintf(text, sizeof text, "program(%s,", program);
    for (const PageFile *file = page_files; file->path; file++)
        if (strncmp(file->path, "shaders_c/", 10) == 0 && strstr(file->begin, text))
            return file;
    return beside_header(program);
}

bool source_each_include(const PageFile *file, bool (*visit)(void *user, const PageFile *file),
                         void *user)
{
    static const char include[] = "#include \"";
    if (visit(user, file))
        return true;
    for (const char *at = strstr(file->begin, include); at; at = strstr(at, include)) {
        char path[256];
        at += strlen(include);
        snprintf(path, sizeof path, "%.*s", (int)strcspn(at, "\""), at);
        const PageFile *included = source_find(path);
        if (included && source_each_include(included, visit, user))
            return true;
    }
    return false;
}

static bool add_one(void *user, const PageFile *file)
{
    json_t *sources = user;
    if (!json_object_get(sources, file->path))
        json_object_set_new(sources, file->path, json_stringn(file->begin, page_file_size(file)));
    return false;
}

static void add(json_t *sources, const PageFile *file)
{
    if (!json_object_get(sources, file->path))
        source_each_include(file, add_one, sources);
}

json_t *sources_tell(const GpList *list)
{
    json_t *sources = json_object();
    for (const PageFile *file = page_files; file->path; file++)
        if (strncmp(file->path, "pipeline/", 9) == 0)
            add(sources, file);
    for (uint32_t p = 0; p < list->pass_count; p++)
        for (uint32_t i = 0; i < list->passes[p].draw_count; i++) {
            const GpProgram *program = list->passes[p].draws[i].program;
            const bool again = i && program == list->passes[p].draws[i - 1].program;
            const PageFile *file = again ? NULL : source_of_program(program->name);
            if (file)
                add(sources, file);
        }
    return sources;
}

json_t *sources_of_programs(const GpList *list)
{
    json_t *programs = json_object();
    for (uint32_t p = 0; p < list->pass_count; p++)
        for (uint32_t i = 0; i < list->passes[p].draw_count; i++) {
            const char *name = list->passes[p].draws[i].program->name;
            const PageFile *file = json_object_get(programs, name) ? NULL : source_of_program(name);
            if (file)
                json_object_set_new(programs, name, json_string(file->path));
        }
    return programs;
}
