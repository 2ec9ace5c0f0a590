/* Pictures of every format, and layers. */
#include "pipeline/io/image/image_file.h"
#include "pipeline/io/image/layers_file.h"
#include "tests/fuzz/targets.h"

#include <stdio.h>
#include <string.h>

enum { MOST = 4096 };

static bool read_picture(const char *extension, const uint8_t *data, size_t size)
{
    GpImage image = { .data = NULL };
    GpError error = { "" };
    const GpResult result = gp_image_read(fuzz_file(extension, data, size), &image, &error);
    if (!fuzz_accepted(result, &error))
        return false;
    fuzz_claim(image.width > 0 && image.height > 0 && image.channels - 1 < 4,
               "a picture has pixels");
    gp_image_free(&image);
    return true;
}

/* Pictures of all types and channels that a format can hold. */
static void give_written(const FuzzSeeds *to, const char *extension)
{
    static const uint8_t samples[3 * 2 * 4 * 4] = { 1, 60, 0, 128, 255, 7, 0, 62 };
    for (uint32_t channels = 1; channels <= 4; channels++)
        for (GpImageType type = 0; type < GP_IMAGE_TYPES; type++) {
            const GpImage image = { 3, 2, channels, type, (void *)(uintptr_t)samples };
            GpFile file;
            GpError error;
            char name[32];
            if (gp_image_encode(extension, &image, NULL, &file, &error))
                continue;
            snprintf(name, sizeof name, "%u-%d", channels, (int)type);
            to->take(to->user, name, file.data, file.size);
            gp_file_free(&file);
        }
}

#define FORMAT(name, extension)                                                                    \
    static bool run_##name(const uint8_t *data, size_t size)                                       \
    {                                                                                              \
        return read_picture(extension, data, size);                                                \
    }                                                                                              \
    static void seeds_##name(const FuzzSeeds *to)                                                  \
    {                                                                                              \
        give_written(to, "a" extension);                                                           \
    }                                                                                              \
    const FuzzTarget fuzz_picture_##name = { "picture_" #name, MOST, run_##name, seeds_##name,     \
                                             NULL };

FORMAT(png, ".png")
FORMAT(pfm, ".pfm")
FORMAT(ppm, ".ppm")
FORMAT(exr, ".exr")

/* --- TGA, which is only read ------------------------------------------------------------------ */

static bool run_tga(const uint8_t *data, size_t size)
{
    return read_picture(".tga", data, size);
}

static void seeds_tga(const FuzzSeeds *to)
{
    static const uint8_t plain[18 + 12] = { [2] = 2, [12] = 2, [14] = 2, [16] = 24 };
    static const uint8_t runs[18 + 4] = {
        [2] = 10, [12] = 2, [14] = 2, [16] = 24, [18] = 0x83, 1, 2, 3
    };
    to->take(to->user, "plain", plain, sizeof plain);
    to->take(to->user, "runs", runs, sizeof runs);
}

const FuzzTarget fuzz_picture_tga = { "picture_tga", MOST, run_tga, seeds_tga, NULL };

/* --- layers ----------------------------------------------------------------------------------- */

static const char attribute[] = "fuzz";

static bool run_layers(const uint8_t *data, size_t size)
{
    GpLayers layers = { .count = 0 };
    GpError error = { "" };
    const GpResult result =
        gp_layers_read(fuzz_file(".exr", data, size), attribute, &layers, &error);
    if (!fuzz_accepted(result, &error))
        return false;
    gp_layers_free(&layers);
    return true;
}

static void seeds_layers(const FuzzSeeds *to)
{
    static float samples[2][12];
    for (uint32_t count = 1; count <= 2; count++) {
        GpLayers layers = { .count = count };
        GpError error;
        for (uint32_t i = 0; i < count; i++) {
            layers.layer[i] = (GpLayer){ 3, 2, 2, { "R", "Z" }, "text", samples[i] };
        }
        const char *path = fuzz_path(".exr");
        if (gp_layers_write(path, attribute, &layers, &error) == GP_OK)
            fuzz_seed_file(to, count == 1 ? "one" : "two", path);
    }
}

const FuzzTarget fuzz_layers = { "layers", MOST, run_layers, seeds_layers, NULL };
