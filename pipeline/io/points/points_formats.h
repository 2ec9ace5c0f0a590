/* The readers of point formats (internal), and what they fill.
 *
 * As with meshes, a reader walks over the bytes once and trusts nothing: counts are held against
 * the size before memory is taken, and what is wrong is refused with the place and the reason.
 */
#ifndef GP_IO_POINTS_FORMATS_H
#define GP_IO_POINTS_FORMATS_H

#include "pipeline/io/bytes.h"
#include "pipeline/io/input.h"
#include "pipeline/io/points/points.h"

/* Starts with all zero. An array is part of the points where its has_ is set. */
typedef struct GpPointsBuilder {
    GpBytes positions, normals, radii; /* floats */
    GpBytes colors;                    /* bytes */
    bool has_normals, has_radii, has_colors;
    size_t face_count;
} GpPointsBuilder;

/* What the columns of a text mean, by its extension. */
typedef enum GpPointsColumns {
    GP_POINTS_XYZ,
    GP_POINTS_XYZN,
    GP_POINTS_XYZRGB,
    GP_POINTS_PTS
} GpPointsColumns;

/* in     input: at the start of a file that is not empty
 * out    points: empty before, then what the file holds, also where that is no point
 * errors GP_ERROR_FORMAT, GP_ERROR_UNSUPPORTED in input->result; memory that is short leaves
 *        `failed` in one of the arrays */
void gp_points_read_ply(GpInput *input, GpPointsBuilder *points);
void gp_points_read_text(GpInput *input, GpPointsColumns columns, GpPointsBuilder *points);

#endif
