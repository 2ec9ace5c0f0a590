/* glasspipe voxelize: a model, or two, as a volume or a picture of it. */
#include "apps/commands/commands.h"
#include "apps/base/json.h"
#include "apps/frame/picture.h"
#include "apps/scene/volume.h"
#include "apps/techniques/voxel/technique.h"
#include "apps/commands/technique_command.h"
#include "apps/techniques/voxel/options.h"
#include "apps/techniques/voxel/result.h"
#include "pipeline/io/file.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

/* --- output ----------------------------------------------------------------------------------- */

static bool is_picture(const char *output)
{
    static const char *const ends[] = { "png", "exr", "pfm", "ppm" };
    char extension[8];
    gp_file_extension(output, extension);
    for (size_t i = 0; i < GP_COUNT(ends); i++)
        if (strcmp(extension, ends[i]) == 0)
            return true;
    return false;
}

static GpResult check_volume(const char *output, const VoxelSetting *setting, GpError *error)
{
    char extension[8];
    struct stat status;
    gp_file_extension(output, extension);
    bool bits = strcmp(extension, "bits") == 0;
    if (!bits && strcmp(extension, "nrrd") != 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "%s: expected a name that ends with .nrrd or .bits, or that of a picture, "
                       ".png, .exr, .pfm or .ppm",
                       output);
    if (bits && setting->bits != 1)
        return gp_fail(error, GP_ERROR_INVALID,
                       "%s: has one bit a voxel, not %u; expected a name that ends with .nrrd",
                       output, setting->bits);
    if (stat(output, &status) == 0 && S_ISDIR(status.st_mode))
        return gp_fail(error, GP_ERROR_INVALID, "%s: is a directory", output);
    return GP_OK;
}

static GpResult check(const char *output, const void *setting, const void *options, GpError *error)
{
    GpError reason;
    GpResult result = is_picture(output) ? picture_check_path(output, &reason)
                                         : check_volume(output, setting, &reason);
    return result ? gp_fail(error, result, "-o %s", reason.text)
                  : voxel_options_check(options, is_picture(output), error);
}

/* --- facts ------------------------------------------------------------------------------------ */

/* Solids are never made of an open mesh without a word. */
static void warn(const char *name, const MeshReport *mesh)
{
    char faults[256];
    mesh_report_faults(mesh, faults, sizeof faults);
    report(0, "warning: %s is not closed: %s", name, faults);
    if (mesh->odd_edges > 0)
        report(0,
               "warning: lines beside these edges may cross an odd number of triangles: the solid "
               "is wrong there");
    else
        report(0, "warning: every line crosses an even number of triangles all the same");
}

/* result: has the facts of the first model, or not */
static GpResult warn_of_open_meshes(const VoxelPair *pair, const VoxelResult *result,
                                    GpError *error)
{
    for (int i = 0; i < 2 && pair->scenes[i]; i++) {
        const bool known = i == 0 && result->has_facts;
        VoxelFacts facts = result->facts;
        if (pair->scenes[i]->input != VOXEL_MESH)
            continue;
        GpResult done = known ? GP_OK : voxel_facts_find(pair->scenes[i], &facts, error);
        if (done)
            return done;
        if (!facts.mesh.is_closed)
            warn(pair->names[i], &facts.mesh);
    }
    return GP_OK;
}

/* Of the first model; told by --report and --json. */
static GpResult find_facts(const TechniqueRun *run, VoxelResult *result, GpError *error)
{
    const VoxelSetting *setting = run->setting;
    const VoxelScene *scene = run->scene;
    const VoxelOptions *options = run->own;
    if (!options->wants_report && !(run->options->json && scene->input == VOXEL_MESH))
        return GP_OK;
    if (scene->input != VOXEL_MESH)
        return gp_fail(error, GP_ERROR_INVALID, "--report is for meshes");
    GpResult done = voxel_facts_find(scene, &result->facts, error);
    if (!done && setting->kind == VOXEL_SOLID)
        done = voxel_facts_find_solids(scene, setting->size, run->device, &result->facts, error);
    result->has_facts = !done;
    return done;
}

/* --- one run ---------------------------------------------------------------------------------- */

static void print_json(const TechniqueRun *run, const Frame *frame, const RunStatistics *statistics,
                       const VoxelResult *result)
{
    char setting[SETTING_MAX_TEXT];
    setting_print(run->technique->fields, run->setting, run->technique->defaults, setting,
                  sizeof setting);
    json_t *object = voxel_result_json(result, statistics, frame->color);
    json_object_set_new(object, "file", json_string(run->output));
    json_object_set_new(object, "setting", json_string(setting));
    json_print(object);
}

/* The first frame is what is written and told; --json times a second one. */
static int draw(const TechniqueRun *run, const VoxelPair *pair, const Frame *frame,
                const VoxelPairMade *made, VoxelResult *result)
{
    const VoxelSetting *setting = run->setting;
    GpError error = { "" };
    RunStatistics statistics;
    GpResult done = run_first(run->device, &frame->list, &statistics, &error);
    if (done)
        return report(exit_of_run(done), "%s: %s", run->input, error.text);
    const bool touching = pair->scenes[1] && pair->combine == VOXEL_TOUCHING;
    if (voxel_result_take(made, is_picture(run->output) ? frame->color : NULL, touching, result))
        return report(EXIT_INTERNAL, "out of memory");
    done = find_facts(run, result, &error);
    if (!done && setting->kind == VOXEL_SOLID)
        done = warn_of_open_meshes(pair, result, &error);
    if (done)
        return report(exit_of_input(done), "%s: %s", run->input, error.text);
    if (voxel_result_write(result, run->output, &error))
        return report(EXIT_INTERNAL, "%s", error.text);
    notice(run->options, "wrote %s", run->output);
    if (run->options->verbose)
        notice(run->options, "%.3f ms, %" PRIu64 " fragments shaded, isa %s", statistics.first_ms,
               statistics.counters.fragments_shaded, statistics.isa);
    if (!run->options->json) {
        voxel_result_print(result);
        return EXIT_DONE;
    }
    done = run_again(run->device, &frame->list, &statistics, &error);
    if (done)
        return report(exit_of_run(done), "%s: %s", run->input, error.text);
    print_json(run, frame, &statistics, result);
    return EXIT_DONE;
}

static GpResult build(const TechniqueRun *run, const VoxelPair *pair, const GpVolume *scan,
                      Frame *frame, VoxelPairMade *made, GpError *error)
{
    const VoxelOptions *options = run->own;
    const VoxelSetting *setting = run->setting;
    const bool to_picture = is_picture(run->output);
    GpResult result = voxel_pair_build(pair, setting, frame, made, error);
    frame->color = made->result.texels;
    if (result || !to_picture)
        return result;
    VoxelPicture picture = options->picture;
    picture.shows_both = pair->scenes[1] && pair->combine == VOXEL_TOUCHING;
    picture.is_solid = setting->kind == VOXEL_SOLID;
    return voxel_picture_build(&picture, made, scan, frame, error);
}

static int build_and_draw(const TechniqueRun *run, const VoxelPair *pair, const GpVolume *scan)
{
    GpError error = { "" };
    Frame frame = { .color = NULL };
    VoxelPairMade made;
    VoxelResult result = { .picture = NULL };
    for (int i = 0; i < 2 && pair->scenes[i]; i++)
        result.triangles += pair->scenes[i]->mesh.triangle_count;
    GpResult done = build(run, pair, scan, &frame, &made, &error);
    int code = done ? report(exit_of_input(done), "%s", error.text)
                    : draw(run, pair, &frame, &made, &result);
    gp_volume_free(&result.volume);
    frame_free(&frame);
    return code;
}

/* --- models and scans ------------------------------------------------------------------------- */

/* A mesh's vertices, where --points asks for them. */
static void take_points(const VoxelOptions *options, VoxelScene *scene)
{
    if (options->wants_points && scene->input == VOXEL_MESH)
        scene->input = VOXEL_POINTS;
}

static void place_first(const VoxelOptions *options, VoxelScene *scene)
{
    take_points(options, scene);
    scene->twist = options->twist;
    scene->is_placed = options->is_placed;
    scene->scale = options->box[0];
    memcpy(scene->offset, options->box + 1, sizeof scene->offset);
}

/* Reads the scan and the second model, where there are any. */
static GpResult open_others(const VoxelOptions *options, VoxelScene *second, GpVolume *scan,
                            GpError *error)
{
    GpResult result = GP_OK;
    if (options->with)
        result = voxel_scene_open(options->with, second, error);
    take_points(options, second);
    return result || !options->scan ? result : volume_open(options->scan, scan, error);
}

/* Of a scan's longest side, where nothing else is said of the model inside. */
#define FIT_IN_SCAN 0.4

static int run_voxelize(const TechniqueRun *run)
{
    const VoxelOptions *options = run->own;
    GpError error = { "" };
    VoxelScene second = { .is_placed = false };
    GpVolume scan = { .data = NULL };
    VoxelPair pair = { .scenes = { run->scene, options->with ? &second : NULL },
                       .names = { run->input, options->with },
                       .place = options->place,
                       .combine = options->combine };
    if (options->scan && !options->is_placed && !(options->place.fit > 0))
        pair.place.fit = FIT_IN_SCAN;
    place_first(options, run->scene);
    GpResult result = open_others(options, &second, &scan, &error);
    int code = result ? report(exit_of_input(result), "%s", error.text)
                      : build_and_draw(run, &pair, options->scan ? &scan : NULL);
    voxel_scene_close(&second);
    gp_volume_free(&scan);
    return code;
}

int cmd_voxelize(int argc, char **argv)
{
    VoxelOptions options = { .picture = voxel_picture_defaults };
    const TechniqueResult result = {
        .input = "a mesh file",
        .output_help =
            "Write the volume to FILE: .nrrd, or .bits, one bit a voxel and nothing else "
            "(default: out/NAME.nrrd where out/ exists, else NAME.nrrd); or a picture of it: .png, "
            ".exr, .pfm or .ppm",
        .extension = "nrrd",
        .count_field = "size",
        .options = voxel_options,
        .parse = voxel_options_parse,
        .check = check,
        .run = run_voxelize,
        .own = &options,
    };
    const TechniqueHelp help = {
        .arguments = "MESH",
        .text =
            "Examples:\n"
            "  glasspipe voxelize meshes/bunny.ply -n 256\n"
            "  glasspipe voxelize meshes/horse.ply --kind solid -o horse.bits\n"
            "  glasspipe voxelize builtin:knot -n 64 --method thin\n"
            "  glasspipe voxelize meshes/dirty/beetle.ply --kind solid --report\n"
            "  glasspipe voxelize implicit:quartic -n 128 -o quartic.png\n"
            "  glasspipe voxelize builtin:cube --kind solid --with builtin:sphere --fit 1.3 \\\n"
            "      --combine difference -o cut.png\n"
            "  glasspipe voxelize builtin:knot --with builtin:torus --combine collide -o hits.png\n"
            "  glasspipe voxelize meshes/bunny.ply --scan volumes/head_small.raw.gz -o head.png\n"
            "\n"
            "Turns a model, or two, into a volume, and prints its hash and how many voxels are "
            "set; or draws a picture of the volume.\v"
            "MESH is OFF, OBJ, PLY, STL or OM, whose vertices are points where it has no faces; "
            "builtin:NAME; implicit:quartic, or implicit: and a polynomial in x, y and z that is "
            "below 0 inside; or parametric:NAME, sphere, torus, moebius, klein or teapot. A "
            "solid of a mesh that is not closed comes with a warning. With --json the volume is "
            "made a second time, which is the one that is timed.",
        .result = &result,
    };
    return technique_command(&voxel_technique, &help, argc, argv);
}
