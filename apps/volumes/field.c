#include "apps/volumes/field.h"

#include "apps/volumes/builtin.h"
#include "pipeline/io/file.h"
#include "pipeline/io/volume/volume_file.h"

#include <math.h>
#include <string.h>

enum { MAX_SIDE = 1024 };

/* --- samples ---------------------------------------------------------------------------------- */

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

static size_t sample_count(const GpVolume *volume)
{
    return (size_t)volume->dims[0] * volume->dims[1] * volume->dims[2];
}

uint8_t *field_bytes(const GpVolume *volume, double range[2])
{
    const size_t count = sample_count(volume);
    uint8_t *bytes = gp_alloc(count, 1);
    double least = (double)INFINITY, most = -least;
    for (size_t i = 0; i < count; i++) {
        const double value = sample(volume, i);
        least = isfinite(value) && value < least ? value : least;
        most = isfinite(value) && value > most ? value : most;
    }
    const double scale = most > least ? (FIELD_VALUES - 1) / (most - least) : 0;
    for (size_t i = 0; bytes && i < count; i++) {
        const double value = sample(volume, i);
        bytes[i] = isfinite(value) ? (uint8_t)((value - least) * scale + 0.5) : 0;
    }
    if (range) {
        range[0] = least <= most ? least : 0;
        range[1] = least <= most ? most : 0;
    }
    return bytes;
}

/* --- fields ----------------------------------------------------------------------------------- */

/* Scales whose least is 1. returns whether they are near enough to each other */
static bool even_scale(const GpVolume *volume, double scale[3])
{
    const double *spacing = volume->spacing;
    const double least = fmin(spacing[0], fmin(spacing[1], spacing[2]));
    bool is_even = true;
    for (int k = 0; k < 3; k++) {
        scale[k] = spacing[k] / least;
        is_even = is_even && scale[k] <= 1000;
    }
    return is_even;
}

GpResult field_make(GpVolume *volume, Field *field, GpError *error)
{
    const uint32_t *dims = volume->dims;
    Field made = { .size = { dims[0], dims[1], dims[2] } };
    if (dims[0] > MAX_SIDE || dims[1] > MAX_SIDE || dims[2] > MAX_SIDE)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%u x %u x %u samples, expected at most %d a side", dims[0], dims[1],
                       dims[2], MAX_SIDE);
    if (!even_scale(volume, made.scale))
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "a spacing of %g x %g x %g, expected none to be 1000 times another",
                       volume->spacing[0], volume->spacing[1], volume->spacing[2]);
    double range[2] = { 0, FIELD_VALUES - 1 };
    if (volume->type != GP_VOLUME_U8)
        made.value = field_bytes(volume, range);
    else
        made.value = volume->data;
    if (!made.value)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for %u x %u x %u samples", dims[0],
                       dims[1], dims[2]);
    if (made.value == volume->data)
        volume->data = NULL;
    made.least = range[0];
    made.most = range[1];
    *field = made;
    return GP_OK;
}

GpResult field_read(const char *name, GpVolume *volume, GpError *error)
{
    char path[4096];
    const GpResult result = gp_data_find(name, path, sizeof path, error);
    return result ? result : gp_volume_read(path, volume, error);
}

GpResult field_open(const char *name, Field *field, GpError *error)
{
    static const char prefix[] = "builtin:";
    if (strncmp(name, prefix, sizeof prefix - 1) == 0)
        return builtin_field(name + sizeof prefix - 1, field, error);
    GpVolume volume;
    GpError reason = { "" };
    GpResult result = field_read(name, &volume, error);
    if (result != GP_OK)
        return result;
    result = field_make(&volume, field, &reason);
    gp_volume_free(&volume);
    return result == GP_OK ? GP_OK : gp_fail(error, result, "%.200s: %s", name, reason.text);
}

void field_free(Field *field)
{
    if (!field)
        return;
    gp_free(field->value);
    *field = (Field){ .value = NULL };
}
