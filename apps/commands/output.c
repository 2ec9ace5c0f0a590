#include "apps/commands/output.h"

#include "apps/base/json.h"
#include "apps/base/text.h"
#include "apps/frame/picture.h"
#include "pipeline/io/file.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <xxhash.h>

void output_default_path(const char *input, const char *extension, char *path, size_t size)
{
    static const char *const prefixes[] = { "builtin:", "parametric:" }; /* of names, not files */
    char name[256] = "implicit"; /* of a function, whose text is no name */
    for (size_t i = 0; i < GP_COUNT(prefixes); i++)
        if (strncmp(input, prefixes[i], strlen(prefixes[i])) == 0)
            input += strlen(prefixes[i]);
    if (strncmp(input, "implicit:", 9) != 0)
        text_stem(input, name, sizeof name);
    snprintf(path, size, "%s%s.%s", gp_path_is_folder("out") ? "out/" : "", name, extension);
}

/* --- results ---------------------------------------------------------------------------------- */

static void print_hash(const Output *output, uint64_t hash)
{
    const uint32_t *dims = output->volume.dims;
    char line[PICTURE_HASH_LINE];
    if (output->volume.data)
        snprintf(line, sizeof line, "hash VOXELS %ux%ux%u %016" PRIx64, dims[0], dims[1], dims[2],
                 hash);
    else
        picture_hash_line(output->surface, line);
    printf("%s\n%s", line, output->lines ? output->lines : "");
}

/* "splats" is followed by "splats_per_second". */
static void add_rate(const Output *output, json_t *object)
{
    char name[64];
    const json_t *count = output->rate ? json_object_get(output->members, output->rate) : NULL;
    snprintf(name, sizeof name, "%s_per_second", output->rate ? output->rate : "");
    if (count && output->statistics.ms > 0)
        json_object_set_new(object, name,
                            json_real(json_number_value(count) * 1000 / output->statistics.ms));
}

static int print_object(const Output *output, uint64_t hash)
{
    const GpVolume *volume = &output->volume;
    json_t *object = run_json(&output->statistics, hash, output->surface);
    if (volume->data) {
        json_t *size =
            json_pack("{s:s, s:I, s:I, s:I, s:I}", "format", "VOXELS", "width",
                      (json_int_t)volume->dims[0], "height", (json_int_t)volume->dims[1], "depth",
                      (json_int_t)volume->dims[2], "bytes", (json_int_t)gp_volume_bytes(volume));
        json_object_update(object, size);
        json_decref(size);
    }
    json_object_update(object, output->members);
    add_rate(output, object);
    json_object_set_new(object, "file", json_text(output->path));
    if (output->alpha_path)
        json_object_set_new(object, output->alpha_name, json_text(output->alpha_path));
    return output_json(object);
}

/* The picture, and its alpha where that is asked for. */
static GpResult write_picture(const Output *output, GpError *error)
{
    GpPool *pool = NULL;
    GpResult result = gp_pool_create(gp_device_threads(output->device), &pool, error);
    if (!result)
        result = picture_write_surface(output->path, output->surface, output->opaque, pool, error);
    if (!result && output->alpha_path)
        result = picture_write_alpha(output->alpha_path, output->surface, pool, error);
    gp_pool_destroy(&pool);
    return result;
}

int output_result(Output *output)
{
    const Options *options = output->options;
    const RunStatistics *statistics = &output->statistics;
    const GpVolume *volume = &output->volume;
    GpError error = { "" };
    const uint64_t hash = volume->data ? XXH3_64bits(volume->data, gp_volume_bytes(volume))
                                       : gp_surface_hash(output->surface);
    if (volume->data ? gp_volume_write(output->path, volume, &error)
                     : write_picture(output, &error))
        return report(EXIT_INTERNAL, "%s", error.text);
    notice(options, "wrote %s", output->path);
    if (output->alpha_path)
        notice(options, "wrote %s", output->alpha_path);
    if (options->verbose)
        notice(options, "%.3f ms, %llu primitives, %llu fragments shaded, isa %s",
               statistics->first_ms, (unsigned long long)statistics->counters.primitives,
               (unsigned long long)statistics->counters.fragments_shaded, statistics->isa);
    if (!options->json) {
        print_hash(output, hash);
        return EXIT_DONE;
    }
    GpResult result = run_again(output->device, output->list, &output->statistics, &error);
    return result ? report(exit_of_run(result), "%s: %s", output->input, error.text)
                  : print_object(output, hash);
}

/* --- JSON ------------------------------------------------------------------------------------- */

int output_json(json_t *value)
{
    if (!value)
        return report(EXIT_INTERNAL, "out of memory");
    json_dumpf(value, stdout, JSON_INDENT(1) | JSON_REAL_PRECISION(15));
    putchar('\n');
    json_decref(value);
    return EXIT_DONE;
}

void output_json_line(json_t *value)
{
    json_dumpf(value, stdout, JSON_COMPACT | JSON_REAL_PRECISION(6));
    putchar('\n');
    fflush(stdout);
    json_decref(value);
}
