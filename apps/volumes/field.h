/* Scanned volumes, ready to be drawn: samples as bytes, and where they are.
 *
 * Space: sample (x, y, z) stands at scale * (x, y, z), so that the closest samples are 1 apart and a
 * volume of even spacing has its indices for coordinates. The volume is the box from its first
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

/* Makes a field of a volume's samples: bytes as they are, bits as 0 and 255, all others from the
 * least to the greatest that is a number; what is none becomes 0.
 * out    field: untouched on failure
 * errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: a side of more than 1024 samples
 * owns   the caller, until field_free */
GpResult field_make(const GpVolume *volume, Field *field, GpError *error);

/* Opens a volume by name: a file, looked for as data is, or builtin:marschner-lobb[:N],
 * builtin:checkerboard[:N], builtin:ball[:N].
 * errors those of gp_data_find, gp_volume_read and field_make; GP_ERROR_INVALID: no such builtin */
GpResult field_open(const char *name, Field *field, GpError *error);

void field_free(Field *field);

static inline size_t field_samples(const Field *field)
{
    return (size_t)field->size[0] * field->size[1] * field->size[2];
}

#endif
