/* Pictures too large to be in memory: their windows come in order, and go to a file band by
 * band. */
#ifndef APPS_FRAME_STRIPS_H
#define APPS_FRAME_STRIPS_H

#include "pipeline/resources/surface.h"

typedef struct Strips Strips;

/* Whether a file of this name can be written so: .png or .ppm. */
bool strips_can_write(const char *path);

/* Begins a file, of the bytes that picture_write_surface would write of the whole.
 * errors GP_ERROR_IO, GP_ERROR_MEMORY; GP_ERROR_INVALID: the file's name, or a format that it
 *        cannot hold
 * owns   the caller, until strips_end, after a failure too */
GpResult strips_begin(const char *path, GpFormat format, uint32_t width, uint32_t height,
                      Strips **strips, GpError *error);

/* Adds a part of the picture: rows of a band from the left to the right, then the next band.
 * in     texels: of the format, without gaps */
GpResult strips_add(Strips *strips, const void *texels, uint32_t width, uint32_t height,
                    GpError *error);

/* Ends the file, or removes it where it is not whole; sets NULL; NULL is fine.
 * out    hash: that gp_surface_hash would give of the whole */
GpResult strips_end(Strips **strips, bool whole, uint64_t *hash, GpError *error);

#endif
