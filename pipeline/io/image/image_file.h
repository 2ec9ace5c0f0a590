/* Pictures from and to files: PNG, EXR, PFM, PPM, PGM, TGA (read only).
 *
 * No conversion takes place: samples are those of the file, alpha is not multiplied into colours,
 * no gamma is applied. libpng reads PNG, OpenImageIO does EXR and TGA (it is loaded when such a
 * picture comes, since it brings hundreds of libraries); the rest is done here.
 */
#ifndef GP_IO_IMAGE_FILE_H
#define GP_IO_IMAGE_FILE_H

#include "pipeline/base/pool.h"
#include "pipeline/io/file.h"
#include "pipeline/io/image/image.h"

/* Reads a picture. The format is that of the extension (png, exr, pfm, ppm, pgm, tga, any case)
 * and must be confirmed by the file's first bytes; nothing else is tried.
 * out    image: untouched on failure. PNG: U8 or U16, palettes and fewer bits expanded. EXR: F16 or
 *        F32 (the widest channel decides), the data window, r g b a order. PFM: F32, scale 1 or -1.
 *        PPM, PGM: U8 or U16 by a maximum of 255 or 65535. TGA: U8, the picture's origin applied
 * errors GP_ERROR_IO (file access); GP_ERROR_FORMAT (no such picture, truncated, a size of 0 or
 *        one that the file's bytes cannot hold; with the byte where it is known);
 *        GP_ERROR_UNSUPPORTED (extension; a side over GP_IMAGE_SIDE_MAX or over 4 GiB of samples;
 *        more than 4 channels; a variant that is not read); GP_ERROR_MEMORY
 * owns   the caller frees the image with gp_image_free */
GpResult gp_image_read(const char *path, GpImage *image, GpError *error);

/* Writes a picture in the format of the extension, by gp_file_write: never half a file. The bytes
 * depend on the samples alone; no date, program or machine is noted.
 * in     pool: whose threads deflate a PNG; NULL: the caller alone. No byte depends on it
 *        image: png: U8, U16; exr: F16, F32 (zip); pfm: F32 of 1 or 3 channels; ppm, pgm: U8, U16
 *        of 3 and of 1 channels
 * errors GP_ERROR_INVALID (a size of 0 or over GP_IMAGE_SIDE_MAX; samples or channels that the
 *        format cannot hold); GP_ERROR_UNSUPPORTED (extension); GP_ERROR_IO; GP_ERROR_MEMORY */
GpResult gp_image_write(const char *path, const GpImage *image, GpPool *pool, GpError *error);

/* The same into memory: the bytes that a file of this name would have.
 * errors those of gp_image_write but GP_ERROR_IO; owns: the caller, until gp_file_free */
GpResult gp_image_encode(const char *path, const GpImage *image, GpPool *pool, GpFile *file,
                         GpError *error);

#endif
