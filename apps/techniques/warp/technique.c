#include "apps/techniques/warp/technique.h"

#include "apps/techniques/warp/experiments.h"
#include "apps/techniques/warp/methods.h"
#include "apps/techniques/warp/paper_tables.h"
#include "apps/techniques/warp/report.h"
#include "apps/techniques/warp/scaling.h"

static GpResult build(void *made, const void *setting, GpDevice *device, Frame *frame,
                      GpError *error)
{
    static const float background[4] = { 0 };
    WarpModel *model = made;
    const WarpOptions *options = setting;
    WarpLight light;
    const WarpView view = warp_model_view(model, options, &light);
    frame->color = frame_surface(frame, GP_A8R8G8B8, view.width, view.height, 1);
    frame->depth = frame_surface(frame, GP_D32F, view.width, view.height, 1);
    frame_pass(frame, "background", frame->color, frame->depth, background);
    const WarpTarget target = { .color = frame->color, .depth = frame->depth };
    GpResult result = warp_methods_add(model, options, &view, &target, device, frame, error);
    frame->made = frame_copy(frame, options, sizeof *options);
    if (!result)
        result = frame_result(frame, error);
    if (result)
        frame_free(frame);
    return result;
}

static void close_all(void *model)
{
    warp_methods_close(model);
    warp_model_close(model);
}

static void resolve(const void *model, void *setting)
{
    WarpOptions *options = setting;
    options->method = warp_method_of(model, options);
}

const Technique warp_technique = {
    .name = "warp",
    .arguments = "MESH|IMAGE.exr",
    .input = "a mesh or a depth image",
    .summary = "a picture with depth, moved to a new view",
    .help =
        "Examples:\n"
        "  glasspipe warp builtin:knot\n"
        "  glasspipe warp builtin:teapot --from 50 10 --size 300x200 -o teapot.png\n"
        "  glasspipe warp builtin:knot --color waves:12 --measure --json\n"
        "\n"
        "Captures a mesh as a picture with depth, draws that from another view, and prints the "
        "picture's hash.\v"
        "A mesh is OFF, OBJ, PLY, STL, OM or builtin:NAME. Alpha is 1 where something was drawn: "
        "EXR has it, and --output-coverage writes it alone. With --json the frame is drawn a "
        "second time, which is the one that is timed.",
    .settings = warp_settings,
    .defaults = &warp_option_defaults,
    .setting_bytes = sizeof(WarpOptions),
    .experiments = warp_experiments,
    .scaling = &warp_scaling,
    .tables = warp_tables,
    .imply = warp_options_imply,
    .check = warp_options_check,
    .open = warp_model_open,
    .close = close_all,
    .build = build,
    .resolve = resolve,
    .report = warp_report,
    .rate = "triangles",
    .alpha = "coverage",
};
