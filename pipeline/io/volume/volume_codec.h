/* What the readers and writers of volumes share. Private to pipeline/io. */
#ifndef GP_IO_VOLUME_CODEC_H
#define GP_IO_VOLUME_CODEC_H

#include "pipeline/io/bytes.h"
#include "pipeline/io/file.h"
#include "pipeline/io/volume/volume.h"

/* A volume's file, and what is known of it before its samples are read. */
typedef struct GpVolumeSource {
    const char *path;
    GpFile file;
    size_t body; /* where the samples begin, compressed or not */
    bool is_gzip, is_big_endian;
    GpVolume volume; /* without data */
} GpVolumeSource;

/* Fill body, is_gzip, is_big_endian and volume. errors those of gp_volume_read */
GpResult gp_volume_parse_nrrd(GpVolumeSource *source,
                              GpError *error); /* changes the header's text */
GpResult gp_volume_parse_raw(GpVolumeSource *source, GpError *error); /* reads the .json */
GpResult gp_volume_parse_bits(GpVolumeSource *source, GpError *error);

/* The type of a name such as "uint8", "unsigned char" or "float".
 * returns whether there is one; *type is untouched where there is none */
bool gp_volume_type_of(const char *name, GpVolumeType *type);

/* For messages about types that are none of them. */
#define GP_VOLUME_TYPES "uint8, uint16, int16 or float"

/* Makes the bytes of an NRRD file. owns: the caller, file->data */
GpResult gp_volume_encode_nrrd(const char *path, const GpVolume *volume, GpFile *file,
                               GpError *error);

/* --- gzip ------------------------------------------------------------------------------------- */

/* Unpacks the source from its body on: exactly `size` bytes.
 * errors GP_ERROR_FORMAT: fewer, more, or damaged; GP_ERROR_MEMORY */
GpResult gp_gzip_unpack(const GpVolumeSource *source, void *data, size_t size, GpError *error);

/* Bytes that are packed piece by piece, behind a header that is not. */
typedef struct GpGzip {
    void *stream;  /* zlib's */
    GpBytes bytes; /* so far; the caller's to free */
} GpGzip;

/* in     header: copied. errors GP_ERROR_MEMORY */
GpResult gp_gzip_begin(GpGzip *gzip, const void *header, size_t size);

/* Packs some more; is_last: and ends.
 * errors GP_ERROR_MEMORY */
GpResult gp_gzip_add(GpGzip *gzip, const void *data, size_t size, bool is_last);

/* Frees what packing needed, not the bytes. */
void gp_gzip_end(GpGzip *gzip);

#endif
