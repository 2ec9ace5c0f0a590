#include "apps/techniques/volume/model.h"

#include "apps/scene/camera_file.h"

enum { DEFAULT_SIDE = 512 };

/* The cells of the samples, which no volume has without volume. */
static Bounds cells_of(const Field *field)
{
    Bounds bounds;
    for (int k = 0; k < 3; k++) {
        bounds.low[k] = -0.5 * field->scale[k];
        bounds.high[k] = (field->size[k] - 0.5) * field->scale[k];
    }
    return bounds;
}

static GpResult find_view(const TechniqueInput *input, VolumeModel *model, GpError *error)
{
    const VolumeOptions *options = input->setting;
    const Bounds bounds = cells_of(&model->field);
    const bool sized = input->width > 0 && input->height > 0;
    VolumeView *view = &model->view;
    *view = (VolumeView){ .width = sized ? input->width : DEFAULT_SIDE,
                          .height = sized ? input->height : DEFAULT_SIDE,
                          .lit = options->lit };
    view->camera = orbit_camera(&options->orbit, &bounds, (double)view->width / view->height,
                                bounds_longest(&bounds) * 1e-3);
    return options->camera ? camera_read_file(options->camera, &view->camera, error) : GP_OK;
}

GpResult volume_model_open(const TechniqueInput *input, void **made, GpError *error)
{
    const VolumeOptions *options = input->setting;
    VolumeModel *model = gp_alloc(1, sizeof *model);
    if (!model)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = field_open(input->path, &model->field, error);
    if (!result && options->transfer)
        result = transfer_open(options->transfer, &model->field, &model->transfer, error);
    else if (!result)
        transfer_choose(&model->field, &model->transfer);
    if (!result)
        result = find_view(input, model, error);
    if (result) {
        volume_model_close(model);
        return result;
    }
    *made = model;
    return GP_OK;
}

void volume_model_close(void *made)
{
    VolumeModel *model = made;
    volume_picture_free(&model->data);
    volume_picture_free(&model->method);
    field_free(&model->field);
    gp_free(model);
}

/* --- truths ----------------------------------------------------------------------------------- */

GpResult volume_model_data(VolumeModel *model, int threads, GpError *error)
{
    const VolumeSource source = { &model->field, &model->transfer };
    return model->data.rgba
               ? GP_OK
               : volume_truth_of_data(&source, &model->view, threads, &model->data, error);
}

GpResult volume_model_method(VolumeModel *model, const VolumeOptions *options, int threads,
                             GpError *error)
{
    const VolumeSplatSetting *splats = &options->splats;
    const VolumeSource source = { &model->field, &model->transfer };
    const VolumeKernel kernel = { splats->deviation, KERNEL_CUT * splats->deviation,
                                  splats->low_pass };
    if (model->method.rgba && model->kernel.deviation == kernel.deviation &&
        model->kernel.low_pass == kernel.low_pass)
        return GP_OK;
    VolumePicture truth;
    const GpResult result =
        volume_truth_of_kernels(&source, &model->view, &kernel, threads, &truth, error);
    if (result)
        return result;
    volume_picture_free(&model->method);
    model->method = truth;
    model->kernel = kernel;
    return GP_OK;
}
