/* glasspipe warp capture: depth images as files, of meshes, scenes and pictures with depth. */
#include "apps/commands/warp/capture_args.h"
#include "apps/base/json.h"
#include "apps/base/model_color.h"
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/depth_images/depth_file.h"
#include "pipeline/io/file.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <xxhash.h>

static const char *const kinds[] = {
    [WARP_PLANAR] = "planar", [WARP_CYLINDER] = "cylinder", [WARP_BOX] = "box", NULL
};
static const char *const rays[] = {
    [CAPTURE_COLUMNS] = "columns", [CAPTURE_FACES] = "faces", NULL
};

#define OF(member) offsetof(CaptureArgs, member)

static const SettingField options[] = {
    { "output", "FILE",
      "Write the depth image to FILE, an EXR (default: out/NAME.exr where out/ exists, else "
      "NAME.exr)",
      SETTING_TEXT, .offset = OF(output), .letter = 'o' },
    { "kind", NULL,
      "What is captured of a mesh: planar, a picture (default); cylinder, one that is looked "
      "through from all sides, with its caps; box, six pictures around it",
      SETTING_NAME, .offset = OF(warp.kind), .names = kinds },
    { "source", "CAMERA.json",
      "The camera of a planar image of a mesh, as scenes have it (default: one that sees all of "
      "it, from 30 degrees to the right and 20 above)",
      SETTING_TEXT, .offset = OF(warp.source) },
    { "color", "NAME",
      "Of a mesh: file, its own colours (default where there are any); waves:K, 0.5 + 0.5 sin(K "
      "p); or white, grey, clay, gold, jade or black",
      SETTING_TEXT, .offset = OF(warp.color) },
    { "up", NULL,
      "Of a mesh: which axis points up, of the default camera and of a cylinder: y (default), z, "
      "x, -y or -z",
      SETTING_NAME, .offset = OF(warp.orbit.up), .names = warp_ups },
    { "layers", "N",
      "2, with what is seen behind what is in front, of meshes the default; 1, without, of scenes",
      SETTING_INTEGER, .offset = OF(layers), .low = 1, .high = 2 },
    { "rays", NULL,
      "Of a cylinder: columns, each drawn from its own azimuth (default); faces, as printed, out "
      "of six planar images",
      SETTING_NAME, .offset = OF(rays), .names = rays },
    { "depth-file", "FILE",
      "Depths beside a colour picture: a grey picture of its size, 0 where there is none",
      SETTING_TEXT, .offset = OF(depth) },
    { "camera-file", "FILE",
      "The camera of --depth-file: JSON with intrinsics, depth_unit_m and frames", SETTING_TEXT,
      .offset = OF(camera) },
    { "frame", "NAME", "Which frame of --camera-file (default: the only one)", SETTING_TEXT,
      .offset = OF(frame) },
    { "depth-unit", "M", "What a step of --depth-file is in the world (default: the camera's)",
      SETTING_NUMBER, .offset = OF(unit), .low = 1e-9, .high = 1e9 },
    { "relief", "R",
      "The input is a height map, or has one in --height-file: its white is R above its black",
      SETTING_NUMBER, .offset = OF(relief), .low = 1e-6, .high = 1e6 },
    { "height-file", "FILE", "The heights beside a colour picture, with --relief", SETTING_TEXT,
      .offset = OF(height) },
    { "width", "W", "How wide a height map is in the world (default: 1)", SETTING_NUMBER,
      .offset = OF(width), .low = 1e-6, .high = 1e6 },
    { "write-camera", "FILE",
      "Write the camera of a planar image to FILE, as scenes have it: --camera of glasspipe warp",
      SETTING_TEXT, .offset = OF(write_camera) },
    { .name = NULL },
};

/* Options go with some inputs; what is not a zero was given. */
static void check(struct argp_state *state, void *object)
{
    const CaptureArgs *args = object;
    const CaptureInput input = capture_input(args);
    const bool is_mesh = input == CAPTURE_INPUT_MESH, is_plane = args->warp.kind == WARP_PLANAR;
    double waves;
    GpError error = { "" };
    if (is_mesh && model_waves(args->warp.color, &waves, &error))
        argp_error(state, "%s", error.text);
    if (args->output && gp_path_is_folder(args->output))
        argp_error(state, "-o %s: is a directory", args->output);
    const struct {
        bool is_wrong;
        const char *reason;
    } rules[] = {
        { args->depth && !args->camera, "--depth-file: expected --camera-file with it" },
        { !args->depth && (args->camera || args->frame || args->unit > 0),
          "--camera-file, --frame and --depth-unit are for --depth-file" },
        { args->depth && args->relief > 0,
          "--depth-file and --relief: a picture has the one or the other" },
        { args->height && !(args->relief > 0), "--height-file: expected --relief with it" },
        { !is_mesh && (!is_plane || args->warp.source || args->warp.color || args->warp.orbit.up),
          "--kind, --source, --color and --up are for meshes" },
        { input >= CAPTURE_INPUT_RGBD && args->layers > 0,
          "--layers is for meshes and scenes: pictures have one" },
        { args->warp.source && !is_plane, "--source is for --kind planar" },
        { args->rays != CAPTURE_COLUMNS && (!is_mesh || args->warp.kind != WARP_CYLINDER),
          "--rays is for --kind cylinder" },
        { args->options.size[0] > 0 && input >= CAPTURE_INPUT_RGBD,
          "--size is for meshes and scenes: pictures have their own" },
        { args->width > 0 && input != CAPTURE_INPUT_HEIGHTS, "--width is for --relief" },
        { args->write_camera && !is_plane, "--write-camera is for --kind planar" },
        { args->output && !depth_file_is_readable(args->output),
          "-o: expected a name that ends with .exr" },
    };
    for (size_t i = 0; i < GP_COUNT(rules); i++)
        if (rules[i].is_wrong)
            argp_error(state, "%s", rules[i].reason);
}

static const CommandSyntax syntax = {
    .shared = OPTIONS_FRAME,
    .options = options,
    .arguments = "MESH|SCENE.json|PICTURE",
    .help = "Examples:\n"
            "  glasspipe warp capture builtin:knot --color waves:9 -o knot.exr\n"
            "  glasspipe warp capture builtin:teapot --kind cylinder -o teapot.exr\n"
            "  glasspipe warp capture scenes/default.json -o d.exr --write-camera d.json\n"
            "  glasspipe warp d.exr --camera d.json -o d.png\n"
            "\n"
            "Captures a depth image, a picture whose pixels know how far away is what they show, "
            "into a "
            "file that glasspipe warp draws.\v"
            "A mesh is OFF, OBJ, PLY, STL, OM or builtin:NAME; a scene is captured as it is lit "
            "there; a picture needs --depth-file, as depth cameras take them, or --relief. An "
            "image is 512x512 by default, a box has so many pixels along its longest side.",
    .offset = offsetof(CaptureArgs, input),
    .least = 1,
    .most = 1,
    .expected = "a mesh, a scene or a picture",
    .check = check,
};

/* --- what is said ----------------------------------------------------------------------------- */

/* What a layer of pixels shows. */
typedef struct Shown {
    uint64_t pixels;
    double nearest, farthest;
} Shown;

static Shown shown_of(const DepthPixels *pixels)
{
    Shown shown = { 0, HUGE_VAL, 0 };
    for (size_t i = 0; i < (size_t)pixels->width * pixels->height; i++) {
        const double depth = (double)pixels->depth[i];
        if (!isfinite(depth))
            continue;
        shown.pixels++;
        shown.nearest = depth < shown.nearest ? depth : shown.nearest;
        shown.farthest = depth > shown.farthest ? depth : shown.farthest;
    }
    return shown;
}

/* Of all samples, layer by layer: depths, colours, normals. */
static uint64_t hash_of(const DepthModel *model)
{
    uint64_t hash = 0;
    for (uint32_t i = 0; i < 2 * model->count; i++) {
        const DepthImage *image = &model->images[i / 2];
        const DepthPixels *pixels = i & 1 ? &image->behind : &image->front;
        const size_t bytes = (size_t)pixels->width * pixels->height * sizeof(float);
        const float *const arrays[3] = { pixels->depth, pixels->color, pixels->normal };
        for (int a = 0; a < 3; a++)
            if (bytes > 0 && arrays[a])
                hash = XXH3_64bits_withSeed(arrays[a], a ? 3 * bytes : bytes, hash);
    }
    return hash;
}

static const char *kind_of(const DepthImage *image)
{
    return image->is_cylinder         ? "cylinder"
           : image->plane.is_parallel ? "parallel plane"
                                      : "perspective plane";
}

static json_t *image_json(const DepthImage *image, const Shown *front, const Shown *behind)
{
    return json_pack("{s:s, s:[I, I], s:I, s:I, s:f, s:f}", "kind", kind_of(image), "size",
                     (json_int_t)image->front.width, (json_int_t)image->front.height, "pixels",
                     (json_int_t)front->pixels, "behind", (json_int_t)behind->pixels, "nearest",
                     front->pixels ? front->nearest : 0, "farthest", front->farthest);
}

static void print_image(const DepthImage *image, const Shown *front, const Shown *behind)
{
    printf("%s %ux%u: %" PRIu64 " pixels", kind_of(image), image->front.width, image->front.height,
           front->pixels);
    if (front->pixels)
        printf(", depth %.6g to %.6g", front->nearest, front->farthest);
    if (image->behind.width)
        printf("; behind them %" PRIu64, behind->pixels);
    putchar('\n');
}

static int say(const CaptureArgs *args, const char *file, const DepthModel *model)
{
    json_t *images = json_array();
    char hash[24];
    snprintf(hash, sizeof hash, "%016" PRIx64, hash_of(model));
    if (!args->options.json)
        printf("hash DEPTH_IMAGE %ux%u %s\n", model->images[0].front.width,
               model->images[0].front.height, hash);
    for (uint32_t i = 0; i < model->count; i++) {
        const DepthImage *image = &model->images[i];
        const Shown front = shown_of(&image->front), behind = shown_of(&image->behind);
        if (args->options.json)
            json_array_append_new(images, image_json(image, &front, &behind));
        else
            print_image(image, &front, &behind);
    }
    if (args->options.json)
        return output_json(
            json_pack("{s:s, s:o, s:o}", "hash", hash, "file", json_text(file), "images", images));
    json_decref(images);
    return EXIT_DONE;
}

/* --- the command ------------------------------------------------------------------------------ */

static int write_camera(const char *path, const DepthModel *model)
{
    Camera c;
    GpError error = { "" };
    if (capture_camera(model, &c, &error))
        return report(EXIT_INPUT, "--write-camera: %s", error.text);
    char text[1024];
    const int length = snprintf(
        text, sizeof text,
        "{ \"eye\": [%.17g, %.17g, %.17g],\n  \"at\": [%.17g, %.17g, %.17g],\n"
        "  \"up\": [%.17g, %.17g, %.17g],\n  \"%s\": %.17g, \"near\": %.17g, \"far\": %.17g }\n",
        c.eye[0], c.eye[1], c.eye[2], c.at[0], c.at[1], c.at[2], c.up[0], c.up[1], c.up[2],
        c.fovy > 0 ? "fovy" : "height", c.fovy > 0 ? c.fovy : c.height, c.near, c.far);
    return gp_file_write(path, text, (size_t)length, &error)
               ? report(EXIT_INTERNAL, "%s", error.text)
               : EXIT_DONE;
}

int cmd_warp_capture(int argc, char **argv)
{
    CaptureArgs args = { .warp = warp_option_defaults };
    command_parse(&syntax, NULL, argc, argv, &args);
    char path[4096];
    output_default_path(args.input, "exr", path, sizeof path);
    const char *output = args.output ? args.output : path;
    if (args.options.size[0] > 0)
        memcpy(args.warp.source_size, args.options.size, sizeof args.warp.source_size);

    GpDevice *device = NULL;
    int code = options_device(&args.options, NULL, &device);
    if (code)
        return code;
    DepthModel model = { 0 };
    GpError error = { "" };
    const GpResult result = capture_model(&args, device, &model, &error);
    if (result)
        code = report(exit_of_input(result), "%s", error.text);
    if (!code && args.write_camera)
        code = write_camera(args.write_camera, &model);
    if (!code && depth_file_write(output, &model, &error))
        code = report(EXIT_INTERNAL, "%s", error.text);
    if (!code)
        notice(&args.options, "wrote %s", output);
    if (!code)
        code = say(&args, output, &model);
    depth_model_free(&model);
    gp_device_destroy(&device);
    return code;
}
