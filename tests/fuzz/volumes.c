/* Volumes of every format. */
#include "pipeline/io/volume/volume_file.h"
#include "tests/fuzz/targets.h"

#include <string.h>

static bool read_volume(const char *path)
{
    GpVolume volume = { .data = NULL };
    GpError error = { "" };
    if (!fuzz_accepted(gp_volume_read(path, &volume, &error), &error))
        return false;
    for (int k = 0; k < 3; k++)
        fuzz_claim(volume.dims[k] > 0 && volume.spacing[k] > 0, "a volume has samples and spacing");
    gp_volume_free(&volume);
    return true;
}

static bool run_nrrd(const uint8_t *data, size_t size)
{
    return read_volume(fuzz_file(".nrrd", data, size));
}

#define NRRD                                                                                       \
    "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 1 2\nspace directions: (1,0,0) (0,2,0) "        \
    "(0,0,3)\n"                                                                                    \
    "space origin: (1,2,3)\n"

static void seeds_nrrd(const FuzzSeeds *to)
{
    static uint8_t samples[2 * 3 * 5 * 4] = { 1, 2, 3, 255 };
    const GpVolumeType types[] = { GP_VOLUME_U8, GP_VOLUME_U16, GP_VOLUME_I16, GP_VOLUME_F32 };
    static const char *const names[] = { "u8", "u16", "i16", "f32" };
    for (size_t i = 0; i < GP_COUNT(types); i++) {
        const GpVolume volume = { { 2, 3, 5 }, types[i], { 1, 2, 3 }, { 0, -1, 0 }, samples };
        GpError error;
        const char *path = fuzz_path(".nrrd");
        if (gp_volume_write(path, &volume, &error) == GP_OK)
            fuzz_seed_file(to, names[i], path);
    }
    fuzz_seed_text(to, "raw", NRRD "endian: little\nencoding: raw\nkey:=value\n\nabcd");
}

/* The description, then a zero byte, then the samples. */
static bool run_raw(const uint8_t *data, size_t size)
{
    const uint8_t *end = memchr(data, 0, size);
    const size_t text = end ? (size_t)(end - data) : size;
    fuzz_file(".json", data, text);
    return read_volume(fuzz_file(".raw", data + text + (end != NULL), size - text - (end != NULL)));
}

static void seeds_raw(const FuzzSeeds *to)
{
    static const char bytes[] = "{ \"dims\": [2, 1, 2], \"type\": \"uint8\" }\0abcd";
    static const char words[] =
        "{ \"dims_xyz\": [1, 1, 2], \"spacing_xyz\": [1, 2, 0.5], \"type\": \"int16be\" }\0abcd";
    to->take(to->user, "bytes", bytes, sizeof bytes - 1);
    to->take(to->user, "words", words, sizeof words - 1);
}

static bool run_bits(const uint8_t *data, size_t size)
{
    return read_volume(fuzz_file(".bits", data, size));
}

static void seeds_bits(const FuzzSeeds *to)
{
    static const uint8_t cube[64] = { 1 };
    to->take(to->user, "two", cube, 1);
    to->take(to->user, "eight", cube, sizeof cube);
}

const FuzzTarget fuzz_volume_nrrd = { "volume_nrrd", 2048, run_nrrd, seeds_nrrd, NULL };
const FuzzTarget fuzz_volume_raw = { "volume_raw", 1024, run_raw, seeds_raw, NULL };
const FuzzTarget fuzz_volume_bits = { "volume_bits", 1024, run_bits, seeds_bits, NULL };
