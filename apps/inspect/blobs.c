#include "apps/inspect/blobs.h"

#include "apps/base/page.h"
#include "pipeline/io/pack.h"

#include <stdlib.h>
#include <string.h>

/* A block on its way. */
typedef struct Block {
    Blobs *blobs;
    uint32_t number;
    size_t size;
    unsigned char bytes[];
} Block;

static void pack_block(void *context)
{
    Block *block = context;
    Blobs *blobs = block->blobs;
    GpFile packed;
    if (gp_pack(block->bytes, block->size, &packed, NULL)) {
        blobs->unpacked = true;
    } else {
        text_add(&blobs->text, "<script type=\"application/octet-stream\" id=\"blob-%u\">",
                 block->number);
        page_add_base64(&blobs->text, (const unsigned char *)packed.data, packed.size);
        text_add(&blobs->text, "</script>\n");
        gp_file_free(&packed);
    }
    gp_free(block);
}

int blobs_add(Blobs *blobs, const void *bytes, size_t size)
{
    Block *block = gp_alloc_unset(sizeof *block + size);
    if (!block) {
        blobs->failed = true;
        return BLOB_NONE;
    }
    *block = (Block){ .blobs = blobs, .number = blobs->count, .size = size };
    memcpy(block->bytes, bytes, size);
    errands_give(blobs->errands, pack_block, block);
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

BlobsMark blobs_mark(Blobs *blobs)
{
    errands_wait(blobs->errands);
    return (BlobsMark){ blobs->count, blobs->text.length };
}

void blobs_cut(Blobs *blobs, BlobsMark mark)
{
    errands_wait(blobs->errands);
    blobs->text.length = mark.length;
    blobs->count = mark.count;
    if (blobs->text.data)
        blobs->text.data[mark.length] = 0;
}

const char *blobs_text(Blobs *blobs)
{
    errands_wait(blobs->errands);
    return blobs->failed || blobs->unpacked || blobs->text.failed ? NULL : blobs->text.data;
}

void blobs_free(Blobs *blobs)
{
    errands_wait(blobs->errands);
    text_free(&blobs->text);
    *blobs = (Blobs){ .count = 0 };
}
