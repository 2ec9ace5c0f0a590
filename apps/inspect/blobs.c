#include "apps/inspect/blobs.h"

#include "apps/base/page.h"
#include "pipeline/io/pack.h"

#include <stdlib.h>
#include <string.h>

int blobs_add(Blobs *blobs, const void *bytes, size_t size)
{
    GpFile packed;
    if (gp_pack(bytes, size, &packed, NULL)) {
        blobs->failed = true;
        return BLOB_NONE;
    }
    text_add(&blobs->text, "<script type=\"application/octet-stream\" id=\"blob-%u\">",
             blobs->count);
    page_add_base64(&blobs->text, (const unsigned char *)packed.data, packed.size);
    text_add(&blobs->text, "</script>\n");
    gp_file_free(&packed);
    blobs->failed = blobs->failed || blobs->text.failed;
    return (int)blobs->count++;
}

int blobs_add_json(Blobs *blobs, json_t *value)
{
    char *text =
        value ? json_dumps(value, JSON_COMPACT | JSON_ENCODE_ANY | JSON_REAL_PRECISION(9)) : NULL;
    json_decref(value);
    if (!text) {
        blobs->failed = true;
        return BLOB_NONE;
    }
    const int number = blobs_add(blobs, text, strlen(text));
    free(text);
    return number;
}

void blobs_cut(Blobs *blobs, const Blobs *before)
{
    blobs->text.length = before->text.length;
    blobs->count = before->count;
    if (blobs->text.data)
        blobs->text.data[blobs->text.length] = 0;
}

void blobs_free(Blobs *blobs)
{
    text_free(&blobs->text);
    *blobs = (Blobs){ .count = 0 };
}
