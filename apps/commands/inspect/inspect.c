/* glasspipe inspect: a frame, stage by stage, as one page of HTML. */
#include "apps/commands/commands.h"
#include "apps/commands/inspect/lessons.h"
#include "apps/commands/inspect/page.h"
#include "apps/commands/output.h"
#include "apps/techniques/registry.h"
#include "pipeline/io/file.h"

#include <math.h>
#include <string.h>

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
      "it; or, of a folder, all of its lessons, into the folder that -o names (default: "
      "out/lessons where out/ exists, else lessons), with an index",
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
    if (command->technique_name
            ? !command->technique || strcmp(command->technique_name, command->technique->name) != 0
            : command->technique != NULL)
        argp_error(state, "--technique is to be written out, and to name one");
    const double *region = command->region;
    for (int i = 0; i < 4; i++)
        if (region[i] != floor(region[i]))
            argp_error(state, "--region: expected whole numbers, not '%g'", region[i]);
    if (region[0] + region[1] + region[2] + region[3] > 0 && (region[2] < 1 || region[3] < 1))
        argp_error(state, "--region: expected a width and a height from 1");
    const char *output = command->output;
    const bool is_course = command->lesson_path && gp_path_is_folder(command->lesson_path);
    if (output && !is_course && (!output[0] || gp_path_is_folder(output)))
        argp_error(state, "-o %s: expected the name of a file to write", output);
}

static const CommandSyntax syntax = {
    .shared = OPTIONS_FRAME,
    .options = options,
    .arguments = "SCENE.json\n--lesson=PATH",
    .help =
        "Examples:\n"
        "  glasspipe inspect scenes/stencil_outline.json -o outline.html\n"
        "  glasspipe inspect scenes/default.json --size 640x360 --region 300 180 16 16\n"
        "  glasspipe inspect scenes/shadow.json --size 320x240 --technique shadow \\\n"
        "      --method plain\n"
        "  glasspipe inspect --lesson scenes/lessons/03_clipping.lesson.json\n"
        "\n"
        "Draws a scene with everything recorded, and writes one page of HTML that walks "
        "through the frame: draws, targets, every unit's values, the history of every "
        "pixel.\v"
        "A page comes from the reference executor, and the fast one is held against it: --executor "
        "is accepted and changes nothing.\n"
        "The page needs no network. Every fragment of every pixel is in it; all values of "
        "all units are there of chosen pixels, which the page marks.",
    .offset = offsetof(InspectCommand, scene),
    .most = 1,
    .check = check_arguments,
};

/* --- two frames ------------------------------------------------------------------------------- */

/* What --against names: a scene, or options on top of the others. owns: the caller frees
 * *setting */
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
    return inspect_open(command, is_setting ? command->scene : command->against, *setting, other);
}

static int inspect_frames(InspectCommand *command, const char *path)
{
    Drawn drawn = { .opened = NULL }, other = { .opened = NULL };
    void *setting = NULL;
    int code = inspect_open(command, command->scene, command->settings.object, &drawn);
    if (!code && command->against)
        code = open_other(command, &other, &setting);
    if (!code)
        code = inspect_write(command, path, &drawn, &other);
    inspect_release(command, &drawn);
    inspect_release(command, &other);
    gp_free(setting);
    return code;
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
    GpDevice *device = NULL;
    const int refused = options_device(&command.options, NULL, &device);
    gp_device_destroy(&device);
    if (refused)
        return refused;
    if (command.lesson_path)
        return inspect_lessons(&command);
    char path[4096];
    output_default_path(command.scene, "html", path, sizeof path);
    const int result = inspect_frames(&command, command.output ? command.output : path);
    gp_free(command.settings.object);
    return result;
}
