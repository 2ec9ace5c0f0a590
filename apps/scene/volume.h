/* Volumes by name, as bytes, and what their values look like. */
#ifndef APPS_SCENE_VOLUME_H
#define APPS_SCENE_VOLUME_H

#include "pipeline/io/volume/volume_file.h"

enum { VOLUME_VALUES = 256 };

/* Reads a volume file, looked for as data is.
 * errors those of gp_data_find and gp_volume_read
 * owns   the caller, until gp_volume_free */
GpResult volume_open(const char *name, GpVolume *volume, GpError *error);

/* Samples as bytes, from the least to the greatest; what is no number becomes 0. NULL without
 * memory. The caller frees them. */
uint8_t *volume_bytes(const GpVolume *volume);

/* A point of a transfer function, linear between points: red, green, blue, and how much a voxel
 * takes of the light on the way through a whole volume, as a density that adds up along a ray. */
typedef struct VolumeStop {
    double value, rgba[4];
} VolumeStop;

/* How much light a voxel takes, as a share of what it lets through: twice as many voxels on the same
 * way take half of it each, nearly. */
double volume_opacity(double density);

/* A transfer function as a table of red, green, blue and opacity.
 * in   stops: at least two, by rising value, the first at 0, the last at 255
 *      size: voxels a side */
void volume_transfer(const VolumeStop *stops, size_t count, uint32_t size,
                     uint8_t table[VOLUME_VALUES][4]);

#endif
