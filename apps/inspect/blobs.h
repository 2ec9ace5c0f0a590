/* Blocks of bytes inside a page: packed by zlib, as text by base64. Scripts unpack one when it is asked
 * for, by its number. */
#ifndef APPS_INSPECT_BLOBS_H
#define APPS_INSPECT_BLOBS_H

#include "apps/base/text.h"

#include <jansson.h>

/* A zeroed one is empty. */
typedef struct Blobs {
    Text text; /* the elements, as they stand in the page */
    uint32_t count;
    bool failed; /* no memory */
} Blobs;

enum { BLOB_NONE = -1 };

/* Adds a block. returns its number, or BLOB_NONE where memory is short */
int blobs_add(Blobs *blobs, const void *bytes, size_t size);

/* Adds a value as JSON, floats with nine digits, and releases it. returns as blobs_add */
int blobs_add_json(Blobs *blobs, json_t *value);

/* Takes away what was added since a copy of them was made. */
void blobs_cut(Blobs *blobs, const Blobs *before);

void blobs_free(Blobs *blobs); /* zeroes it */

#endif
