/* glasspipe render: a scene by its passes, to a picture. */
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/commands/pass_list.h"
#include "apps/commands/render/sequence.h"
#include "apps/frame/passes.h"
#include "apps/frame/picture.h"

#include <string.h>

static const SettingField options[] = {
    { "size", "WxH",
      "Size of the picture in pixels, 1x1 to 32768x32768 (default: the scene's); beyond 8192 it is "
      "drawn by windows",
      SETTING_SIZE, .offset = offsetof(Options, size), 1, GP_MAX_WHOLE },
    { "output", "FILE",
      "Write the picture to FILE: .png, .exr, .pfm or .ppm "
      "(default: out/NAME.png where out/ exists, else NAME.png)",
      SETTING_TEXT, .offset = offsetof(Render, output), .letter = 'o' },
    { "window", "X,Y,WxH",
      "Draw this part of the picture alone, with the bits that the whole has there; \"X,Y,WxH of "
      "WxH\" says "
      "the whole's size too",
      SETTING_TEXT, .offset = offsetof(Render, window) },
    { "path", "FILE", "Draw frames: FILE has keys of camera, lights and objects by time",
      SETTING_TEXT, .offset = offsetof(Render, path) },
    { "turn", "N", "Draw frames: in N of them the camera goes once round what it looks at",
      SETTING_INTEGER, .offset = offsetof(Render, turn), .low = 1, .high = 1000000 },
    { "frames", "A:B[:STEP]",
      "Draw these frames, B included; # in the output's name stands for a digit (default: all of "
      "the path, or of the turn)",
      SETTING_TEXT, .offset = offsetof(Render, frames) },
    OPTIONS_ITEMS,
    { "dump", "PASS",
      "Write what pass PASS (name or number) left in its first "
      "target; PASS.1, PASS.2, PASS.3 for the others, PASS.depth for its depth",
      SETTING_TEXT, .offset = offsetof(Render, dump) },
    { "list-passes", NULL, "Print the passes instead of rendering", SETTING_FLAG,
      .offset = offsetof(Render, list_passes) },
    { "schema", NULL, "Print the JSON Schema of scene files, for editors, instead of rendering",
      SETTING_FLAG, .offset = offsetof(Render, schema) },
    { .name = NULL },
};

/* Whether a window says of how large a picture it is. */
static bool names_whole(const char *window)
{
    return window && strstr(window, " of ");
}

static void check(struct argp_state *state, void *args)
{
    const Render *render = args;
    if (!render->scene && !render->schema)
        argp_error(state, "expected a scene file");
    if (render->scene && render->schema)
        argp_error(state, "--schema is of all scenes, not of one");
    if (render->schema && (render->output || render->dump || render->list_passes ||
                           render->window || render->path || render->turn || render->frames))
        argp_error(state, "--schema draws nothing: expected no option of pictures with it");
    if (render->list_passes && (render->dump || render->output))
        argp_error(state, "--list-passes draws nothing: expected neither --dump nor -o with it");
    if (!render->schema && !render_is_sequence(render) &&
        (render->options.resume || render->options.verify > 0 || render->options.timeout > 0))
        argp_error(state, "--resume, --verify and --timeout are of frames and windows: expected "
                          "--path, --turn or --window with them");
    if (names_whole(render->window) && render->options.size[0])
        argp_error(state, "--size: --window says the whole's size");
    if (render_is_sequence(render) && (render->dump || render->list_passes))
        argp_error(state, "--dump and --list-passes are of one picture, drawn whole");
    if (render->frames && !render->path && !render->turn)
        argp_error(state, "--frames: nothing moves: expected --path or --turn with it");
}

static const CommandSyntax syntax = {
    .shared = OPTIONS_RUN,
    .options = options,
    .arguments = "SCENE.json",
    .help = "Examples:\n"
            "  glasspipe render scenes/default.json\n"
            "  glasspipe render scenes/default.json -o default.exr --size 640x360\n"
            "  glasspipe render scenes/mrt.json --list-passes\n"
            "  glasspipe render scenes/default.json --dump main.depth -o depth.pfm\n"
            "  glasspipe render --schema >scene.schema.json\n"
            "  glasspipe render scenes/default.json --turn 4 --size 160x120 \\\n"
            "      -o 'turn_##.png'\n"
            "  glasspipe render scenes/default.json \\\n"
            "      --window '3000,2000,320x240 of 16384x16384' -o part.png\n"
            "\n"
            "Renders a scene, pass by pass, to a picture, and prints the picture's hash.\v"
            "With --json the frame is rendered a second time, which is the one that is timed; of "
            "frames and "
            "windows the files and hashes are told alone.\n"
            "With --resume what is done is noted in OUTPUT.journal, which is removed at the end.",
    .offset = offsetof(Render, scene),
    .most = 1,
    .check = check,
};

/* --- rendering -------------------------------------------------------------------------------- */

static int draw(const Render *render, const char *path, GpDevice *device, const GpList *list,
                const GpSurface *surface)
{
    GpError error = { "" };
    Output output = { .options = &render->options,
                      .input = render->scene,
                      .path = path,
                      .device = device,
                      .list = list,
                      .surface = surface };
    GpResult result = run_first(device, list, &output.statistics, &error);
    return result ? report(exit_of_run(result), "%s: %s", render->scene, error.text)
                  : output_result(&output);
}

static int render_scene(const Render *render, const char *output, GpDevice *device,
                        const Scene *scene)
{
    GpError error = { "" };
    GpList list = scene->list;
    GpSurface *surface = scene->picture;
    if (render->dump) {
        uint32_t pass;
        if (passes_find_target(&list, render->dump, &surface, &pass, &error))
            return report(EXIT_USAGE, "--dump %s; see --list-passes", error.text);
        list.pass_count = pass + 1;
    }
    return draw(render, output, device, &list, surface);
}

static int list_passes(const Render *render, const GpList *list)
{
    json_t *passes = pass_list_json(list);
    if (render->options.json)
        return output_json(passes ? json_pack("{s:o}", "passes", passes) : NULL);
    if (!passes)
        return report(EXIT_INTERNAL, "out of memory");
    pass_list_print(passes);
    json_decref(passes);
    return EXIT_DONE;
}

int cmd_render(int argc, char **argv)
{
    Render render = { .scene = NULL };
    command_parse(&syntax, NULL, argc, argv, &render);
    if (render.schema)
        return output_json(scene_schema());

    /* Everything that can be refused without reading the scene is refused first. */
    GpError error = { "" };
    char path[4096];
    output_default_path(render.scene, "png", path, sizeof path);
    const char *output = render.output ? render.output : path;
    if (picture_check_path(output, &error))
        return report(EXIT_USAGE, "-o %s", error.text);
    if (render_is_sequence(&render))
        return render_sequence(&render, output);
    GpDevice *device = NULL;
    int code = options_device(&render.options, NULL, &device);
    if (code)
        return code;

    Scene scene = { .picture = NULL };
    code = options_scene(&render.options, render.scene, &scene);
    if (!code)
        code = render.list_passes ? list_passes(&render, &scene.list)
                                  : render_scene(&render, output, device, &scene);
    scene_free(&scene);
    gp_device_destroy(&device);
    return code;
}
