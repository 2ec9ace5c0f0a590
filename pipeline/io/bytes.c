#include "pipeline/io/bytes.h"

uint64_t gp_load_little(const void *bytes, size_t size)
{
    const unsigned char *at = bytes;
    uint64_t value = 0;
    for (size_t i = size; i-- > 0;)
        value = value << 8 | at[i];
    return value;
}

uint64_t gp_load_big(const void *bytes, size_t size)
{
    const unsigned char *at = bytes;
    uint64_t value = 0;
    for (size_t i = 0; i < size; i++)
        value = value << 8 | at[i];
    return value;
}

void gp_copy_samples(void *out, const void *in, size_t count, size_t size, bool is_big_endian)
{
    const bool machine_is_big_endian = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
    if (size == 1 || is_big_endian == machine_is_big_endian) {
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
    char *grown = gp_alloc(room, 1);
    if (grown && bytes->size > 0)
        memcpy(grown, bytes->data, bytes->size);
    gp_free(bytes->data);
    *bytes = grown ? (GpBytes){ .data = grown, .size = bytes->size, .room = room }
                   : (GpBytes){ .failed = true };
    return grown != NULL;
}
