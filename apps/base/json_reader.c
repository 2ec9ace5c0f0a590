#include "apps/base/json_reader.h"

#include "apps/base/json_lines.h"
#include "apps/base/json_schema.h"
#include "pipeline/io/file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum {
    MAX_BYTES = 4 << 20,
    FIRST_BYTES = 1 << 14,
    MAX_DEPTH = 16,
    MAX_MEMBERS = 64, /* bits in Node.read */
};

/* --- messages --------------------------------------------------------------------------------- */

/* The steps from the root to a node; returns their number. */
static int path_of(const Node *node, JsonStep steps[MAX_DEPTH])
{
    int depth = 0;
    for (const Node *at = node; at->parent; at = at->parent)
        depth++;
    int place = depth;
    for (const Node *at = node; at->parent; at = at->parent)
        if (--place < MAX_DEPTH)
            steps[place] = (JsonStep){ at->key, at->index };
    return depth < MAX_DEPTH ? depth : MAX_DEPTH;
}

static void write_path(const JsonStep *steps, int count, char *text, size_t size)
{
    size_t used = 0;
    text[0] = '\0';
    for (int i = 0; i < count && used < size; i++) {
        int wrote = steps[i].key
                        ? snprintf(text + used, size - used, "%s%.40s", i ? "." : "", steps[i].key)
                        : snprintf(text + used, size - used, "[%zu]", steps[i].index);
        used += wrote > 0 ? (size_t)wrote : 0;
    }
}

void node_fail(const Node *node, GpResult result, const char *format, ...)
{
    Reader *reader = node->reader;
    if (reader->result || node->schema)
        return;
    JsonStep steps[MAX_DEPTH];
    char path[200], message[300];
    int count = path_of(node, steps);
    write_path(steps, count, path, sizeof path);
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    reader->result = gp_fail(reader->error, result, "%.100s:%d: %s%s%s", reader->file,
                             json_line(reader->text, reader->length, steps, count), path,
                             count ? ": " : "", message);
}

/* --- files ------------------------------------------------------------------------------------ */

/* Reads on into more room; false without memory. */
static bool read_more(Reader *reader, FILE *file, size_t room)
{
    char *text = gp_alloc_unset(room);
    if (!text)
        return false;
    if (reader->length)
        memcpy(text, reader->text, reader->length);
    gp_free(reader->text);
    reader->text = text;
    reader->length += fread(text + reader->length, 1, room - reader->length, file);
    return true;
}

/* All, but for one byte more than is allowed; most files are small. */
static GpResult read_text(Reader *reader, FILE *file)
{
    const char *name = reader->file;
    size_t room = 0;
    do {
        room = room == 0 ? FIRST_BYTES : room * 8 < MAX_BYTES + 1 ? room * 8 : MAX_BYTES + 1;
        if (!read_more(reader, file, room))
            return gp_fail(reader->error, GP_ERROR_MEMORY, "%.200s: no memory", name);
    } while (reader->length == room && room <= MAX_BYTES);
    if (ferror(file))
        return gp_fail(reader->error, gp_result_of_errno(errno), "%.200s: %s", name,
                       strerror(errno));
    if (reader->length > MAX_BYTES)
        return gp_fail(reader->error, GP_ERROR_FORMAT, "%.200s: over %d MB", name, MAX_BYTES >> 20);
    return GP_OK;
}

/* A byte-order mark is allowed before JSON, and nothing that one would see (RFC 8259, section
 * 8.1). */
static void skip_byte_order_mark(Reader *reader)
{
    if (reader->length < 3 || memcmp(reader->text, "\xef\xbb\xbf", 3) != 0)
        return;
    reader->length -= 3;
    memmove(reader->text, reader->text + 3, reader->length);
}

static GpResult parse_text(Reader *reader)
{
    json_error_t problem;
    skip_byte_order_mark(reader);
    reader->root = json_loadb(reader->text, reader->length, JSON_REJECT_DUPLICATES, &problem);
    if (!reader->root && json_error_code(&problem) == json_error_out_of_memory)
        return gp_fail(reader->error, GP_ERROR_MEMORY, "%.200s: no memory", reader->file);
    if (!reader->root)
        return gp_fail(reader->error, GP_ERROR_FORMAT, "%.200s:%d: %s", reader->file, problem.line,
                       problem.text);
    return GP_OK;
}

GpResult reader_open(Reader *reader, const char *path, GpError *error)
{
    *reader = (Reader){ .file = path, .error = error };
    FILE *file = fopen(path, "rb");
    if (!file)
        return gp_fail(error, gp_result_of_errno(errno), "%.200s: %s", path, strerror(errno));
    GpResult result = read_text(reader, file);
    fclose(file);
    if (!result)
        result = parse_text(reader);
    if (result)
        reader_close(reader);
    return result;
}

void reader_close(Reader *reader)
{
    json_decref(reader->root);
    gp_free(reader->text);
    reader->root = NULL;
    reader->text = NULL;
}

void reader_describe(Reader *reader)
{
    *reader = (Reader){ .schema = json_object() };
}

Node node_root(Reader *reader)
{
    return (Node){ .reader = reader, .value = reader->root, .schema = reader->schema };
}

/* --- objects and arrays ----------------------------------------------------------------------- */

/* Whether a value is there and of the right type; a failure where it is there and is not. */
static bool expect(const Node *node, bool right, const char *what)
{
    if (node->value && !right)
        node_fail(node, GP_ERROR_FORMAT, "expected %s", what);
    return node->value && right && !node->reader->result;
}

Node node_member(Node *object, const char *key)
{
    Node member = { .reader = object->reader, .parent = object, .key = key };
    if (object->schema)
        member.schema = schema_member(object->schema, key);
    if (!expect(object, json_is_object(object->value), "an object"))
        return member;
    const char *name;
    json_t *value;
    unsigned place = 0;
    json_object_foreach(object->value, name, value)
    {
        if (place < MAX_MEMBERS && strcmp(name, key) == 0) {
            object->read |= (uint64_t)1 << place;
            member.value = value;
        }
        place++;
    }
    return member;
}

void node_close(Node *object)
{
    const char *name;
    json_t *value;
    unsigned place = 0;
    if (object->schema)
        schema_close(object->schema);
    if (!expect(object, json_is_object(object->value), "an object"))
        return;
    json_object_foreach(object->value, name, value)
    {
        if (place >= MAX_MEMBERS || !(object->read >> place & 1)) {
            Node stray = { .reader = object->reader, .parent = object, .key = name };
            node_fail(&stray, GP_ERROR_FORMAT, "unknown key");
            return;
        }
        place++;
    }
}

size_t node_length(Node array, size_t limit)
{
    if (array.schema) {
        schema_length(array.schema, 0, limit);
        return 1;
    }
    if (!expect(&array, json_is_array(array.value), "an array"))
        return 0;
    size_t length = json_array_size(array.value);
    if (length <= limit)
        return length;
    node_fail(&array, GP_ERROR_FORMAT, "%zu elements, at most %zu", length, limit);
    return 0;
}

Node node_element(const Node *array, size_t index)
{
    return (Node){ .reader = array->reader,
                   .value = json_array_get(array->value, index),
                   .parent = array,
                   .index = index,
                   .schema = array->schema ? schema_element(array->schema) : NULL };
}

bool node_has_length(Node array, size_t count, const char *expected)
{
    if (array.schema)
        schema_length(array.schema, count, count);
    const bool has =
        array.schema || (json_is_array(array.value) && json_array_size(array.value) == count);
    if (!has && array.value)
        node_fail(&array, GP_ERROR_FORMAT, "expected %s", expected);
    return has;
}

bool node_exists(const Node *node)
{
    return node->value || node->schema;
}

bool node_lacks(const Node *node)
{
    return !node->value;
}

static bool has_type(const Node *node, json_type type)
{
    return type == JSON_REAL ? json_is_number(node->value)
                             : node->value && json_typeof(node->value) == type;
}

bool node_is(const Node *node, json_type type)
{
    return node->schema || has_type(node, type);
}

bool node_is_not(const Node *node, json_type type)
{
    return node->schema || !has_type(node, type);
}

bool node_is_false(const Node *node)
{
    if (node->schema)
        schema_false(node->schema);
    return json_is_false(node->value);
}

void node_require(const Node *node)
{
    if (!node->value)
        node_fail(node, GP_ERROR_FORMAT, "missing");
    if (node->schema && node->key)
        schema_require(node->parent->schema, node->key);
}

void node_one_of(const Node *const members[], size_t count, const char *expected)
{
    size_t there = 0;
    for (size_t i = 0; i < count; i++) {
        there += members[i]->value != NULL;
        if (members[i]->schema)
            schema_one_of(members[i]->parent->schema, members[i]->key);
    }
    if (!members[0]->schema && there != 1)
        node_fail(members[0]->parent, GP_ERROR_FORMAT, "expected %s", expected);
}

void node_define(Node *object, const char *name)
{
    if (!object->schema)
        return;
    json_t *root = object->reader->schema;
    if (!json_object_get(root, "definitions"))
        json_object_set_new(root, "definitions", json_object());
    object->schema = schema_define(object->schema, json_object_get(root, "definitions"), name);
}

Node node_alternative(const Node *object, const char *title)
{
    Node one = *object;
    if (one.schema)
        one.schema = schema_alternative(one.schema, title);
    return one;
}

void node_without_default(const Node *node)
{
    if (node->schema)
        schema_without_default(node->schema);
}

void node_examples(const Node *node, const char *prefix, const char *(*name)(size_t i))
{
    if (!node->schema)
        return;
    json_t *list = json_array();
    for (size_t i = 0; name(i); i++)
        json_array_append_new(list, json_sprintf("%s%s", prefix, name(i)));
    json_object_set_new(schema_type(node->schema, "string"), "examples", list);
}

/* --- values ----------------------------------------------------------------------------------- */

double node_double(Node node, double fallback, double low, double high)
{
    double value = json_number_value(node.value);
    if (node.schema)
        schema_number(node.schema, "number", low, high, node.key ? &fallback : NULL);
    if (!node.value || node.reader->result)
        return fallback;
    if (json_is_number(node.value) && value >= low && value <= high)
        return value;
    node_fail(&node, GP_ERROR_FORMAT, "expected a number in [%g, %g]", low, high);
    return fallback;
}

float node_number(Node node, float fallback, float low, float high)
{
    return (float)node_double(node, (double)fallback, (double)low, (double)high);
}

long node_integer(Node node, long fallback, long low, long high)
{
    json_int_t value = json_integer_value(node.value);
    if (node.schema)
        schema_number(node.schema, "integer", (double)low, (double)high,
                      node.key ? &(double){ (double)fallback } : NULL);
    if (!node.value || node.reader->result)
        return fallback;
    if (json_is_integer(node.value) && value >= low && value <= high)
        return (long)value;
    node_fail(&node, GP_ERROR_FORMAT, "expected a whole number in [%ld, %ld]", low, high);
    return fallback;
}

bool node_bool(Node node, bool fallback)
{
    if (node.schema)
        schema_bool(node.schema, &fallback);
    return expect(&node, json_is_boolean(node.value), "true or false") ? json_is_true(node.value)
                                                                       : fallback;
}

const char *node_string(Node node, const char *fallback)
{
    if (node.schema)
        schema_type(node.schema, "string");
    return expect(&node, json_is_string(node.value), "a string") ? json_string_value(node.value)
                                                                 : fallback;
}

int node_name(Node node, int fallback, const char *const *names, int count)
{
    const char *text = node_string(node, NULL);
    if (node.schema)
        schema_names(node.schema, names, count, node.key ? fallback : -1);
    if (!text)
        return fallback;
    for (int i = 0; i < count; i++)
        if (strcmp(text, names[i]) == 0)
            return i;
    char list[240] = "";
    size_t used = 0;
    for (int i = 0; i < count && used < sizeof list; i++)
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", names[i]);
    node_fail(&node, GP_ERROR_FORMAT, "expected one of %s", list);
    return fallback;
}

void node_enum(Node *object, const char *key, const char *const *names, int count, void *value)
{
    unsigned *number = value;
    *number = (unsigned)node_name(node_member(object, key), (int)*number, names, count);
}

void node_doubles(Node node, double *values, int count, double low, double high)
{
    if (node.schema)
        schema_numbers(node.schema, "number", count, low, high, node.key ? values : NULL);
    if (!node.value || node.reader->result)
        return;
    if (!json_is_array(node.value) || json_array_size(node.value) != (size_t)count) {
        node_fail(&node, GP_ERROR_FORMAT, "expected %d numbers in [%g, %g]", count, low, high);
        return;
    }
    for (int i = 0; i < count; i++)
        values[i] = node_double(node_element(&node, (size_t)i), values[i], low, high);
}

void node_numbers(Node node, float *values, int count, float low, float high)
{
    double wide[16];
    GP_ASSERT(count <= 16);
    for (int i = 0; i < count; i++)
        wide[i] = (double)values[i];
    node_doubles(node, wide, count, (double)low, (double)high);
    for (int i = 0; i < count; i++)
        values[i] = (float)wide[i];
}

void node_integers(Node node, long *values, int count, long low, long high)
{
    char expected[80];
    snprintf(expected, sizeof expected, "%d whole numbers in [%ld, %ld]", count, low, high);
    if (node.schema) {
        double wide[16];
        GP_ASSERT(count <= 16);
        for (int i = 0; i < count; i++)
            wide[i] = (double)values[i];
        schema_numbers(node.schema, "integer", count, (double)low, (double)high, wide);
    } else if (node_has_length(node, (size_t)count, expected)) {
        for (int i = 0; i < count; i++)
            values[i] = node_integer(node_element(&node, (size_t)i), values[i], low, high);
    }
}

unsigned node_letters(Node node, const char *letters)
{
    unsigned bits = 0;
    const char *text = node_string(node, "");
    if (node.schema)
        json_object_set_new(schema_type(node.schema, "string"), "pattern",
                            json_sprintf("^[%s]*$", letters));
    for (const char *at = text; *at; at++) {
        const char *letter = strchr(letters, *at);
        if (letter)
            bits |= 1u << (letter - letters);
        else
            node_fail(&node, GP_ERROR_FORMAT, "expected letters out of %s", letters);
    }
    return bits;
}
