#include "pipeline/io/volume/volume.h"

#include <string.h>

size_t gp_volume_sample_bytes(GpVolumeType type)
{
    static const size_t bytes[] = { [GP_VOLUME_BITS] = 0,
                                    [GP_VOLUME_U8] = 1,
                                    [GP_VOLUME_U16] = 2,
                                    [GP_VOLUME_I16] = 2,
                                    [GP_VOLUME_F32] = 4 };
    return bytes[type];
}

static size_t sample_count(const GpVolume *volume)
{
    return (size_t)volume->dims[0] * volume->dims[1] * volume->dims[2];
}

size_t gp_volume_bytes(const GpVolume *volume)
{
    size_t count = sample_count(volume);
    return volume->type == GP_VOLUME_BITS ? (count + 7) / 8
                                          : count * gp_volume_sample_bytes(volume->type);
}

void gp_volume_free(GpVolume *volume)
{
    if (!volume)
        return;
    gp_free(volume->data);
    memset(volume, 0, sizeof *volume);
}
