#include "apps/techniques/fragments/technique.h"

#include "apps/techniques/fragments/experiments.h"
#include "apps/techniques/fragments/methods.h"
#include "apps/techniques/fragments/paper_tables.h"
#include "apps/techniques/fragments/report.h"
#include "apps/techniques/fragments/scaling.h"

static GpResult build(void *made, const void *setting, GpDevice *device, Frame *frame,
                      GpError *error)
{
    FragmentModel *model = made;
    const FragmentOptions *options = setting;
    const FragmentView *view = &model->view;
    const FragmentMethodRow *method = &fragment_methods[options->method];
    if (view->glass.is_on && !method->has_glass)
        return gp_fail(error, GP_ERROR_INVALID,
                       "--sigma: this method knows no bodies; sorted, convex, dp and ddp do");
    GpResult result = fragment_model_count(model, device, error);
    if (!result && options->method == FRAGMENTS_CONVEX)
        result = fragment_model_convex(model, options, error);
    if (result)
        return result;
    frame->color = frame_surface(frame, GP_A16B16G16R16F, view->width, view->height, 1);
    frame_pass(frame, "background", frame->color, NULL, view->background);
    result = method->add(model, options, frame, error);
    frame->made = frame_copy(frame, options, sizeof *options);
    if (!result)
        result = frame_result(frame, error);
    if (result)
        frame_free(frame);
    return result;
}

const Technique fragment_technique = {
    .name = "fragments",
    .arguments = "MESH",
    .input = "a mesh",
    .summary = "a mesh that is transparent, all its fragments in order",
    .help =
        "Examples:\n"
        "  glasspipe fragments builtin:teapot --size 300x200\n"
        "  glasspipe fragments builtin:knot --alpha 0.2 --from 60 -20 -o knot.exr\n"
        "  glasspipe fragments builtin:knot --sigma 2 --measure --json\n"
        "  glasspipe fragments builtin:torus --method kbuffer --kept 2 --hazard 16 --measure\n"
        "\n"
        "Draws every fragment of a mesh, both sides of its triangles, each over those behind it, "
        "and prints the picture's hash.\v"
        "MESH is a file, looked for as given and then in $GLASSPIPE_DATA, or builtin:NAME; "
        "builtin:spheres:N:C is N layers of spheres, 2 to 96, of C columns each. Each triangle has "
        "one colour. Alpha of the picture is how much of what is behind is hidden, and colours are "
        "multiplied by it: EXR has it, and --output-opacity writes it alone. With --sigma light is "
        "taken on its way through the mesh, which is to be closed, and by its surfaces where they "
        "are seen at a grazing angle.",
    .settings = fragment_settings,
    .defaults = &fragment_option_defaults,
    .setting_bytes = sizeof(FragmentOptions),
    .experiments = fragment_experiments,
    .scaling = &fragment_scaling,
    .tables = fragment_tables,
    .imply = fragment_options_imply,
    .check = fragment_options_check,
    .open = fragment_model_open,
    .close = fragment_model_close,
    .build = build,
    .report = fragment_report,
    .rate = "fragments",
    .alpha = "opacity",
};
