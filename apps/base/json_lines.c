#include "apps/base/json_lines.h"

#include <stdbool.h>
#include <string.h>

typedef struct Cursor {
    const char *at, *end;
} Cursor;

/* Skips what stands between tokens: white space, and the commas and colons that a valid text has in
 * the right places anyway. */
static void skip_space(Cursor *c)
{
    while (c->at < c->end && strchr(" \t\r\n,:", *c->at))
        c->at++;
}

/* Skips a string; at its opening quote. */
static void skip_string(Cursor *c)
{
    c->at++;
    while (c->at < c->end && *c->at != '"')
        c->at += *c->at == '\\' && c->end - c->at > 1 ? 2 : 1;
    if (c->at < c->end)
        c->at++;
}

/* Skips a whole value, however deep, without recursion. */
static void skip_value(Cursor *c)
{
    int depth = 0;
    do {
        skip_space(c);
        if (c->at >= c->end)
            return;
        char first = *c->at;
        if (first == '"') {
            skip_string(c);
        } else if (strchr("[{", first)) {
            depth++;
            c->at++;
        } else if (strchr("]}", first)) {
            depth--;
            c->at++;
        } else {
            while (c->at < c->end && !strchr(" \t\r\n,:[]{}\"", *c->at))
                c->at++;
        }
    } while (depth > 0);
}

/* Whether the key at the cursor is `key`; moves past it. */
static bool take_key(Cursor *c, const char *key)
{
    const char *begin = c->at + 1;
    skip_string(c);
    size_t length = (size_t)(c->at - begin) - 1;
    return strlen(key) == length && memcmp(begin, key, length) == 0;
}

/* Moves from a value to the member or element inside it. On success *mark is where it begins. */
static bool enter(Cursor *c, const JsonStep *step, const char **mark)
{
    skip_space(c);
    if (c->at >= c->end || *c->at != (step->key ? '{' : '['))
        return false;
    c->at++;
    for (size_t index = 0;; index++) {
        skip_space(c);
        if (c->at >= c->end || strchr("]}", *c->at))
            return false;
        *mark = c->at;
        if (step->key ? take_key(c, step->key) : index == step->index)
            return true;
        skip_value(c);
    }
}

int json_line(const char *text, size_t length, const JsonStep *path, int steps)
{
    Cursor cursor = { text, text + length };
    skip_space(&cursor);
    const char *found = cursor.at;
    for (int i = 0; i < steps; i++) {
        const char *mark;
        if (!enter(&cursor, &path[i], &mark))
            break;
        found = mark;
    }
    int line = 1;
    for (const char *at = text; at < found; at++)
        line += *at == '\n';
    return line;
}
