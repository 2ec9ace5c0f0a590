/* Bytes as files hold them: in either byte order, and as many as come. */
#ifndef GP_IO_BYTES_H
#define GP_IO_BYTES_H

#include "pipeline/base/base.h"

#include <string.h>

enum { GP_BIG_ENDIAN_MACHINE = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__ };

/* Unsigned integers of size 1, 2, 4 or 8 bytes at any alignment. In line, as compilers make one
 * move of those of a stated size: the bytes are the first of eight. */
static inline uint64_t gp_load_little(const void *bytes, size_t size)
{
    uint64_t first = 0;
    memcpy(&first, bytes, size);
    return GP_BIG_ENDIAN_MACHINE ? __builtin_bswap64(first) : first;
}

static inline uint64_t gp_load_big(const void *bytes, size_t size)
{
    uint64_t first = 0;
    memcpy(&first, bytes, size);
    return (GP_BIG_ENDIAN_MACHINE ? first : __builtin_bswap64(first)) >> (64 - 8 * size);
}

/* Copies samples of `size` bytes from a byte order to the machine's, or back. in and out do not
 * overlap. */
void gp_copy_samples(void *out, const void *in, size_t count, size_t size, bool is_big_endian);

/* Bytes that grow. Start with all zero; data is freed with gp_free. After a failed allocation
 * nothing is kept. */
typedef struct GpBytes {
    char *data;
    size_t size, room;
    bool failed;
} GpBytes;

/* Makes room for `size` more bytes; false where there is none. */
bool gp_bytes_reserve(GpBytes *bytes, size_t size);

static inline void gp_bytes_append(GpBytes *bytes, const void *data, size_t size)
{
    if (size > bytes->room - bytes->size && !gp_bytes_reserve(bytes, size))
        return;
    memcpy(bytes->data + bytes->size, data, size);
    bytes->size += size;
}

static inline void gp_bytes_append_zeros(GpBytes *bytes, size_t size)
{
    if (size == 0 || !gp_bytes_reserve(bytes, size))
        return;
    memset(bytes->data + bytes->size, 0, size);
    bytes->size += size;
}

#endif
