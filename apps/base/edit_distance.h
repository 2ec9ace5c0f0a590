/* How far a word is from another: what a typing error makes of it. */
#ifndef APPS_BASE_EDIT_DISTANCE_H
#define APPS_BASE_EDIT_DISTANCE_H

#include <stddef.h>

/* Number of single-letter edits (insert, delete, replace) from a to b: Levenshtein's distance, one
 * row of the table at a time. Words of over 31 letters are no typing errors: they are simply far. */
size_t edit_distance(const char *a, const char *b);

#endif
