/* Bytes packed into fewer: zlib's format (RFC 1950), which browsers unpack too. */
#ifndef GP_IO_PACK_H
#define GP_IO_PACK_H

#include "pipeline/io/file.h"

/* Packs bytes. errors GP_ERROR_MEMORY. owns: the caller, until gp_file_free */
GpResult gp_pack(const void *bytes, size_t size, GpFile *packed, GpError *error);

#endif
