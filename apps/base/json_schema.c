#include "apps/base/json_schema.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A member that is an object or array, made where there is none. */
static json_t *part(json_t *schema, const char *key, json_t *(*make)(void))
{
    if (!json_object_get(schema, key))
        json_object_set_new(schema, key, make());
    return json_object_get(schema, key);
}

/* The choice among alternatives in which a member is this text; appended where there is none. */
static json_t *choice(json_t *choices, const char *key, const char *text)
{
    size_t i;
    json_t *one;
    json_array_foreach(choices, i, one)
    {
        const char *has = json_string_value(json_object_get(one, key));
        if (has && strcmp(has, text) == 0)
            return one;
    }
    json_array_append_new(choices, json_pack("{s:s}", key, text));
    return json_array_get(choices, json_array_size(choices) - 1);
}

json_t *schema_type(json_t *schema, const char *type)
{
    const char *own = json_string_value(json_object_get(schema, "type"));
    json_t *choices = json_object_get(schema, "anyOf");
    if (!own && !choices)
        json_object_set_new(schema, "type", json_string(type));
    if (!choices && (!own || strcmp(own, type) == 0))
        return schema;
    if (!choices) {
        json_t *first = json_copy(schema);
        json_object_clear(schema);
        choices = part(schema, "anyOf", json_array);
        json_array_append_new(choices, first);
    }
    return choice(choices, "type", type);
}

json_t *schema_alternative(json_t *schema, const char *title)
{
    json_t *one = choice(part(schema, "anyOf", json_array), "title", title);
    return schema_type(one, "object");
}

json_t *schema_define(json_t *schema, json_t *definitions, const char *name)
{
    char path[80];
    snprintf(path, sizeof path, "#/definitions/%s", name);
    json_object_set_new(schema_type(schema, "object"), "$ref", json_string(path));
    return part(definitions, name, json_object);
}

/* --- objects and arrays ----------------------------------------------------------------------- */

json_t *schema_member(json_t *schema, const char *key)
{
    json_t *object = schema_type(schema, "object");
    return part(part(object, "properties", json_object), key, json_object);
}

void schema_close(json_t *schema)
{
    json_object_set_new(schema_type(schema, "object"), "additionalProperties", json_false());
}

void schema_require(json_t *schema, const char *key)
{
    json_t *required = part(schema_type(schema, "object"), "required", json_array), *one;
    size_t i;
    json_array_foreach(required, i, one) if (strcmp(json_string_value(one), key) == 0) return;
    json_array_append_new(required, json_string(key));
}

void schema_one_of(json_t *schema, const char *key)
{
    json_t *choices = part(schema_type(schema, "object"), "oneOf", json_array), *one;
    size_t i;
    json_array_foreach(choices, i, one)
    {
        const json_t *required = json_object_get(one, "required");
        if (strcmp(json_string_value(json_array_get(required, 0)), key) == 0)
            return;
    }
    json_array_append_new(choices, json_pack("{s:[s]}", "required", key));
    schema_without_default(schema_member(schema, key));
}

json_t *schema_element(json_t *schema)
{
    return part(schema_type(schema, "array"), "items", json_object);
}

void schema_length(json_t *schema, size_t least, size_t most)
{
    json_t *array = schema_type(schema, "array");
    if (least > 0)
        json_object_set_new(array, "minItems", json_integer((json_int_t)least));
    if (most < SIZE_MAX)
        json_object_set_new(array, "maxItems", json_integer((json_int_t)most));
}

/* --- values ----------------------------------------------------------------------------------- */

/* As it was written: a float has seven digits. */
static json_t *number(double value)
{
    char text[32];
    if (value == rint(value) && fabs(value) < 1e15)
        return json_integer((json_int_t)value);
    snprintf(text, sizeof text, "%.7g", value);
    return json_real(strtod(text, NULL));
}

void schema_number(json_t *schema, const char *type, double low, double high,
                   const double *fallback)
{
    json_t *own = schema_type(schema, type);
    json_object_set_new(own, "minimum", number(low));
    json_object_set_new(own, "maximum", number(high));
    if (fallback && *fallback >= low && *fallback <= high)
        json_object_set_new(own, "default", number(*fallback));
}

void schema_numbers(json_t *schema, const char *type, int count, double low, double high,
                    const double *fallback)
{
    json_t *values = json_array();
    bool inside = fallback != NULL;
    for (int i = 0; i < count && inside; i++) {
        json_array_append_new(values, number(fallback[i]));
        inside = fallback[i] >= low && fallback[i] <= high;
    }
    schema_length(schema, (size_t)count, (size_t)count);
    schema_number(schema_element(schema), type, low, high, NULL);
    if (inside)
        json_object_set(schema_type(schema, "array"), "default", values);
    json_decref(values);
}

void schema_names(json_t *schema, const char *const *names, int count, int fallback)
{
    json_t *own = schema_type(schema, "string"), *list = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(list, json_string(names[i]));
    json_object_set_new(own, "enum", list);
    if (fallback >= 0)
        json_object_set_new(own, "default", json_string(names[fallback]));
}

void schema_bool(json_t *schema, const bool *fallback)
{
    json_t *own = schema_type(schema, "boolean");
    if (fallback)
        json_object_set_new(own, "default", json_boolean(*fallback));
}

void schema_false(json_t *schema)
{
    json_object_set_new(schema_type(schema, "boolean"), "const", json_false());
}

void schema_without_default(json_t *schema)
{
    size_t i;
    json_t *one;
    json_object_del(schema, "default");
    json_array_foreach(json_object_get(schema, "anyOf"), i, one) json_object_del(one, "default");
}
