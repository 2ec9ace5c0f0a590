#include "apps/commands/paper_tables.h"

#include "apps/commands/commands.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST_FRAMES = 20 };

static const BenchTable *const tables[] = {
    &bench_table_2_1,
    &bench_table_2_2,
    &bench_table_4_1,
    &bench_table_4_2,
};

const BenchTable *bench_table_find(const char *id)
{
    for (size_t i = 0; i < GP_COUNT(tables); i++)
        if (strcmp(tables[i]->id, id) == 0)
            return tables[i];
    return NULL;
}

void bench_table_list(char *list, size_t size)
{
    size_t used = 0;
    for (size_t i = 0; i < GP_COUNT(tables) && used < size; i++)
        used += (size_t)snprintf(list + used, size - used, "%s%s", i ? ", " : "", tables[i]->id);
}

int bench_table_run(const BenchTable *table, const Options *options, double seconds)
{
    BenchTableRun run = { .options = options };
    int code = options_device(options, NULL, &run.clock.device);
    if (code)
        return code;
    run.clock.plan = (TimingPlan){ seconds, LEAST_FRAMES, 2 * seconds };
    run.clock.each = gp_alloc(TIMING_MAX_FRAMES, sizeof *run.clock.each);
    if (!run.clock.each)
        exit(report(EXIT_INTERNAL, "out of memory"));
    if (!options->json)
        printf("Table %s: %s (%s)\n", table->id, table->title, table->source);
    code = table->run(table, &run);
    gp_free(run.clock.each);
    gp_device_destroy(&run.clock.device);
    return code;
}

int bench_table_open(const BenchTableRun *run, const Technique *technique, const char *row,
                     const char *path, void **scene)
{
    GpError error = { "" };
    *scene = NULL;
    GpResult result = technique->open(path, 0, 0, scene, &error);
    if (result == GP_ERROR_FORMAT || result == GP_ERROR_IO) {
        notice(run->options, "%s: skipped: %s", row, error.text);
        return EXIT_DONE;
    }
    return result ? report(EXIT_INTERNAL, "%s", error.text) : EXIT_DONE;
}

void bench_table_print(json_t *row)
{
    json_dumpf(row, stdout, JSON_COMPACT | JSON_REAL_PRECISION(6));
    putchar('\n');
    json_decref(row);
}

json_t *bench_table_pair(double printed, double measured)
{
    return json_pack("{s:f, s:f}", "printed", printed, "measured", measured);
}
