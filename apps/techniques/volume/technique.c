#include "apps/techniques/volume/technique.h"

#include "apps/techniques/volume/experiments.h"
#include "apps/techniques/volume/methods.h"
#include "apps/techniques/volume/paper_tables.h"
#include "apps/techniques/volume/report.h"
#include "apps/techniques/volume/scaling.h"

static GpResult build(void *made, const void *setting, GpDevice *device, Frame *frame,
                      GpError *error)
{
    VolumeModel *model = made;
    const VolumeOptions *options = setting;
    const VolumeView *view = &model->view;
    (void)device;
    frame->color = frame_surface(frame, GP_A8R8G8B8, view->width, view->height, 1);
    frame_pass(frame, "background", frame->color, NULL, view->background);
    const VolumeTarget target = { .color = frame->color };
    GpResult result = volume_methods[options->method].add(model, options, &target, frame, error);
    frame->made = frame_copy(frame, options, sizeof *options);
    if (!result)
        result = frame_result(frame, error);
    if (result)
        frame_free(frame);
    return result;
}

static void close_all(void *model)
{
    for (int i = 0; i < VOLUME_METHODS; i++)
        volume_methods[i].close(model);
    volume_model_close(model);
}

const Technique volume_technique = {
    .name = "volume",
    .arguments = "FILE",
    .input = "a volume",
    .summary = "a volume with a transfer function",
    .help =
        "Examples:\n"
        "  glasspipe volume builtin:marschner-lobb:64 --transfer marschner-lobb\n"
        "  glasspipe volume builtin:ball:64 --from 60 -20 --size 300x200 -o ball.png\n"
        "  glasspipe volume builtin:ball:64 --measure --json\n"
        "\n"
        "Draws the samples of a volume as a mist that sends out and takes light, by what a "
        "transfer function says of their values, and prints the picture's hash.\v"
        "FILE is NRRD, raw samples with a JSON beside them, or builtin:marschner-lobb, "
        "builtin:checkerboard or builtin:ball, with :N for N samples a side. Sample (x, y, z) "
        "stands at (x, y, z), farther apart along axes that the file spaces so; the volume ends at "
        "its outermost samples. A transfer file has lines of value, red, green, blue and opacity, "
        "0 to 1 but for the value, which is 0 to 255 for samples of 8 bits; for others the first "
        "stands for the least sample and the last for the greatest. Between its lines it is "
        "straight; the opacity is that of a slab one sample thick. Alpha is how much of what is "
        "behind is hidden, and colours are multiplied by it: EXR has it, and --output-opacity "
        "writes it alone.",
    .settings = volume_settings,
    .defaults = &volume_option_defaults,
    .setting_bytes = sizeof(VolumeOptions),
    .experiments = volume_experiments,
    .scaling = &volume_scaling,
    .tables = volume_tables,
    .imply = volume_options_imply,
    .check = volume_options_check,
    .open = volume_model_open,
    .close = close_all,
    .build = build,
    .report = volume_report,
    .rate = "splats",
    .alpha = "opacity",
};
