/* Charts' own files: charts, and errors that were measured. */
#include "apps/charts/chart_draw.h"
#include "apps/charts/chart_file.h"
#include "apps/charts/measured.h"
#include "tests/fuzz/targets.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What is read is drawn. */
static bool run_chart(const uint8_t *data, size_t size)
{
    Chart chart = { .count = 0 };
    Text svg = { .data = NULL };
    GpError error = { "" };
    if (!fuzz_accepted(chart_read(fuzz_file(".json", data, size), &chart, &error), &error))
        return false;
    chart_mark_best(&chart);
    chart_draw(&chart, &svg);
    text_free(&svg);
    chart_free(&chart);
    return true;
}

#define POINT(method, ms, error)                                                                   \
    "{ \"method\": \"" method "\", \"options\": \"--map 16\", \"ms\": " ms ", \"min_ms\": 1,"      \
    " \"cpu_ms\": 1, \"frames\": 1, \"error\": " error ", \"metrics\": [], \"best\": true,"        \
    " \"picture\": \"\" }"

static void seeds_chart(const FuzzSeeds *to)
{
    fuzz_seed_text(
        to, "two",
        "{ \"technique\": \"shadow\", \"scene\": \"small.json\", \"error_name\": \"wrong\","
        " \"title\": \"t\", \"metrics\": [], \"machine\": \"m\", \"isa\": \"i\","
        " \"threads\": 1, \"width\": 64, \"height\": 48, \"points\": [ " POINT(
            "a", "1", "0") ", " POINT("b", "1e3", "2.5") " ] }");
}

/* A file of such errors lies in a folder, under a name with its key. */
static bool run_measured(const uint8_t *data, size_t size)
{
    static Measured measured;
    TechniqueError error;
    char path[4096], folder[4096];
    snprintf(path, sizeof path, "%s", fuzz_path("-0000000000000001.json"));
    snprintf(folder, sizeof folder, "%.*s", (int)(strrchr(path, '/') - path), path);
    fuzz_file("-0000000000000001.json", data, size);
    char *name = strrchr(path, '/') + 1;
    *strrchr(name, '-') = '\0';
    measured_open(folder, name, 1, &measured);
    const bool known = measured_find(&measured, "--map 16", &error);
    measured_close(&measured);
    return known;
}

/* What the program writes itself. */
static void seeds_measured(const FuzzSeeds *to)
{
    static Measured measured;
    const char *path = fuzz_path("-0000000000000001.json");
    char folder[4096], name[256];
    snprintf(folder, sizeof folder, "%.*s", (int)(strrchr(path, '/') - path), path);
    snprintf(name, sizeof name, "%s", strrchr(path, '/') + 1);
    *strrchr(name, '-') = '\0';
    measured_open(folder, name, 1, &measured);
    measured_add(&measured, "--map 16", &(TechniqueError){ .error = 3 });
    GpError error;
    const bool written = measured_write(&measured, &error) == GP_OK;
    char kept[4096];
    snprintf(kept, sizeof kept, "%s", measured.path);
    measured_close(&measured);
    if (written)
        fuzz_seed_file(to, "one", kept);
}

const FuzzTarget fuzz_chart = { "chart", 4096, run_chart, seeds_chart, fuzz_mutate_json };
const FuzzTarget fuzz_measured = { "measured", 2048, run_measured, seeds_measured,
                                   fuzz_mutate_json };
