/* Volumes from and to files: NRRD, plain samples with a JSON beside them, and bits. */
#ifndef GP_IO_VOLUME_FILE_H
#define GP_IO_VOLUME_FILE_H

#include "pipeline/io/volume/volume.h"

/* Reads a volume; its name's end tells what it is.
 *   .nrrd          three dimensions, with its data behind the header, raw or gzip; samples uint8,
 *                  uint16, int16 or float, in either byte order. Of "space directions" the
 *                  lengths are taken, and "space origin" as it is
 *   .raw, .raw.gz  samples alone, little-endian unless told; the file of the same name with .json
 *                  holds "dims" and "type", and "spacing" where it is not 1 (or "dims_xyz",
 *                  "spacing_xyz"); types as above, with "le" or "be" behind
 *   .bits          a cube of bits, whose side is known by the file's size
 * out    volume: untouched on failure
 * errors GP_ERROR_IO (file access); GP_ERROR_FORMAT with "path: line 3: ..." or "path: byte 34:
 *        ..." and what was expected; GP_ERROR_UNSUPPORTED (valid, but not read here);
 *        GP_ERROR_MEMORY
 * owns   the caller, until gp_volume_free
 * source Teem's definition of the NRRD file format, http://teem.sourceforge.net/nrrd/format.html */
GpResult gp_volume_read(const char *path, GpVolume *volume, GpError *error);

/* Writes a volume: .nrrd (gzip; bits become bytes of 0 and 1; steps along the axes and the origin
 * are
 * in it) or .bits (a cube of bits).
 * errors GP_ERROR_UNSUPPORTED (another name), GP_ERROR_INVALID (.bits of anything else),
 *        GP_ERROR_IO, GP_ERROR_MEMORY; never leaves half a file */
GpResult gp_volume_write(const char *path, const GpVolume *volume, GpError *error);

#endif
