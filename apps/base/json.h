/* Small additions to jansson: numbers that may be no numbers, and printing a result. */
#ifndef APPS_BASE_JSON_H
#define APPS_BASE_JSON_H

#include <jansson.h>

/* A number; JSON has no NaN or infinity, which become the strings "nan", "inf" and "-inf". */
json_t *json_number(double value);

/* An array of count floats. */
json_t *json_floats(const float *values, int count);

/* A string, or null for NULL. */
json_t *json_text(const char *text);

/* Prints the value and a line end to stdout and releases it. Nine digits: enough to restore every
 * float exactly. Keys come in the order in which they were set. */
void json_print(json_t *value);

#endif
