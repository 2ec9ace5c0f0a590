/* Depth images as files: an EXR file with a part for each image of the model, 32-bit floats.
 *
 * Channels of a part: R G B; Z, the depth as depth_image.h has it, infinite where there is nothing;
 * N.X N.Y N.Z where normals are known; behind.R and so on where there is a second layer. Its
 * attribute "depthImage" says where it was taken from, numbers with all their digits:
 *
 *   plane perspective eye X Y Z right X Y Z up X Y Z forward X Y Z window LEFT BOTTOM WIDTH HEIGHT
 *   plane parallel ... (the same)
 *   cylinder center X Y Z axis X Y Z zero X Y Z radius R height H
 */
#ifndef APPS_DEPTH_IMAGES_DEPTH_FILE_H
#define APPS_DEPTH_IMAGES_DEPTH_FILE_H

#include "apps/depth_images/depth_image.h"

/* Writes a model of at least one image; the bytes depend on nothing but the model.
 * errors GP_ERROR_INVALID (the path does not end with .exr), GP_ERROR_IO, GP_ERROR_MEMORY,
 *        GP_ERROR_UNSUPPORTED (a build without OpenImageIO); never leaves half a file */
GpResult depth_file_write(const char *path, const DepthModel *model, GpError *error);

/* Reads one; what was written comes back bit for bit.
 * out    model: untouched on failure
 * errors GP_ERROR_IO; GP_ERROR_FORMAT: not a depth image, with the part and what was expected: no
 *        Z, channels that are missing, depths that are NaN or below 0, colours or normals that are
 *        not finite, an attribute that is missing or makes no sense; GP_ERROR_UNSUPPORTED (other
 *        EXR files, a build without OpenImageIO); GP_ERROR_MEMORY
 * owns   the caller, until depth_model_free */
GpResult depth_file_read(const char *path, DepthModel *model, GpError *error);

/* Whether a path ends as such files do. */
bool depth_file_is_readable(const char *path);

/* --- what a part's attribute says ------------------------------------------------------------- */

enum { DEPTH_TEXT = 1024 };

void depth_place_write(const DepthImage *image, char text[DEPTH_TEXT]);

/* in  text; out image: is_cylinder and plane or cylinder, untouched on failure
 * errors GP_ERROR_FORMAT: with what was expected */
GpResult depth_place_read(const char *text, DepthImage *image, GpError *error);

#endif
