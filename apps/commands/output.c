#include "apps/commands/output.h"

#include "apps/base/text.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

void output_default_path(const char *input, const char *extension, char *path, size_t size)
{
    static const char *const prefixes[] = { "builtin:", "parametric:" }; /* of names, not files */
    struct stat status;
    bool out = stat("out", &status) == 0 && S_ISDIR(status.st_mode);
    char name[256] = "implicit"; /* of a function, whose text is no name */
    for (size_t i = 0; i < GP_COUNT(prefixes); i++)
        if (strncmp(input, prefixes[i], strlen(prefixes[i])) == 0)
            input += strlen(prefixes[i]);
    if (strncmp(input, "implicit:", 9) != 0)
        text_stem(input, name, sizeof name);
    snprintf(path, size, "%s%s.%s", out ? "out/" : "", name, extension);
}

void output_verbose(const Options *options, const RunStatistics *statistics)
{
    if (options->verbose)
        notice(options, "%.3f ms, %llu primitives, %llu fragments shaded, isa %s",
               statistics->first_ms, (unsigned long long)statistics->counters.primitives,
               (unsigned long long)statistics->counters.fragments_shaded, statistics->isa);
}

void output_hash(const GpSurface *surface, uint64_t hash)
{
    printf("hash %s %ux%u %016" PRIx64 "\n", gp_format_info(surface->format)->name, surface->width,
           surface->height, hash);
}

int output_json(json_t *value)
{
    if (!value)
        return report(EXIT_INTERNAL, "out of memory");
    json_dumpf(value, stdout, JSON_INDENT(1) | JSON_REAL_PRECISION(9));
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
