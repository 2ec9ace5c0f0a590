#include "apps/commands/output.h"

#include "apps/commands/commands.h"
#include "apps/base/json.h"
#include "apps/frame/picture.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

void output_default_path(const char *input, const char *extension, char *path, size_t size)
{
    static const char *const prefixes[] = { "builtin:", "parametric:" }; /* of names, not files */
    static const char function[] = "implicit:";
    struct stat status;
    bool out = stat("out", &status) == 0 && S_ISDIR(status.st_mode);
    const char *slash = strrchr(input, '/'), *name = slash ? slash + 1 : input;
    for (size_t i = 0; i < GP_COUNT(prefixes); i++)
        if (strncmp(input, prefixes[i], strlen(prefixes[i])) == 0)
            name = input + strlen(prefixes[i]);
    if (strncmp(input, function, strlen(function)) == 0)
        name = "implicit";
    const char *dot = strrchr(name, '.');
    int length = dot && dot > name ? (int)(dot - name) : (int)strlen(name);
    snprintf(path, size, "%s%.*s.%s", out ? "out/" : "", length, name, extension);
}

void output_verbose(const Options *options, const RunStatistics *statistics)
{
    if (options->verbose)
        notice(options, "%.3f ms, %llu primitives, %llu fragments shaded, isa %s",
               statistics->first_ms, (unsigned long long)statistics->counters.primitives,
               (unsigned long long)statistics->counters.fragments_shaded, statistics->isa);
}

/* The picture is written and hashed before the second, timed frame: a list that does not clear its
 * targets draws over its first. */
void output_hash(const GpSurface *surface, uint64_t hash)
{
    printf("hash %s %ux%u %016" PRIx64 "\n", gp_format_info(surface->format)->name, surface->width,
           surface->height, hash);
}

int output_frame(const Options *options, const char *input, const char *output, GpDevice *device,
                 const GpList *list, const GpSurface *surface, bool opaque, json_t *more)
{
    GpError error = { "" };
    RunStatistics statistics;
    GpResult result = run_first(device, list, &statistics, &error);
    if (result)
        return report(exit_of_run(result), "%s: %s", input, error.text);
    uint64_t hash = gp_surface_hash(surface);
    if (picture_write_surface(output, surface, opaque, &error))
        return report(EXIT_INTERNAL, "%s", error.text);
    notice(options, "wrote %s", output);
    output_verbose(options, &statistics);
    if (!options->json) {
        output_hash(surface, hash);
        return EXIT_DONE;
    }
    result = run_again(device, list, &statistics, &error);
    if (result)
        return report(exit_of_run(result), "%s: %s", input, error.text);
    json_t *object = run_json(&statistics, hash, surface);
    json_object_set_new(object, "file", json_string(output));
    json_object_update(object, more);
    json_print(object);
    return EXIT_DONE;
}
