/* Volumes in memory.
 *
 * Sample (x, y, z) is number x + dims[0] * (y + dims[1] * z).
 */
#ifndef GP_IO_VOLUME_H
#define GP_IO_VOLUME_H

#include "pipeline/base/base.h"

typedef enum GpVolumeType {
    GP_VOLUME_BITS, /* sample i is bit i % 8, from the low end, of byte i / 8 */
    GP_VOLUME_U8,
    GP_VOLUME_U16,
    GP_VOLUME_I16,
    GP_VOLUME_F32,
} GpVolumeType;

enum { GP_VOLUME_MAX_SIDE = 65535 };

typedef struct GpVolume {
    uint32_t dims[3]; /* samples along x, y, z; 1..GP_VOLUME_MAX_SIDE */
    GpVolumeType type;
    double spacing[3]; /* from sample to sample, above 0; 1 where a file does not say */
    double origin[3];  /* where sample (0, 0, 0) is, the centre of its cell; 0 likewise */
    void *data;        /* [gp_volume_bytes], in the machine's byte order */
} GpVolume;

/* Bytes of a sample; 0 for bits. */
size_t gp_volume_sample_bytes(GpVolumeType type);

/* Bytes of all samples. in dims and type alone */
size_t gp_volume_bytes(const GpVolume *volume);

/* Frees the samples and empties *volume; NULL and empty volumes are fine. */
void gp_volume_free(GpVolume *volume);

#endif
