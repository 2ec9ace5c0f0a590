/* Points of surfaces from files: PLY, and text with a point a line (XYZ, XYZN, PTS and their
 * like). */
#ifndef GP_IO_POINTS_H
#define GP_IO_POINTS_H

#include "pipeline/base/base.h"

/* Arrays are packed, in file order, and belong to the points. */
typedef struct GpPoints {
    float *positions; /* [3 * count], finite, the file's own unit and axes */
    float *normals;   /* [3 * count] as stored, of any length, also (0, 0, 0); NULL without */
    float *radii;     /* [count] >= 0 as stored; NULL without */
    uint8_t *colors;  /* [3 * count] red, green, blue; NULL without */
    uint32_t count;
    /* of the file: more than 0, and it holds a mesh, whose vertices are no points */
    uint32_t face_count;
} GpPoints;

/* Reads points. The format is that of the extension (any case); .ply is confirmed by its first
 * word.
 *
 *  .ply             the vertices, in any encoding, with properties of any type and order: x y z, nx
 *                   ny nz, radius, red green blue; all others, lists and other elements are
 *                   skipped. Colours are integers of 0..255, ushorts of 0..65535 or floats of 0..1.
 *                   Where there are faces, only how many is read
 *  .xyz .asc .txt   x y z; x y z intensity; x y z and three more; or x y z and six more. Three more
 *                   are a colour where they are integers of 0..255 in every line and above 1
 *                   somewhere, else a normal
 *  .xyzn            x y z nx ny nz, and perhaps a colour
 *  .xyzrgb          x y z red green blue
 *  .pts             x y z [intensity] [red green blue]
 *
 * Texts have the same count of numbers in every line. Blank lines and lines that begin with # or //
 * are skipped, intensities dropped. A line with one integer promises so many points after it;
 * several such blocks may follow each other. Colours of texts are integers of 0..255 throughout, or
 * numbers of 0..1.
 *
 * in     path: as for fopen
 * out    points: untouched on failure; count is at least 1, or 0 where there are faces
 * errors GP_ERROR_IO (file access); GP_ERROR_FORMAT with "path: line 12: ..." or "path: byte 34:
 *        ..." (truncated, impossible counts, a number that is none or is not finite, no points
 *        ...); GP_ERROR_UNSUPPORTED (an unknown extension); GP_ERROR_MEMORY
 * owns   the caller frees the points with gp_points_free */
GpResult gp_points_read(const char *path, GpPoints *points, GpError *error);

/* Whether gp_points_read knows the extension. PLY files may hold a mesh as well. */
bool gp_points_is_readable(const char *path);

/* Frees the arrays and empties *points; NULL and empty ones are fine. */
void gp_points_free(GpPoints *points);

#endif
