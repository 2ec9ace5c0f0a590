#include "apps/scene/volume.h"

#include "pipeline/io/file.h"

#include <math.h>

GpResult volume_open(const char *name, GpVolume *volume, GpError *error)
{
    char path[4096];
    GpResult result = gp_data_find(name, path, sizeof path, error);
    return result ? result : gp_volume_read(path, volume, error);
}

static double sample(const GpVolume *volume, size_t i)
{
    switch (volume->type) {
    case GP_VOLUME_BITS:
        return ((const uint8_t *)volume->data)[i / 8] >> i % 8 & 1;
    case GP_VOLUME_U8:
        return ((const uint8_t *)volume->data)[i];
    case GP_VOLUME_U16:
        return ((const uint16_t *)volume->data)[i];
    case GP_VOLUME_I16:
        return ((const int16_t *)volume->data)[i];
    case GP_VOLUME_F32:
        return (double)((const float *)volume->data)[i];
    }
    return 0;
}

uint8_t *volume_bytes(const GpVolume *volume)
{
    const size_t count = (size_t)volume->dims[0] * volume->dims[1] * volume->dims[2];
    uint8_t *bytes = gp_alloc(count, 1);
    double least = (double)INFINITY, most = -least;
    for (size_t i = 0; i < count; i++) {
        const double value = sample(volume, i);
        least = isfinite(value) && value < least ? value : least;
        most = isfinite(value) && value > most ? value : most;
    }
    const double scale = most > least ? (VOLUME_VALUES - 1) / (most - least) : 0;
    for (size_t i = 0; bytes && i < count; i++) {
        const double value = sample(volume, i);
        bytes[i] = isfinite(value) ? (uint8_t)((value - least) * scale + 0.5) : 0;
    }
    return bytes;
}

double volume_opacity(double density)
{
    return density / (1 + density);
}

void volume_transfer(const VolumeStop *stops, size_t count, uint32_t size,
                     uint8_t table[VOLUME_VALUES][4])
{
    size_t stop = 0;
    for (int i = 0; i < VOLUME_VALUES; i++) {
        while (stop + 2 < count && stops[stop + 1].value < i)
            stop++;
        const VolumeStop *a = &stops[stop], *b = a + 1;
        const double t = (i - a->value) / (b->value - a->value);
        double rgba[4];
        for (int c = 0; c < 4; c++)
            rgba[c] = a->rgba[c] + t * (b->rgba[c] - a->rgba[c]);
        rgba[3] = volume_opacity(rgba[3] / size);
        for (int c = 0; c < 4; c++)
            table[i][c] = (uint8_t)(rgba[c] * 255 + 0.5);
    }
}
