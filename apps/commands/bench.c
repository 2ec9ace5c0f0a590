/* glasspipe bench: frames that other renderers can draw too, against the clock. */
#include "apps/base/folder.h"
#include "apps/bench/cases.h"
#include "apps/bench/floor.h"
#include "apps/commands/paper_tables.h"
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/frame/run_statistics.h"
#include "apps/base/machine.h"
#include "apps/frame/timing.h"
#include "pipeline/io/image/image_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_CASES = 128, MIN_FRAMES = 20 };

typedef struct Bench {
    Options options; /* first: see options.h */
    const BenchCase *cases[MAX_CASES];
    size_t case_count;
    const char *images; /* NULL: none written */
    double seconds;     /* for each case, after the first frame */
    bool list, floor;
    const char *table; /* number; NULL: cases are drawn */
} Bench;

enum { TABLE_LIST = 160 }; /* bytes of all names */

static char table_help[TABLE_LIST + 80]; /* with the numbers that there are */

static const SettingField options[] = {
    { "list", NULL, "List the cases", SETTING_FLAG, .offset = offsetof(Bench, list),
      .letter = 'l' },
    { "time", "SECONDS", "Draw each case for so long (default: 3)", SETTING_NUMBER,
      .offset = offsetof(Bench, seconds), .high = OPTIONS_ANY, .letter = 't' },
    { "images", "DIR", "Write each case's picture to DIR/CASE.png", SETTING_TEXT,
      .offset = offsetof(Bench, images) },
    { "table", "NUMBER", table_help, SETTING_TEXT, .offset = offsetof(Bench, table) },
    { "floor", NULL, "Add the time below which this machine cannot draw it", SETTING_FLAG,
      .offset = offsetof(Bench, floor) },
    { "phases", NULL, "Look at the clock inside tiles too: costs some time", SETTING_FLAG,
      .offset = offsetof(Bench, options.timed) },
    { .name = NULL },
};

static void add_case(struct argp_state *state, void *args, const char *name)
{
    Bench *bench = args;
    const BenchCase *found = bench_case_find(name);
    if (!found)
        argp_error(state, "no case '%s'; -l lists them", name);
    if (bench->case_count == MAX_CASES)
        argp_error(state, "more than %d cases", MAX_CASES);
    bench->cases[bench->case_count++] = found;
}

static void check(struct argp_state *state, void *args)
{
    Bench *bench = args;
    char list[TABLE_LIST];
    const Technique *technique;
    paper_tables_list(technique_registry, list, sizeof list);
    if (bench->table && !paper_table_find(technique_registry, bench->table, &technique))
        argp_error(state, "--table: expected one of %s, not '%s'", list, bench->table);
    if (bench->table && bench->case_count)
        argp_error(state, "--table draws scenes of its own, no cases");
    if (bench->table && (bench->images || bench->floor || bench->options.timed || bench->list))
        argp_error(state, "--table: expected none of --images, --floor, --phases and --list");
    for (size_t i = 0; bench->case_count == 0 && i < bench_case_count; i++)
        bench->cases[i] = &bench_cases[i];
    if (bench->case_count == 0)
        bench->case_count = bench_case_count;
}

static const CommandSyntax syntax = {
    .shared = OPTIONS_RUN, /* the cases have sizes of their own */
    .options = options,
    .arguments = "[CASE...]",
    .help =
        "Examples:\n"
        "  glasspipe bench\n"
        "  glasspipe bench -l\n"
        "  glasspipe bench clear points -t 0.1 --threads 2\n"
        "  glasspipe bench clear -t 0.1 --floor\n"
        "  glasspipe bench --images pictures\n"
        "  glasspipe bench --table 4.1 -t 0.1\n"
        "\n"
        "Draws the named cases, or all, again and again, and prints a line of JSON for each: the "
        "median and the least time of a frame, and what was drawn.\v"
        "Results are lines of JSON with and without --json, which makes a line a row of --table.\n"
        "Cases that need a mesh or a scan which is not there are left out with a message.",
    .take = add_case,
    .check = check,
};

typedef struct Times {
    double setup_ms;
    Timing frames;    /* after the first */
    double others;    /* processors that other processes kept busy; negative: unknown */
    BenchFloor floor; /* ms 0: not asked for */
    double peak_mb;   /* memory in use at most, less what was before the case: its data count */
} Times;

/* --- results ---------------------------------------------------------------------------------- */

static GpResult write_image(const char *directory, const char *name, const uint8_t *rgba,
                            uint32_t width, uint32_t height, GpError *error)
{
    char path[4096];
    if (folder_make(directory, error))
        return GP_ERROR_IO;
    if (snprintf(path, sizeof path, "%s/%s.png", directory, name) >= (int)sizeof path)
        return gp_fail(error, GP_ERROR_IO, "%s: the path is too long", directory);
    size_t pixels = (size_t)width * height;
    uint8_t *rgb = gp_alloc(pixels, 3);
    if (!rgb)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (size_t i = 0; i < pixels; i++)
        memcpy(rgb + 3 * i, rgba + 4 * i, 3);
    GpImage image = {
        .width = width, .height = height, .channels = 3, .type = GP_IMAGE_U8, .data = rgb
    };
    GpResult result = gp_image_write(path, &image, NULL, error);
    gp_free(rgb);
    return result;
}

/* Means, in milliseconds; what happens inside tiles only with --phases. */
static json_t *phases_json(const Bench *bench, const Times *times)
{
    const struct {
        const char *name;
        double sum;
        bool inside;
    } rows[] = {
        { "prepare", times->frames.phases.prepare, false },
        { "vertices", times->frames.phases.vertices, false },
        { "bins", times->frames.phases.bins, false },
        { "tiles", times->frames.phases.tiles, false },
        { "raster", times->frames.phases.raster, true },
        { "shading", times->frames.phases.shading, true },
        { "transfer", times->frames.phases.transfer, true },
    };
    json_t *object = json_object();
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        if (!rows[i].inside || bench->options.timed)
            json_object_set_new(object, rows[i].name,
                                json_real(rows[i].sum / times->frames.frames));
    return object;
}

/* What cannot be undercut, and how far above it the frame is. */
static json_t *floor_json(const Times *times)
{
    const BenchFloor *floor = &times->floor;
    return json_pack("{s:f, s:f, s:f, s:f, s:f}", "ms", floor->ms, "operations_ms",
                     floor->operations_ms, "triangles_ms", floor->triangles_ms, "traffic_ms",
                     floor->traffic_ms, "ratio", times->frames.ms / floor->ms);
}

static void print_result(const Bench *bench, const BenchCase *drawn, const Frame *frame,
                         const Times *times, const RunStatistics *statistics, uint32_t width,
                         uint32_t height, uint32_t hash)
{
    char digits[9];
    snprintf(digits, sizeof digits, "%08x", hash);
    bool reference = bench->options.executor == GP_EXECUTOR_REFERENCE;
    double megapixels = (double)width * height * 1e-6;
    json_t *object = json_pack(
        "{s:s, s:s, s:i, s:i, s:i, s:f, s:f, s:f, s:f, s:s, s:I, s:f}", "case", drawn->name,
        "renderer", "glasspipe", "threads", statistics->threads, "width", (int)width, "height",
        (int)height, "ms", times->frames.ms, "min_ms", times->frames.min_ms, "cpu_ms",
        times->frames.cpu_ms, "first_ms", statistics->first_ms, "hash", digits, "frames",
        (json_int_t)times->frames.frames, "setup_ms", times->setup_ms);
    if (drawn->screens > 0)
        json_object_set_new(object, "mpix", json_real(drawn->screens * megapixels));
    if (drawn->primitives > 1000)
        json_object_set_new(object, "mprim", json_real(drawn->primitives * 1e-6));
    if (drawn->flop > 0)
        json_object_set_new(object, "gflop", json_real(drawn->flop * megapixels * 1e-3));
    json_object_set_new(object, "peak_mb", json_real(times->peak_mb));
    if (times->others >= 0)
        json_object_set_new(object, "others", json_real(times->others));
    run_add_counters(statistics, object);
    if (drawn->tell)
        drawn->tell(frame, times->frames.ms, statistics->threads, bench->seconds > 0, object);
    json_object_set_new(object, "idle_ms", json_real(times->frames.idle_ms));
    if (times->floor.ms > 0)
        json_object_set_new(object, "floor", floor_json(times));
    if (!reference)
        json_object_set_new(object, "phases", phases_json(bench, times));
    json_object_set_new(object, "isa", json_string(statistics->isa));
    json_object_set_new(object, "executor", json_string(reference ? "reference" : "fast"));
    output_json_line(object);
}

static int show_picture(const Bench *bench, const BenchCase *drawn, const Frame *frame,
                        const Times *times, const RunStatistics *statistics)
{
    uint32_t width, height;
    bench_picture_size(frame, &width, &height);
    uint8_t *rgba = gp_alloc((size_t)width * height, 4);
    if (!rgba)
        return report(EXIT_INTERNAL, "out of memory");
    (drawn->picture ? drawn->picture : bench_show)(frame, rgba);
    GpError error = { "" };
    GpResult result = bench->images
                          ? write_image(bench->images, drawn->name, rgba, width, height, &error)
                          : GP_OK;
    if (!result)
        print_result(bench, drawn, frame, times, statistics, width, height,
                     bench_picture_hash(rgba, width, height));
    gp_free(rgba);
    return result ? report(EXIT_INTERNAL, "%s", error.text) : EXIT_DONE;
}

/* Before the picture is looked at, since `tell` measures it: so the list is run once more behind
 * it. */
static GpResult find_floor(GpDevice *device, const GpList *list, BenchFloor *floor, GpError *error)
{
    BenchRates rates;
    GpResult result = bench_rates_measure(device, &rates, error);
    if (!result)
        result = bench_floor_find(device, &rates, list, floor, error);
    return result ? result : gp_device_run(device, list, error);
}

/* One device for each case, so that cases do not inherit memory from each other. Draws the first
 * frame, then others until both the time is over and there are enough, but at most twice the time.
 * Where the first alone takes as long, it stands for all. */
static int run_case(const Bench *bench, const BenchCase *drawn, double *each)
{
    const TimingPlan plan = { bench->seconds, MIN_FRAMES, 2 * bench->seconds };
    Frame frame = { .color = NULL };
    GpError error = { "" };
    machine_reset_peak();
    double start = machine_clock_ms(CLOCK_MONOTONIC), before_mb = machine_peak_mb();
    if (drawn->build(drawn, &frame, &error)) {
        notice(&bench->options, "%s: skipped: %s", drawn->name, error.text);
        frame_free(&frame);
        return EXIT_DONE;
    }
    GpDevice *device = NULL;
    RunStatistics statistics = { .isa = "" };
    Times times = { .setup_ms = machine_clock_ms(CLOCK_MONOTONIC) - start };
    int code = options_device(&bench->options, NULL, &device);
    if (!code) {
        MachineLoad load = machine_load_begin();
        GpResult result = run_first(device, &frame.list, &statistics, &error);
        if (!result)
            result =
                timing_run(device, &frame.list, &plan, each, &statistics, &times.frames, &error);
        times.others = machine_others(&load);
        times.peak_mb = machine_peak_mb() - before_mb;
        if (!result && bench->floor)
            result = find_floor(device, &frame.list, &times.floor, &error);
        code = result ? report(exit_of_run(result), "%s: %s", drawn->name, error.text)
                      : show_picture(bench, drawn, &frame, &times, &statistics);
    }
    gp_device_destroy(&device);
    frame_free(&frame);
    return code;
}

int cmd_bench(int argc, char **argv)
{
    Bench bench = { .seconds = 3 };
    char list[TABLE_LIST];
    paper_tables_list(technique_registry, list, sizeof list);
    snprintf(table_help, sizeof table_help,
             "Measure a table of the publications again, beside what was printed: %s", list);
    command_parse(&syntax, NULL, argc, argv, &bench);
    if (bench.list) {
        for (size_t i = 0; i < bench_case_count; i++)
            puts(bench_cases[i].name);
        return EXIT_DONE;
    }
    if (bench.table)
        return paper_table_run(technique_registry, bench.table, &bench.options, bench.seconds);
    double *each = gp_alloc(TIMING_MAX_FRAMES, sizeof *each);
    if (!each)
        return report(EXIT_INTERNAL, "out of memory");
    int code = EXIT_DONE;
    for (size_t i = 0; !code && i < bench.case_count; i++)
        code = run_case(&bench, bench.cases[i], each);
    gp_free(each);
    return code;
}
