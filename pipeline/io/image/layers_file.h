/* Layers from and to files: EXR files of one or more parts, by OpenImageIO. */
#ifndef GP_IO_LAYERS_FILE_H
#define GP_IO_LAYERS_FILE_H

#include "pipeline/io/image/layers.h"

/* Reads a file of any such channels. in attribute: name of the text
 * out    layers: untouched on failure; OpenEXR and OpenImageIO choose the order of the channels
 * errors GP_ERROR_IO, GP_ERROR_FORMAT, GP_ERROR_UNSUPPORTED (more parts or channels than fit,
 *        tiles, deep pixels, over 4 GiB), GP_ERROR_MEMORY, each with the path
 * owns   the caller, until gp_layers_free */
GpResult gp_layers_read(const char *path, const char *attribute, GpLayers *layers, GpError *error);

/* Writes a file by gp_file_write, never half of one; its bytes depend on nothing but the layers.
 * in     layers: at least one; sides of 1 to GP_IMAGE_SIDE_MAX; names differ
 * errors GP_ERROR_INVALID (path, size), GP_ERROR_IO, GP_ERROR_UNSUPPORTED, GP_ERROR_MEMORY */
GpResult gp_layers_write(const char *path, const char *attribute, const GpLayers *layers,
                         GpError *error);

#endif
