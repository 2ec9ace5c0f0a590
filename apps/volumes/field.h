/* Scanned volumes, ready to be drawn: samples as bytes, and where they are.
 *
 * Space: sample (x, y, z) stands at scale * (x, y, z), so that the closest samples are 1 apart and
 * a volume of even spacing has its indices for coordinates. The volume is the box from its first
 * sample to its last; outside there is nothing.
 */
#ifndef APPS_VOLUMES_FIELD_H
#define APPS_VOLUMES_FIELD_H

#include "pipeline/io/volume/volume.h"

enum { FIELD_VALUES = 256 };

/* A zeroed one is empty. */
typedef struct Field {
    uint32_t size[3];   /* samples along x, y, z; 1..1024 */
    double scale[3];    /* distance of samples along x, y, z; the least is 1 */
    uint8_t *value;     /* [z][y][x] */
    double least, most; /* what values 0 and 255 were in the file: 0 and 255 where it has bytes */
} Field;

/* Reads a volume's file, looked for as data is, with its samples as they are.
 * errors those of gp_data_find and gp_volume_read
 * owns   the caller, until gp_volume_free */
GpResult field_read(const char *name, GpVolume *volume, GpError *error);

/* Samples as bytes, from the least to the greatest that is finite; what is not becomes 0.
 * out    range: the least and the greatest; NULL: not wanted
 * returns NULL without memory. The caller frees them. */
uint8_t *field_bytes(const GpVolume *volume, double range[2]);

/* Makes a field of a volume's samples: bytes as they are, all others as field_bytes.
 * in/out volume: bytes become the field's, and are no longer here
 * out    field: untouched on failure
 * errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: a side of more than 1024 samples, or samples more
 *        than a thousand times as far from each other along one axis as along another
 * owns   the caller, until field_free */
GpResult field_make(GpVolume *volume, Field *field, GpError *error);

/* Opens a volume by name: a file, looked for as data is, or builtin:NAME[:N] (builtin.h).
 * errors those of field_read and field_make; GP_ERROR_INVALID: no such builtin
 * owns   the caller, until field_free */
GpResult field_open(const char *name, Field *field, GpError *error);

void field_free(Field *field);

static inline size_t field_samples(const Field *field)
{
    return (size_t)field->size[0] * field->size[1] * field->size[2];
}

#endif
