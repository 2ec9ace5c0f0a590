#include "apps/techniques/points/technique.h"

#include "apps/techniques/points/experiments.h"
#include "apps/techniques/points/paper_tables.h"
#include "apps/techniques/points/report.h"
#include "apps/techniques/points/scaling.h"
#include "apps/techniques/points/select.h"

static GpResult build(void *made, const void *setting, GpDevice *device, Frame *frame,
                      GpError *error)
{
    PointsModel *model = made;
    const PointsOptions *options = setting;
    SplatSetting splats = options->splats;
    SplatSource source;
    GpResult result = GP_OK;
    splats.method = points_method(options);
    if (options->compress && !splat_takes_compressed(splats.method))
        return gp_fail(error, GP_ERROR_INVALID, "the method does not draw compressed points");
    if (points_needs_patches(options))
        result = points_model_structure(model, options->compress, gp_device_threads(device), error);
    if (!result && splats.method == SPLAT_SEQUENCE)
        result = points_model_sequence(model, error);
    if (!result)
        result = points_select(model, options, frame, &source, error);
    if (!result)
        result = splats_build(&source, &model->view, &splats, frame, error);
    frame->made = frame_copy(frame, options, sizeof *options);
    if (!result)
        result = frame_result(frame, error);
    if (result)
        frame_free(frame);
    return result;
}

const Technique points_technique = {
    .name = "points",
    .arguments = "FILE",
    .input = "a point file or a mesh",
    .summary = "a point model as splats",
    .help =
        "Examples:\n"
        "  glasspipe points builtin:knot\n"
        "  glasspipe points builtin:knot --subdivide 2 --color waves:40 --measure\n"
        "  glasspipe points builtin:torus --sample 20000 --color gold -o torus.png\n"
        "  glasspipe points builtin:knot --subdivide 3 --detail 0.7 --json\n"
        "\n"
        "Draws the points of a model as a surface of splats, and prints the picture's hash.\v"
        "FILE is PLY, XYZ, XYZN or PTS; or a mesh, whose vertices are taken: OFF, OBJ, PLY, STL, "
        "OM or builtin:NAME. Alpha is how much of a pixel the surface covers: EXR has it, and "
        "--output-coverage writes it alone. With --json the frame is drawn a second time, which "
        "is the one that is timed.",
    .settings = points_settings,
    .defaults = &points_option_defaults,
    .setting_bytes = sizeof(PointsOptions),
    .experiments = points_experiments,
    .scaling = &points_scaling,
    .tables = points_tables,
    .check = points_options_check,
    .open = points_model_open,
    .close = points_model_close,
    .build = build,
    .report = points_report,
    .rate = "splats",
    .alpha = "coverage",
};
