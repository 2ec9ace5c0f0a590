#include "apps/techniques/volume/report.h"

#include "apps/techniques/volume/methods.h"

GpResult volume_error(VolumeModel *model, const VolumeOptions *options, const GpSurface *picture,
                      int threads, VolumeError *off, GpError *error)
{
    const VolumeMethodRow *row = &volume_methods[options->method];
    const bool has_kernels = row->has_kernels && row->has_kernels(options);
    GpResult result = volume_model_data(model, threads, error);
    if (!result && has_kernels)
        result = volume_model_method(model, options, threads, error);
    if (result)
        return result;
    const VolumePicture *method = has_kernels ? &model->method : &model->data;
    off->psnr_data = volume_psnr(volume_rmse(&model->data, picture));
    off->psnr_method = volume_psnr(volume_rmse(method, picture));
    return GP_OK;
}

void volume_tell_size(const VolumeModel *model, const VolumeOptions *options, json_t *members)
{
    const VolumeMethodRow *method = &volume_methods[options->method];
    json_object_set_new(members, "samples", json_integer((json_int_t)field_samples(&model->field)));
    if (method->splats)
        json_object_set_new(members, "splats", json_integer((json_int_t)method->splats(model)));
    json_object_set_new(members, "bytes_per_voxel",
                        json_real(method->bytes_per_voxel(model, options)));
}

/* Stops as a transfer file has them. */
static void tell_transfer(const Transfer *transfer, json_t *members)
{
    json_t *stops = json_array();
    for (uint32_t i = 0; i < transfer->count; i++) {
        const TransferStop *stop = &transfer->stops[i];
        json_array_append_new(stops, json_pack("[f, f, f, f, f]", stop->value, stop->rgba[0],
                                               stop->rgba[1], stop->rgba[2], stop->rgba[3]));
    }
    json_object_set_new(members, "transfer", stops);
}

GpResult volume_report(void *made, const void *setting, const Frame *frame, GpDevice *device,
                       TechniqueReport *report, GpError *error)
{
    VolumeModel *model = made;
    const VolumeOptions *options = setting;
    VolumeError off;
    if (report->members) {
        volume_tell_size(model, options, report->members);
        tell_transfer(&model->transfer, report->members);
    }
    if (!options->measures)
        return GP_OK;
    const GpResult result =
        volume_error(model, options, frame->color, gp_device_threads(device), &off, error);
    if (result)
        return result;
    text_add(&report->lines, "%.2f dB against the data, %.2f dB against the method\n",
             off.psnr_data, off.psnr_method);
    if (report->members) {
        json_object_set_new(report->members, "psnr_data", json_real(off.psnr_data));
        json_object_set_new(report->members, "psnr_method", json_real(off.psnr_method));
    }
    return GP_OK;
}
