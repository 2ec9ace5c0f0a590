#include "pipeline/io/bytes.h"

void gp_copy_samples(void *out, const void *in, size_t count, size_t size, bool is_big_endian)
{
    if (size == 1 || is_big_endian == GP_BIG_ENDIAN_MACHINE) {
        memcpy(out, in, count * size);
        return;
    }
    const char *from = in;
    char *to = out;
    for (size_t i = 0; i < count; i++, from += size, to += size)
        for (size_t byte = 0; byte < size; byte++)
            to[byte] = from[size - 1 - byte];
}

bool gp_bytes_reserve(GpBytes *bytes, size_t size)
{
    if (bytes->failed || size <= bytes->room - bytes->size)
        return !bytes->failed;
    size_t room = 2 * bytes->room + size + 4096;
    char *grown = gp_alloc_unset(room);
    if (grown && bytes->size > 0)
        memcpy(grown, bytes->data, bytes->size);
    gp_free(bytes->data);
    *bytes = grown ? (GpBytes){ .data = grown, .size = bytes->size, .room = room }
                   : (GpBytes){ .failed = true };
    return grown != NULL;
}
