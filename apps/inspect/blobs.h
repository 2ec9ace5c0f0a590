/* Blocks of bytes inside a page: packed by zlib, as text by base64. Scripts unpack one when it is
 * asked for, by its number. A second thread packs them. */
#ifndef APPS_INSPECT_BLOBS_H
#define APPS_INSPECT_BLOBS_H

#include "apps/base/errands.h"
#include "apps/base/text.h"

#include <jansson.h>

/* A zeroed one is empty, and packs at once; a second thread is given with `errands`. */
typedef struct Blobs {
    Errands *errands; /* borrowed. What else is given there comes in between */
    uint32_t count;
    bool failed;   /* no memory */
    Text text;     /* the errands': the elements, as they stand in the page */
    bool unpacked; /* the errands': no memory for some */
} Blobs;

enum { BLOB_NONE = -1 };

/* Adds a block. returns its number, or BLOB_NONE where memory is short */
int blobs_add(Blobs *blobs, const void *bytes, size_t size);

/* Adds a value as JSON, floats with nine digits, and releases it. returns as blobs_add */
int blobs_add_json(Blobs *blobs, json_t *value);

/* How much is there by now. */
typedef struct BlobsMark {
    uint32_t count;
    size_t length; /* of the text */
} BlobsMark;

/* Waits until all that was added is packed. */
BlobsMark blobs_mark(Blobs *blobs);

/* Takes away what was added since. */
void blobs_cut(Blobs *blobs, BlobsMark mark);

/* All elements as text, terminated; NULL where memory was short. Waits. Borrowed until the next
 * change */
const char *blobs_text(Blobs *blobs);

void blobs_free(Blobs *blobs); /* waits, and zeroes it */

#endif
