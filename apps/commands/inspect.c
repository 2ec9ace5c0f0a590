/* glasspipe inspect: a frame, stage by stage, as one page of HTML. */
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/commands/progress.h"
#include "apps/inspect/inspect.h"
#include "apps/inspect/lesson_course.h"
#include "apps/techniques/registry.h"
#include "pipeline/io/file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

typedef struct InspectCommand {
    Options options; /* first: see options.h */
    const char *scene, *output, *technique_name, *against, *lesson_path;
    double region[4]; /* x, y, width, height; width 0: none */
    uint32_t draw, pixels;
    bool no_timings, truth;
    const Technique *technique; /* NULL: the scene as it is */
    CommandOptions settings;    /* of the technique */
    const Lesson *lesson;       /* NULL: the page asks nothing */
} InspectCommand;

#define OF(member) offsetof(InspectCommand, member)

static const SettingField options[] = {
    { "output", "FILE",
      "Write the page to FILE (default: out/NAME.html where out/ exists, else NAME.html)",
      SETTING_TEXT, .offset = OF(output), .letter = 'o' },
    { "region", "X Y WIDTH HEIGHT",
      "Record every pixel of this part of the picture whole, with every value of every unit",
      SETTING_VECTOR, .offset = OF(region), .low = 0, .high = 8192, .count = 4 },
    { "draw", "N", "Record the pixels of draw N of the last pass more densely", SETTING_INTEGER,
      .offset = OF(draw), .low = 0, .high = INT32_MAX },
    { "pixels", "N",
      "Record about N pixels whole, on a grid over the picture (default: 1200; of a technique 300)",
      SETTING_INTEGER, .offset = OF(pixels), .low = 1, .high = 1e6 },
    { "technique", "NAME",
      "The frame that a technique draws of the scene; its options may follow, as `glasspipe NAME "
      "--help' has them",
      SETTING_TEXT, .offset = OF(technique_name) },
    { "truth", NULL,
      "Find the exact picture of the technique's scene too, and say of each pixel how far it is "
      "off",
      SETTING_FLAG, .offset = OF(truth) },
    { "against", "OTHER",
      "Compare with another scene or, where it begins with --, with other options of the technique",
      SETTING_TEXT, .offset = OF(against) },
    { "lesson", "PATH",
      "Instead of a scene: ask the question of NAME.lesson.json about the scene NAME.json beside "
      "it; or, "
      "of a folder, all of its lessons, into the folder that -o names (default: out/lessons where "
      "out/ "
      "exists, else lessons), with an index",
      SETTING_TEXT, .offset = OF(lesson_path) },
    { "no-timings", NULL, "Leave out times: the page is then the same on every machine",
      SETTING_FLAG, .offset = OF(no_timings) },
    { .name = NULL },
};

/* A scene or lessons. */
static void check_arguments(struct argp_state *state, void *args)
{
    const InspectCommand *command = args;
    if (!command->scene == !command->lesson_path)
        argp_error(state, command->scene ? "--lesson names its scene: expected no other"
                                         : "expected a scene file, or --lesson");
    if (command->lesson_path && (command->technique_name || command->against))
        argp_error(state, "--lesson asks of a scene as it is: expected neither --technique nor "
                          "--against");
}

static const CommandSyntax syntax = {
    .shared = OPTIONS_FRAME,
    .options = options,
    .arguments = "SCENE.json\n--lesson=PATH",
    .help =
        "Examples:\n"
        "  glasspipe inspect scenes/stencil_outline.json -o outline.html\n"
        "  glasspipe inspect scenes/default.json --size 640x360 --region 300 180 16 16\n"
        "  glasspipe inspect scenes/shadow.json --size 320x240 --technique shadow --method plain\n"
        "  glasspipe inspect --lesson scenes/lessons/03_clipping.lesson.json\n"
        "\n"
        "Draws a scene with everything recorded, and writes one page of HTML that walks "
        "through the frame: draws, targets, every unit's values, the history of every "
        "pixel.\v"
        "The page needs no network. Every fragment of every pixel is in it; all values of "
        "all units are there of chosen pixels, which the page marks.",
    .offset = offsetof(InspectCommand, scene),
    .most = 1,
    .check = check_arguments,
};

/* --- what is drawn ---------------------------------------------------------------------------- */

/* A frame, and what it is made of. */
typedef struct Drawn {
    Scene scene;
    void *opened; /* the technique's */
    Frame frame;
    const GpList *list;
    const GpSurface *picture;
    const Experiment *experiment; /* that knows how far the picture is off */
    float *off;                   /* [height][width]; NULL: unknown */
} Drawn;

static void release(const InspectCommand *command, Drawn *drawn)
{
    gp_free(drawn->off);
    frame_free(&drawn->frame);
    if (drawn->opened)
        command->technique->close(drawn->opened);
    scene_free(&drawn->scene);
}

static GpResult build(const InspectCommand *command, const void *setting, GpDevice *device,
                      Drawn *drawn, GpError *error)
{
    const Technique *technique = command->technique;
    GpResult result = technique->build(drawn->opened, setting, device, &drawn->frame, error);
    if (!result && technique->show)
        result = technique->show(drawn->opened, setting, &drawn->frame, error);
    drawn->list = &drawn->frame.list;
    drawn->picture = frame_picture(&drawn->frame);
    return result;
}

static const Experiment *experiment_of(const Technique *technique)
{
    for (const Experiment *one = technique->experiments; one && one->name; one++)
        if (one->find_truth && one->difference)
            return one;
    return NULL;
}

/* Holds a frame of its own against the truth, since passes may be appended to it. */
static GpResult find_off(const InspectCommand *command, const void *setting, GpDevice *device,
                         Drawn *drawn, GpError *error)
{
    const Technique *technique = command->technique;
    const Experiment *experiment = experiment_of(technique);
    Frame frame = { .color = NULL };
    if (!experiment)
        return gp_fail(error, GP_ERROR_INVALID, "--truth: %s does not know the exact picture",
                       technique->name);
    GpResult result = experiment->find_truth(drawn->opened, gp_device_threads(device), error);
    if (!result)
        result = technique->build(drawn->opened, setting, device, &frame, error);
    if (!result && technique->show)
        result = technique->show(drawn->opened, setting, &frame, error);
    if (!result)
        result = gp_device_run(device, &frame.list, error);
    const GpSurface *picture = result ? NULL : frame_picture(&frame);
    float *off = picture ? gp_alloc((size_t)picture->width * picture->height, sizeof *off) : NULL;
    if (picture && !off)
        result = gp_fail(error, GP_ERROR_MEMORY, "no memory for a picture's truth");
    if (!result)
        result = experiment->difference(drawn->opened, setting, device, &frame, off, error);
    frame_free(&frame);
    if (result) {
        gp_free(off);
        return result;
    }
    drawn->off = off;
    drawn->experiment = experiment;
    return GP_OK;
}

static int open_technique(const InspectCommand *command, const char *path, void *setting,
                          Drawn *drawn)
{
    GpError error = { "" };
    GpDevice *device = NULL;
    const Technique *technique = command->technique;
    const Progress progress = progress_begin(&command->options);
    const TechniqueInput input = { .path = path,
                                   .width = command->options.size[0],
                                   .height = command->options.size[1],
                                   .setting = setting,
                                   .progress = progress_tell,
                                   .user = &progress };
    if (technique->imply)
        technique->imply(setting, command->settings.given);
    if (technique->check && technique->check(setting, command->settings.given, "png", &error))
        return report(EXIT_USAGE, "%s", error.text);
    int code = options_device(&command->options, NULL, &device);
    if (code)
        return code;
    GpResult result = technique->open(&input, &drawn->opened, &error);
    if (!result)
        result = build(command, setting, device, drawn, &error);
    if (!result && command->truth)
        result = find_off(command, setting, device, drawn, &error);
    else if (!result && technique->quick_truth) /* a scene without one is shown without it */
        find_off(command, setting, device, drawn, &(GpError){ "" });
    gp_device_destroy(&device);
    return result ? report(exit_of_input(result), "%s: %s", path, error.text) : EXIT_DONE;
}

static int open_drawn(const InspectCommand *command, const char *path, void *setting, Drawn *drawn)
{
    if (command->technique)
        return open_technique(command, path, setting, drawn);
    if (command->truth)
        return report(EXIT_USAGE, "--truth: exact pictures are a technique's; see --technique");
    const int code = options_scene(&command->options, path, &drawn->scene);
    drawn->list = &drawn->scene.list;
    drawn->picture = drawn->scene.picture;
    return code;
}

/* --- the page --------------------------------------------------------------------------------- */

static Inspect inspect_of(const InspectCommand *command, const Drawn *drawn, const char *title,
                          const Progress *progress)
{
    const double *region = command->region;
    const Lesson *lesson = command->lesson;
    return (Inspect){
        .title = title,
        .technique = command->technique ? command->technique->name : NULL,
        .list = drawn->list,
        .picture = drawn->picture,
        .truth = drawn->off ? (InspectTruth){ drawn->off, drawn->experiment->over,
                                              drawn->experiment->under, drawn->experiment->truth }
                            : (InspectTruth){ .off = NULL },
        .region =
            lesson && region[2] == 0
                ? (GpRect){ lesson->x, lesson->y, lesson->x + 1, lesson->y + 1 }
                : (GpRect){ (int32_t)region[0], (int32_t)region[1],
                            (int32_t)(region[0] + region[2]), (int32_t)(region[1] + region[3]) },
        .lesson = lesson,
        .draw = command->draw == UINT32_MAX ? -1 : (int32_t)command->draw,
        .pixels = command->pixels,
        .no_timings = command->no_timings,
        .threads = (int)command->options.threads,
        .progress = progress_tell,
        .user = progress,
    };
}

static int write_page(const InspectCommand *command, const char *path, const Drawn *drawn,
                      const Drawn *other)
{
    GpError error = { "" };
    Text page;
    char name[128], other_name[128];
    text_stem(command->scene, name, sizeof name);
    text_stem(command->against ? command->against : "", other_name, sizeof other_name);
    const Progress progress = progress_begin(&command->options);
    const Inspect inspect = inspect_of(command, drawn, name, &progress);
    const bool is_setting = command->against && command->against[0] == '-';
    const Inspect against =
        inspect_of(command, other, is_setting ? command->against : other_name, &progress);
    GpResult result = inspect_page(&inspect, command->against ? &against : NULL, &page, &error);
    if (result)
        return report(exit_of_run(result), "%s: %s", command->scene, error.text);
    const size_t bytes = page.length;
    result = text_write(path, &page, &error);
    text_free(&page);
    if (result)
        return report(EXIT_INTERNAL, "%s", error.text);
    if (command->options.json)
        return output_json(json_pack("{s:s, s:I}", "page", path, "bytes", (json_int_t)bytes));
    notice(&command->options, "%s: %.1f MB", path, (double)bytes / 1e6);
    return EXIT_DONE;
}

/* What --against names: a scene, or options on top of the others. owns: the caller frees *setting */
static int open_other(const InspectCommand *command, Drawn *other, void **setting)
{
    GpError error = { "" };
    const Technique *technique = command->technique;
    const bool is_setting = command->against[0] == '-';
    if (is_setting && !technique)
        return report(EXIT_USAGE, "--against %s: options are a technique's; see --technique",
                      command->against);
    if (technique) {
        *setting = gp_alloc(1, technique->setting_bytes);
        if (!*setting)
            return report(EXIT_INTERNAL, "out of memory");
        memcpy(*setting, command->settings.object, technique->setting_bytes);
        if (is_setting && setting_parse(technique->settings, *setting, command->against, &error))
            return report(EXIT_USAGE, "--against %s", error.text);
    }
    return open_drawn(command, is_setting ? command->scene : command->against, *setting, other);
}

static int inspect_frames(InspectCommand *command, const char *path)
{
    Drawn drawn = { .opened = NULL }, other = { .opened = NULL };
    void *setting = NULL;
    int code = open_drawn(command, command->scene, command->settings.object, &drawn);
    if (!code && command->against)
        code = open_other(command, &other, &setting);
    if (!code)
        code = write_page(command, path, &drawn, &other);
    release(command, &drawn);
    release(command, &other);
    gp_free(setting);
    return code;
}

/* --- lessons ---------------------------------------------------------------------------------- */

/* A lesson's page; course: which it is one of, or NULL */
static int inspect_lesson(const InspectCommand *command, Lesson *lesson, const char *path,
                          Course *course)
{
    GpError error = { "" };
    InspectCommand own = *command;
    Drawn drawn = { .opened = NULL };
    own.scene = lesson->scene;
    own.lesson = lesson;
    own.options.json = command->options.json && !course; /* of all at once */
    int code = open_drawn(&own, own.scene, NULL, &drawn);
    if (!code)
        code = write_page(&own, path, &drawn, &drawn);
    if (!code && course && course_add(course, lesson, drawn.picture, &error))
        code = report(EXIT_INTERNAL, "%s", error.text);
    release(&own, &drawn);
    return code;
}

static int inspect_one(const InspectCommand *command)
{
    GpError error = { "" };
    Lesson lesson;
    GpResult result = lesson_open(command->lesson_path, &lesson, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    char path[4096];
    output_default_path(lesson.scene, "html", path, sizeof path);
    const int code =
        inspect_lesson(command, &lesson, command->output ? command->output : path, NULL);
    lesson_close(&lesson);
    return code;
}

static int inspect_of_course(const InspectCommand *command, Course *course, uint32_t number,
                             const char *folder)
{
    GpError error = { "" };
    Lesson lesson;
    GpResult result = lesson_open(course->path[number], &lesson, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    char name[256], previous[256], next[256], path[4096];
    course_page_name(course, number, name, sizeof name);
    course_page_name(course, number - 1, previous, sizeof previous);
    course_page_name(course, number + 1, next, sizeof next);
    lesson.previous = previous[0] ? previous : NULL;
    lesson.next = next[0] ? next : NULL;
    lesson.index = "index.html";
    snprintf(path, sizeof path, "%.3800s/%s", folder, name);
    const int code = inspect_lesson(command, &lesson, path, course);
    lesson_close(&lesson);
    return code;
}

static int write_index(const InspectCommand *command, const Course *course, const char *folder)
{
    GpError error = { "" };
    Text page = { .data = NULL };
    char path[4096];
    course_index(course, folder, &page);
    snprintf(path, sizeof path, "%.4000s/index.html", folder);
    const GpResult result = text_write(path, &page, &error);
    text_free(&page);
    if (result)
        return report(EXIT_INTERNAL, "%s", error.text);
    if (command->options.json)
        return output_json(
            json_pack("{s:s, s:I}", "index", path, "lessons", (json_int_t)course->count));
    notice(&command->options, "%s: %u lessons", path, course->count);
    return EXIT_DONE;
}

static int inspect_course(const InspectCommand *command)
{
    GpError error = { "" };
    Course course;
    const char *folder = command->output            ? command->output
                         : gp_path_is_folder("out") ? "out/lessons"
                                                    : "lessons";
    const GpResult result = course_open(command->lesson_path, &course, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    int code = EXIT_DONE;
    if (mkdir(folder, 0777) != 0 && errno != EEXIST)
        code = report(EXIT_INTERNAL, "%s: %s", folder, strerror(errno));
    for (uint32_t i = 0; i < course.count && !code; i++)
        code = inspect_of_course(command, &course, i, folder);
    if (!code)
        code = write_index(command, &course, folder);
    course_free(&course);
    return code;
}

/* A lesson or a folder of them, where data is found. */
static int inspect_lessons(InspectCommand *command)
{
    GpError error = { "" };
    char path[4096];
    if (gp_data_find(command->lesson_path, path, sizeof path, &error))
        return report(EXIT_INPUT, "%s", error.text);
    command->lesson_path = path;
    return gp_path_is_folder(path) ? inspect_course(command) : inspect_one(command);
}

/* --- options ---------------------------------------------------------------------------------- */

/* The technique that the arguments name: its options are then theirs. */
static const char *technique_asked(int argc, char **argv)
{
    static const char name[] = "--technique";
    for (int i = 1; i < argc; i++)
        if (strncmp(argv[i], name, sizeof name - 1) == 0) {
            const char *rest = argv[i] + sizeof name - 1;
            if (*rest == '=')
                return rest + 1;
            if (!*rest && i + 1 < argc)
                return argv[i + 1];
        }
    return NULL;
}

static int parse_technique(InspectCommand *command, const char *name)
{
    const Technique *technique = technique_find(technique_registry, name);
    if (!technique)
        return report(EXIT_USAGE,
                      "--technique %s: there is no such technique; see glasspipe --help", name);
    void *setting = gp_alloc(1, technique->setting_bytes);
    if (!setting)
        return report(EXIT_INTERNAL, "out of memory");
    memcpy(setting, technique->defaults, technique->setting_bytes);
    command->technique = technique;
    command->settings = (CommandOptions){ .fields = technique->settings, .object = setting };
    return EXIT_DONE;
}

int cmd_inspect(int argc, char **argv)
{
    InspectCommand command = { .draw = UINT32_MAX };
    const char *name = technique_asked(argc, argv);
    const int code = name ? parse_technique(&command, name) : EXIT_DONE;
    if (code)
        return code;
    CommandSyntax own = syntax;
    if (command.technique && setting_find(command.technique->settings, "size"))
        own.shared = OPTIONS_RUN;
    command_parse(&own, command.technique ? &command.settings : NULL, argc, argv, &command);
    if (command.lesson_path)
        return inspect_lessons(&command);
    char path[4096];
    output_default_path(command.scene, "html", path, sizeof path);
    const int result = inspect_frames(&command, command.output ? command.output : path);
    gp_free(command.settings.object);
    return result;
}
