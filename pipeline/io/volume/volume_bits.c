/* Bits alone: one a sample, and nothing else in the file. */
#include "pipeline/io/volume/volume_codec.h"

/* The side of a cube of bits is the one whose bits fill so many bytes: no two from 2 on do. */
GpResult gp_volume_parse_bits(GpVolumeSource *source, GpError *error)
{
    const uint64_t size = source->file.size;
    uint64_t side = 2;
    while ((side * side * side + 7) / 8 < size && side < GP_VOLUME_MAX_SIDE)
        side++;
    const uint64_t bits = side * side * side;
    if ((bits + 7) / 8 != size)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: byte %zu: expected the bits of a cube: %llu bytes for %llu a side",
                       source->path, source->file.size, (unsigned long long)((bits + 7) / 8),
                       (unsigned long long)side);
    if (bits % 8 && (unsigned char)source->file.data[size - 1] >> bits % 8)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: byte %zu: bits behind the last sample: expected zeros", source->path,
                       source->file.size - 1);
    source->volume = (GpVolume){ .dims = { (uint32_t)side, (uint32_t)side, (uint32_t)side },
                                 .type = GP_VOLUME_BITS,
                                 .spacing = { 1, 1, 1 } };
    return GP_OK;
}
