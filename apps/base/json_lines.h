/* Where in a JSON text a value stands: the parser keeps no positions. */
#ifndef APPS_BASE_JSON_LINES_H
#define APPS_BASE_JSON_LINES_H

#include <stddef.h>

/* One step from a value to a value inside it: a member, or (key NULL) an element. */
typedef struct JsonStep {
    const char *key;
    size_t index;
} JsonStep;

/* Line, from 1, on which the value at the end of the path begins (members: their key). Where the
 * path leads nowhere, the line of the last value on it that exists.
 * in   text: valid JSON in length bytes, not necessarily terminated; keys written with escapes are
 *      not found */
int json_line(const char *text, size_t length, const JsonStep *path, int steps);

#endif
