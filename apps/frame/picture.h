/* Pictures: floats between files and the comparison, and a surface's way to a file. */
#ifndef APPS_FRAME_PICTURE_H
#define APPS_FRAME_PICTURE_H

#include "pipeline/base/pool.h"
#include "pipeline/io/file.h"
#include "pipeline/io/image/image.h"
#include "pipeline/resources/surface.h"

/* Floats, row 0 at the top; codes are divided by their largest. Owns values. */
typedef struct Picture {
    uint32_t width, height;
    int channels;  /* 1 grey, 2 grey and alpha, 3 red green blue, 4 with alpha */
    float *values; /* [height][width][channels] */
} Picture;

/* Samples as floats. errors GP_ERROR_MEMORY; owns: the caller, until picture_free */
GpResult picture_of_image(const GpImage *image, Picture *picture, GpError *error);

/* Reads a picture file. Errors: GP_ERROR_IO, GP_ERROR_FORMAT, GP_ERROR_MEMORY, with the path.
 * Owns: the caller, until picture_free. */
GpResult picture_read(const char *path, Picture *picture, GpError *error);
void picture_free(Picture *picture); /* a zeroed picture is fine; zeroes it */

/* Gives a picture other channels: grey is repeated, a missing alpha is 1, one too many is left out.
 * errors GP_ERROR_MEMORY */
GpResult picture_set_channels(Picture *picture, int channels, GpError *error);

/* Whether a path ends as pictures' do: .png, .exr, .pfm or .ppm. */
bool picture_has_extension(const char *path);

/* Whether a file of this name could be written, as far as its name tells: a known extension, no
 * directory. Errors: GP_ERROR_INVALID. */
GpResult picture_check_path(const char *path, GpError *error);

/* Writes a picture in the format of the path's extension: eight bits a channel, clamped to [0, 1],
 * in PNG and PPM; PPM and PFM lose alpha; never leaves half a file.
 * in     pool: as gp_image_write's
 * errors GP_ERROR_INVALID (extension), GP_ERROR_IO, GP_ERROR_MEMORY */
GpResult picture_write(const char *path, const Picture *picture, GpPool *pool, GpError *error);

/* A picture as the bytes of a PNG file, eight bits a channel, clamped to [0, 1].
 * errors GP_ERROR_INVALID (size), GP_ERROR_MEMORY; owns: the caller, until gp_file_free */
GpResult picture_encode_png(const Picture *picture, GpFile *file, GpError *error);

/* --- surfaces --------------------------------------------------------------------------------- */

/* Reads a picture file into a surface that loses nothing: A8R8G8B8, A8R8G8B8_SRGB (srgb: the bytes
 * stay those of the file), A16B16G16R16F or A32B32G32R32F; grey is repeated, a missing alpha is 1.
 * in   mips: with all levels, averaged
 * errors those of picture_read; owns: the caller destroys the surface */
GpResult picture_read_surface(const char *path, bool srgb, bool mips, GpSurface **surface,
                              GpError *error);

/* The samples that a file of this name would have of a part of a surface, alpha included: rounded
 * as that file rounds.
 * errors GP_ERROR_MEMORY; owns: the caller, until gp_image_free */
GpResult picture_samples(const char *path, const GpSurface *surface, const GpRect *part,
                         GpImage *image, GpError *error);

/* Writes a surface likewise. Eight-bit targets keep their codes; float targets go to EXR and PFM as
 * they are; depth is grey: 16 bits in PNG and PPM, else floats in [0, 1]; opaque: alpha is left
 * out.
 * in     pool: as gp_image_write's
 * errors as picture_write's */
GpResult picture_write_surface(const char *path, const GpSurface *surface, bool opaque,
                               GpPool *pool, GpError *error);

/* The alpha of a surface that has one as a picture of its own, in grey. errors as above */
GpResult picture_write_alpha(const char *path, const GpSurface *surface, GpPool *pool,
                             GpError *error);

enum { PICTURE_HASH_LINE = 96 };

/* What the program says of a picture: "hash A8R8G8B8 64x48 0123456789abcdef", by
 * gp_surface_hash. */
void picture_hash_line(const GpSurface *surface, char line[PICTURE_HASH_LINE]);

#endif
