/* A JSON Schema (draft 7) that grows while a reader tells what it would read: each function adds to
 * one value's schema, and finds there what was said before.
 *
 * All schemas are borrowed from the one that they are part of. Memory that runs short is the root's
 * failure: it lacks something then. */
#ifndef APPS_BASE_JSON_SCHEMA_H
#define APPS_BASE_JSON_SCHEMA_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The part that is for values of one type ("object"); where there is another already, both become
 * alternatives. */
json_t *schema_type(json_t *schema, const char *type);

/* One of several objects, known by its title. */
json_t *schema_alternative(json_t *schema, const char *title);

/* Moves an object's schema to the definitions, where all that have this name share it. */
json_t *schema_define(json_t *schema, json_t *definitions, const char *name);

json_t *schema_member(json_t *schema, const char *key);
void schema_close(json_t *schema); /* an object: no other members */
void schema_require(json_t *schema, const char *key);
void schema_one_of(json_t *schema,
                   const char *key); /* exactly one of the members that it is asked for */

json_t *schema_element(json_t *schema);
void schema_length(json_t *schema, size_t least, size_t most);

/* A number or ("integer") whole number; a default outside the range is none. */
void schema_number(json_t *schema, const char *type, double low, double high,
                   const double *fallback);
/* So many of them. fallback: NULL: none */
void schema_numbers(json_t *schema, const char *type, int count, double low, double high,
                    const double *fallback);
void schema_names(json_t *schema, const char *const *names, int count, int fallback);
void schema_bool(json_t *schema, const bool *fallback);
void schema_false(json_t *schema); /* the word false */

/* Takes the default away again: it depends on something. */
void schema_without_default(json_t *schema);

#endif
