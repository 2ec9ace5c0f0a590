#include "apps/base/json.h"

#include "apps/base/text.h"

#include <math.h>

json_t *json_number(double value)
{
    if (isfinite(value))
        return json_real(value);
    return json_string(isnan(value) ? "nan" : value > 0 ? "inf" : "-inf");
}

json_t *json_milliseconds(double value)
{
    return json_number(round(value * 1e6) / 1e6);
}

json_t *json_floats(const float *values, int count)
{
    json_t *array = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(array, json_number((double)values[i]));
    return array;
}

json_t *json_text(const char *text)
{
    if (!text)
        return json_null();
    json_t *string = json_string(text);
    if (string)
        return string;
    Text valid = { .data = NULL };
    text_add_utf8(&valid, text);
    string = valid.failed ? NULL : json_string(valid.data);
    text_free(&valid);
    return string;
}

long long json_whole_of(const json_t *object, const char *key)
{
    return (long long)json_integer_value(json_object_get(object, key));
}

const char *json_text_of(const json_t *object, const char *key)
{
    return json_string_value(json_object_get(object, key));
}
