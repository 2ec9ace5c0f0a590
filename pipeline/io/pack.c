#include "pipeline/io/pack.h"

#include <zlib.h>

GpResult gp_pack(const void *bytes, size_t size, GpFile *packed, GpError *error)
{
    uLongf length = compressBound((uLong)size);
    char *memory = gp_alloc_unset(length + 1);
    if (!memory || compress2((Bytef *)memory, &length, bytes, (uLong)size, 6) != Z_OK) {
        gp_free(memory);
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for %zu bytes, packed", size);
    }
    memory[length] = '\0';
    *packed = (GpFile){ memory, length };
    return GP_OK;
}
