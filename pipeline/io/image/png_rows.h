/* PNG files of pictures that never are in memory as a whole: rows as they come. */
#ifndef GP_IO_PNG_ROWS_H
#define GP_IO_PNG_ROWS_H

#include "pipeline/io/image/image.h"

typedef struct GpPngRows GpPngRows;

/* Begins a file of the same bytes that gp_image_write would write of the whole picture.
 * in     path: stays as it is until gp_png_end; image: of U8 or U16; its samples are not looked at
 * errors GP_ERROR_IO, GP_ERROR_MEMORY; owns: the caller, until gp_png_end, after a failure too */
GpResult gp_png_begin(const char *path, const GpImage *image, GpPngRows **rows, GpError *error);

/* Appends `count' rows. After a failure nothing but gp_png_end is left to do. */
GpResult gp_png_add(GpPngRows *rows, const void *samples, uint32_t count, GpError *error);

/* Ends the file and puts it in its place, or removes it where it is not `whole'; sets NULL; NULL is
 * fine.
 * errors GP_ERROR_IO: nothing is left then */
GpResult gp_png_end(GpPngRows **rows, bool whole, GpError *error);

#endif
