/* Small additions to jansson: numbers that may be no numbers. */
#ifndef APPS_BASE_JSON_H
#define APPS_BASE_JSON_H

#include <jansson.h>

/* A number; JSON has no NaN or infinity, which become the strings "nan", "inf" and "-inf". */
json_t *json_number(double value);

/* Milliseconds as a clock knows them, to the nanosecond. */
json_t *json_milliseconds(double value);

/* An array of count floats. */
json_t *json_floats(const float *values, int count);

/* A string, or null for NULL; what is no UTF-8, as names of files may be, is U+FFFD in it. */
json_t *json_text(const char *text);

/* Members that are there. */
long long json_whole_of(const json_t *object, const char *key);
const char *json_text_of(const json_t *object, const char *key);

#endif
