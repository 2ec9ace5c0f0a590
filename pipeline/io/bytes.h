/* Bytes as files hold them: in either byte order, and as many as come. */
#ifndef GP_IO_BYTES_H
#define GP_IO_BYTES_H

#include "pipeline/base/base.h"

#include <string.h>

/* Unsigned integers of size 1, 2, 4 or 8 bytes at any alignment. */
uint64_t gp_load_little(const void *bytes, size_t size);
uint64_t gp_load_big(const void *bytes, size_t size);

/* Copies samples of `size` bytes from a byte order to the machine's, or back. in and out do not
 * overlap. */
void gp_copy_samples(void *out, const void *in, size_t count, size_t size, bool is_big_endian);

/* Bytes that grow. Start with all zero; data is freed with gp_free. After a failed allocation nothing
 * is kept. */
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

#endif
