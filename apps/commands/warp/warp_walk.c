/* glasspipe warp walk: a way among depth images, frame by frame, with a sheet of pictures. */
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/base/machine.h"
#include "apps/frame/picture.h"
#include "apps/frame/timing.h"
#include "apps/techniques/warp/walk_models.h"

#include <string.h>

enum { MOST_MODELS = 16, MOST_FRAMES = 240, COLUMNS = 4, SHEET_WIDTH = 1920 };

typedef struct WalkCommand {
    Options options; /* first: see options.h */
    const char *output;
    uint32_t size[2], objects, frames, pixels, map, step;
    bool no_shadows;
    const char *names[MOST_MODELS];
    uint32_t name_count;
} WalkCommand;

#define OF(member) offsetof(WalkCommand, member)

static const SettingField options[] = {
    { "output", "FILE",
      "Write the sheet of pictures to FILE: .png, .exr, .pfm or .ppm (default: out/walk.png where "
      "out/ exists, else walk.png)",
      SETTING_TEXT, .offset = OF(output), .letter = 'o' },
    { "size", "WxH", "Size of a frame in pixels (default: 1920x1080)", SETTING_SIZE, OF(size),
      .high = GP_MAX_SIZE },
    { "objects", "N", "How many stand on the field (default: 200)", SETTING_INTEGER, OF(objects),
      .low = 1, .high = 10000 },
    { "frames", "N", "How many frames the way has (default: 24)", SETTING_INTEGER, OF(frames),
      .low = 1, .high = MOST_FRAMES },
    { "pixels", "N", "Columns and rows of each model's cylinder (default: 512)", SETTING_INTEGER,
      OF(pixels), .low = 8, .high = 4096 },
    { "map", "N", "Texels a side of the shadow map (default: 2048)", SETTING_INTEGER, OF(map),
      .low = 16, .high = GP_MAX_SIZE },
    { "step", "N",
      "Pixels from vertex to vertex of all images, a power of two (default: by the distance)",
      SETTING_INTEGER, OF(step), .low = 1, .high = 128 },
    { "no-shadows", NULL, "Without shadows", SETTING_FLAG, .offset = OF(no_shadows) },
    { .name = NULL },
};

static void take_name(struct argp_state *state, void *args, const char *text)
{
    WalkCommand *walk = args;
    if (walk->name_count == MOST_MODELS)
        argp_error(state, "expected at most %d models", MOST_MODELS);
    walk->names[walk->name_count++] = text;
}

static const CommandSyntax syntax = {
    .shared = OPTIONS_RUN,
    .options = options,
    .arguments = "[MESH...]",
    .help =
        "Examples:\n"
        "  glasspipe warp walk --pixels 128 --frames 4\n"
        "  glasspipe warp walk builtin:knot --pixels 96 --objects 60 --size 640x360 \\\n"
        "      -o walk.png\n"
        "\n"
        "Walks among depth images of models, at 1920x1080 unless --size says otherwise, and prints "
        "what each frame takes. Each model is captured as a cylinder with its caps; without a "
        "name there are four builtin ones.\v"
        "The sheet has all frames, four in a row, made smaller. Building a frame, which is to find "
        "what of each object is seen and at which step, is told beside drawing it, which is timed "
        "the second time, when its memory is there.",
    .take = take_name,
};

/* --- the sheet -------------------------------------------------------------------------------- */

static GpResult make_sheet(const WalkCommand *command, Picture *sheet)
{
    const uint32_t rows = (command->frames + COLUMNS - 1) / COLUMNS;
    const uint64_t height = (uint64_t)(SHEET_WIDTH / COLUMNS) * command->size[1] / command->size[0];
    *sheet = (Picture){ .width = SHEET_WIDTH,
                        .height = rows * (uint32_t)(height < 1      ? 1
                                                    : height > 2000 ? 2000
                                                                    : height),
                        .channels = 3 };
    sheet->values = gp_alloc((size_t)sheet->width * sheet->height, 3 * sizeof *sheet->values);
    return sheet->values ? GP_OK : GP_ERROR_MEMORY;
}

/* The mean of the pixels [x0, x1) x [y0, y1), at least one. */
static void mean_of(const float (*rgba)[4], uint32_t width, const uint32_t x[2],
                    const uint32_t y[2], float mean[3])
{
    double sum[3] = { 0 };
    uint32_t count = 0;
    for (uint32_t v = y[0]; v < y[1] || v == y[0]; v++)
        for (uint32_t u = x[0]; u < x[1] || u == x[0]; u++, count++)
            for (int k = 0; k < 3; k++)
                sum[k] += (double)rgba[(size_t)v * width + u][k];
    for (int k = 0; k < 3; k++)
        mean[k] = (float)(sum[k] / count);
}

/* A frame's picture, made smaller, in its place. errors GP_ERROR_MEMORY */
static GpResult add_picture(const GpSurface *color, uint32_t number, uint32_t rows, Picture *sheet)
{
    const uint32_t width = sheet->width / COLUMNS, height = sheet->height / rows;
    float(*rgba)[4] = gp_alloc((size_t)color->width * color->height, sizeof *rgba);
    if (!rgba || gp_surface_read_floats(color, 0, NULL, &rgba[0][0], NULL)) {
        gp_free(rgba);
        return GP_ERROR_MEMORY;
    }
    for (uint32_t v = 0; v < height; v++)
        for (uint32_t u = 0; u < width; u++) {
            const size_t place = (size_t)(number / COLUMNS * height + v) * sheet->width +
                                 number % COLUMNS * width + u;
            const uint32_t x[2] = { u * color->width / width, (u + 1) * color->width / width };
            const uint32_t y[2] = { v * color->height / height, (v + 1) * color->height / height };
            mean_of((const float(*)[4])rgba, color->width, x, y, &sheet->values[3 * place]);
        }
    gp_free(rgba);
    return GP_OK;
}

/* --- the way ---------------------------------------------------------------------------------- */

typedef struct Way {
    const WalkCommand *command;
    const Walk *walk;
    GpDevice *device;
    Picture sheet;
    json_t *frames;
    double *times; /* of frames, building and drawing */
} Way;

static void tell_frame(Way *way, uint32_t number, const WalkCounts *counts, double build_ms,
                       const RunStatistics *run, uint64_t hash)
{
    char text[17];
    snprintf(text, sizeof text, "%016llx", (unsigned long long)hash);
    way->times[number] = build_ms + run->ms;
    if (way->command->options.json)
        json_array_append_new(
            way->frames, json_pack("{s:i, s:i, s:i, s:f, s:f, s:f, s:s}", "objects",
                                   (int)counts->objects, "triangles", (int)counts->triangles,
                                   "shadow_triangles", (int)counts->shadow_triangles, "build_ms",
                                   build_ms, "ms", run->ms, "cpu_ms", run->cpu_ms, "hash", text));
    else
        printf("frame %u: %u objects, %u triangles, %u of shadows, built in %.1f ms, drawn in %.1f "
               "ms, hash %s\n",
               number, counts->objects, counts->triangles, counts->shadow_triangles, build_ms,
               run->ms, text);
}

static GpResult draw_frame(Way *way, uint32_t number, GpError *error)
{
    const WalkCommand *command = way->command;
    const WalkSetting setting = { .map = command->map,
                                  .step = command->step,
                                  .no_shadows = command->no_shadows };
    const Camera camera = walk_camera(way->walk, (double)number / command->frames);
    Frame frame = { .color = NULL };
    WalkCounts counts;
    RunStatistics run = { .ms = 0 };
    const double start = machine_clock_ms(CLOCK_MONOTONIC);
    GpResult result = walk_add(way->walk, &setting, &camera, command->size[0], command->size[1],
                               &frame, &counts, error);
    const double build_ms = machine_clock_ms(CLOCK_MONOTONIC) - start;
    if (!result)
        result = run_first(way->device, &frame.list, &run, error);
    if (!result)
        result = run_again(way->device, &frame.list, &run, error);
    if (!result)
        tell_frame(way, number, &counts, build_ms, &run, gp_surface_hash(frame.color));
    if (!result &&
        add_picture(frame.color, number, (command->frames + COLUMNS - 1) / COLUMNS, &way->sheet))
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    frame_free(&frame);
    return result;
}

/* Median and most. returns the command's exit code */
static int tell_all(Way *way)
{
    const uint32_t count = way->command->frames;
    const double median = timing_median(way->times, count), most = way->times[count - 1];
    if (!way->command->options.json) {
        printf("%.1f ms a frame, at most %.1f\n", median, most);
        return EXIT_DONE;
    }
    return output_json(json_pack("{s:i, s:f, s:f, s:O}", "objects", (int)way->command->objects,
                                 "ms", median, "most_ms", most, "frames", way->frames));
}

static int walk_along(Way *way, const char *path)
{
    GpError error = { "" };
    for (uint32_t i = 0; i < way->command->frames; i++) {
        const GpResult result = draw_frame(way, i, &error);
        if (result)
            return report(exit_of_run(result), "frame %u: %s", i, error.text);
    }
    if (picture_write(path, &way->sheet, NULL, &error))
        return report(EXIT_INTERNAL, "%s", error.text);
    notice(&way->command->options, "wrote %s", path);
    return tell_all(way);
}

/* returns the command's exit code */
static int open_and_walk(const WalkCommand *command, const char *path, GpDevice *device)
{
    const WalkOptions models = { command->names, command->name_count, command->objects,
                                 command->pixels };
    GpError error = { "" };
    Walk walk = { .models = NULL };
    const GpResult result = walk_open_models(device, &models, &walk, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    Way way = { .command = command,
                .walk = &walk,
                .device = device,
                .frames = json_array(),
                .times = gp_alloc(command->frames, sizeof *way.times) };
    int code = EXIT_INTERNAL;
    if (make_sheet(command, &way.sheet) || !way.times)
        report(code, "out of memory");
    else
        code = walk_along(&way, path);
    picture_free(&way.sheet);
    json_decref(way.frames);
    gp_free(way.times);
    walk_close(&walk);
    return code;
}

int cmd_warp_walk(int argc, char **argv)
{
    WalkCommand command = { .size = { 1920, 1080 }, .objects = 200, .frames = 24, .pixels = 512 };
    GpError error = { "" };
    GpDevice *device = NULL;
    char path[4096];
    command_parse(&syntax, NULL, argc, argv, &command);
    output_default_path("walk", "png", path, sizeof path);
    const char *output = command.output ? command.output : path;
    if (picture_check_path(output, &error))
        return report(EXIT_USAGE, "-o %s", error.text);
    int code = options_device(&command.options, NULL, &device);
    if (!code)
        code = open_and_walk(&command, output, device);
    gp_device_destroy(&device);
    return code;
}
