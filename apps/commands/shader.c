/* glasspipe shader: a shader file, compiled at once, on a model. */
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/commands/shader_limits.h"
#include "apps/effect/effect.h"
#include "apps/effect/shader_file.h"
#include "apps/frame/picture.h"
#include "pipeline/io/file.h"

#include <math.h>
#include <stdlib.h>

typedef struct ShaderCommand {
    Options options; /* first: see options.h */
    const char *file, *output, *program, *values;
    EffectInput effect;
} ShaderCommand;

#define OF(member) offsetof(ShaderCommand, member)

static const SettingField options[] = {
    { "on", "MODEL", "The model: a mesh file, or builtin:NAME (default: builtin:teapot)",
      SETTING_TEXT, .offset = OF(effect.model) },
    { "output", "FILE",
      "Write the picture to FILE: .png, .exr, .pfm or .ppm "
      "(default: out/NAME.png where out/ exists, else NAME.png)",
      SETTING_TEXT, .offset = OF(output), .letter = 'o' },
    { "program", "NAME", "The program, where the file has several", SETTING_TEXT,
      .offset = OF(program) },
    { "from", "AZIMUTH ELEVATION",
      "Where the model is seen from, in degrees (default: 30 20; 0 0 is in front)", SETTING_VECTOR,
      .offset = OF(effect.orbit.azimuth), .low = -360, .high = 360, .count = 2 },
    { "zoom", "FACTOR", "Larger by so much than what fills the picture", SETTING_NUMBER,
      .offset = OF(effect.orbit.zoom), .low = 0.1, .high = 100 },
    { "texture", "NAME",
      "What its samplers read: a picture, or builtin:NAME (default: builtin:checker)", SETTING_TEXT,
      .offset = OF(effect.texture) },
    { "time", "SECONDS", "The uniform `time` (default: 0)", SETTING_NUMBER,
      .offset = OF(effect.time), .low = -1e6, .high = 1e6 },
    { "values", "A,B,...", "The uniform `values`: up to 8 numbers (default: 0)", SETTING_TEXT,
      .offset = OF(values) },
    { .name = NULL },
};

static void read_values(struct argp_state *state, ShaderCommand *command)
{
    const char *at = command->values;
    for (size_t i = 0; at; i++) {
        char *end;
        const double value = strtod(at, &end);
        if (i == GP_COUNT(command->effect.values) || end == at || !isfinite((float)value) ||
            (*end && *end != ','))
            argp_error(state, "--values: expected up to 8 numbers with commas between, not '%s'",
                       command->values);
        command->effect.values[i] = (float)value;
        at = *end ? end + 1 : NULL;
    }
}

static void check(struct argp_state *state, void *args)
{
    ShaderCommand *command = args;
    if (fabs(command->effect.orbit.elevation) > 89)
        argp_error(state, "--from: expected -360 to 360 and -89 to 89 degrees, not %g %g",
                   command->effect.orbit.azimuth, command->effect.orbit.elevation);
    read_values(state, command);
}

static const CommandSyntax syntax = {
    .shared = OPTIONS_FRAME,
    .options = options,
    .arguments = "FILE.c",
    .help =
        "Examples:\n"
        "  glasspipe shader scenes/shaders/clay.c\n"
        "  glasspipe shader scenes/shaders/waves.c --on builtin:sphere -o waves.png\n"
        "  glasspipe shader scenes/shaders/waves.c --time 0.5 --values 0.2,12\n"
        "\n"
        "Compiles a shader file, draws a model with it, and prints the picture's hash and what "
        "the shaders cost. No project is needed: $CC, cc, gcc or clang compiles, and $CXX, c++, "
        "g++ or clang++ counts. What was compiled is kept in $XDG_CACHE_HOME/glasspipe.\v"
        "The file includes <glasspipe/effect.h>, which says what uniforms and vertices there "
        "are, and holds a whole example. --size is 512x512 by default.\n"
        "Exit code 3: the compiler refuses the file, and has said why.",
    .offset = offsetof(ShaderCommand, file),
    .least = 1,
    .most = 1,
    .expected = "a shader file",
    .check = check,
};

static int draw(const ShaderCommand *command, const char *path, GpDevice *device,
                const Frame *frame, const GpProgram *program)
{
    GpError error = { "" };
    json_t *costs = json_object();
    Output output = { .options = &command->options,
                      .input = command->file,
                      .path = path,
                      .device = device,
                      .list = &frame->list,
                      .surface = frame->color,
                      .members = costs };
    shader_limits_add(costs, program);
    if (!command->options.json)
        shader_limits_print(json_object_get(costs, "vertex_shader"),
                            json_object_get(costs, "pixel_shader"));
    GpResult result = run_first(device, &frame->list, &output.statistics, &error);
    const int code = result ? report(exit_of_run(result), "%s: %s", command->file, error.text)
                            : output_result(&output);
    json_decref(costs);
    return code;
}

static int draw_file(const ShaderCommand *command, const char *output, GpDevice *device)
{
    GpError error = { "" };
    ShaderFile file = { .program = NULL };
    Frame frame = { .color = NULL };
    EffectInput input = command->effect;
    char path[4096];
    GpResult result = gp_data_find(command->file, path, sizeof path, &error);
    if (!result)
        result = shader_file_open(path, command->program, &file, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    input.program = file.program;
    result = effect_build(&input, &frame, &error);
    const int code = result ? report(exit_of_input(result), "%s: %s", command->file, error.text)
                            : draw(command, output, device, &frame, file.program);
    frame_free(&frame);
    shader_file_close(&file);
    return code;
}

int cmd_shader(int argc, char **argv)
{
    ShaderCommand command = { .effect = {
                                  .model = "builtin:teapot",
                                  .texture = "builtin:checker",
                                  .orbit = { .azimuth = 30, .elevation = 20, .zoom = 1 } } };
    command_parse(&syntax, NULL, argc, argv, &command);
    const uint32_t *size = command.options.size;
    command.effect.width = size[0] ? size[0] : 512;
    command.effect.height = size[1] ? size[1] : 512;

    GpError error = { "" };
    char path[4096];
    output_default_path(command.file, "png", path, sizeof path);
    const char *output = command.output ? command.output : path;
    if (picture_check_path(output, &error))
        return report(EXIT_USAGE, "-o %s", error.text);
    GpDevice *device = NULL;
    int code = options_device(&command.options, NULL, &device);
    if (!code)
        code = draw_file(&command, output, device);
    gp_device_destroy(&device);
    return code;
}
