/* A strict reader of JSON descriptions: every value is read once, checked, and complained about
 * with its path and line.
 *
 * Reading never stops half way: the first mistake is kept in the reader, later ones are dropped,
 * and every function then returns its fallback. So a loader reads straight on and asks once, at the
 * end or before it needs a value to be right. Nodes are small and live on the stack; an object's or
 * an array's node is what those of its members and elements point to, and must outlive them.
 *
 * The same code tells what it would read: with a reader that describes (reader_describe), values
 * are nowhere, each function writes what it was asked for into a JSON Schema and gives its
 * fallback, and nothing fails. So the schema of a format is what its reader says of itself. Where a
 * reader branches on what is there, both sides hold while it describes: see node_exists and
 * node_is.
 */
#ifndef APPS_BASE_JSON_READER_H
#define APPS_BASE_JSON_READER_H

#include "pipeline/base/base.h"

#include <jansson.h>

typedef struct Reader {
    const char *file; /* for messages */
    char *text;
    size_t length;
    json_t *root;
    GpResult result; /* of the first failure */
    GpError *error;
    json_t *schema; /* describing: what is written; NULL: reading */
} Reader;

typedef struct Node {
    Reader *reader;
    json_t *value; /* NULL: the member is not there */
    const struct Node *parent;
    const char *key; /* NULL: element of an array, or the root */
    size_t index;
    uint64_t read;  /* objects: bit i: the i-th member was asked for */
    json_t *schema; /* describing: of this value, borrowed; NULL: reading */
} Node;

/* Reads and parses a file of at most 4 MB.
 * errors GP_ERROR_IO, GP_ERROR_FORMAT ("x.json:3: ..."), GP_ERROR_MEMORY; in each case there is
 *        nothing to close */
GpResult reader_open(Reader *reader, const char *file, GpError *error);
void reader_close(Reader *reader);

/* A reader that describes.
 * owns   the caller, until reader_close, which leaves the schema: json_decref(reader->schema) */
void reader_describe(Reader *reader);

Node node_root(Reader *reader);

/* Keeps a failure as "FILE:LINE: PATH: message", unless there is one already. */
void node_fail(const Node *node, GpResult result, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* --- objects and arrays ----------------------------------------------------------------------- */

/* A member; its value is NULL where the object has none or is not there itself. A value of another
 * type than object: failure. */
Node node_member(Node *object, const char *key);

/* To be called when all members were asked for: fails on the first one that was not. */
void node_close(Node *object);

/* Number of elements, at most `limit`; 0 where it is not there. */
size_t node_length(Node array, size_t limit);
Node node_element(const Node *array, size_t index);

/* Exactly so many elements; "expected a width and a height" where there are not. */
bool node_has_length(Node array, size_t count, const char *expected);

/* Whether it is there, or is not; describing, both. */
bool node_exists(const Node *node);
bool node_lacks(const Node *node);

/* Whether a value is of a type (JSON_STRING; of numbers JSON_REAL), or is not; describing, both. */
bool node_is(const Node *node, json_type type);
bool node_is_not(const Node *node, json_type type);

bool node_is_false(const Node *node); /* there, and the word false */

/* Fails where the value is not there. */
void node_require(const Node *node);

/* Fails with "expected A or B" unless exactly one of several members of an object is there, whose
 * nodes these are. */
void node_one_of(const Node *const members[], size_t count, const char *expected);

/* --- for the description alone ---------------------------------------------------------------- */

/* All objects of this name are described once. */
void node_define(Node *object, const char *name);

/* Describing: one of several objects; else the object itself. */
Node node_alternative(const Node *object, const char *title);

/* The value's fallback depends on something, or is none. */
void node_without_default(const Node *node);

/* Names that a text may be, among others, each behind a prefix; name(i) is NULL behind the last. */
void node_examples(const Node *node, const char *prefix, const char *(*name)(size_t i));

/* --- values; each gives `fallback` where the value is not there ------------------------------- */

double node_double(Node node, double fallback, double low, double high);
float node_number(Node node, float fallback, float low, float high);
long node_integer(Node node, long fallback, long low, long high);
bool node_bool(Node node, bool fallback);
const char *node_string(Node node, const char *fallback);

/* Index of one of `count` names. */
int node_name(Node node, int fallback, const char *const *names, int count);

/* The same of a member, as an enumeration that counts from 0; it stays as it is where there is
 * none. */
void node_enum(Node *object, const char *key, const char *const *names, int count, void *value);

/* Exactly `count` numbers; `values` stay as they are where there is none. */
void node_doubles(Node node, double *values, int count, double low, double high);
void node_numbers(Node node, float *values, int count, float low, float high);
void node_integers(Node node, long *values, int count, long low, long high);

/* A text made of some of these letters: bit i: letters[i] is in it; 0 where it is not there. */
unsigned node_letters(Node node, const char *letters);

#endif
