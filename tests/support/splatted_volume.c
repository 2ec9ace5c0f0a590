#include "tests/support/splatted_volume.h"

#include "apps/truth/volume_kernels.h"
#include "apps/truth/volume_rays.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <math.h>

enum { PIXELS = SPLATTED_SIDE * SPLATTED_SIDE };

static void succeed(GpResult result, const GpError *error)
{
    if (result)
        fail_msg("%s", error->text);
}

void splatted_look(SplattedVolume *volume, const double direction[3], double sides)
{
    double at[3], longest = 0, eye[3], way[3] = { direction[0], direction[1], direction[2] };
    for (int k = 0; k < 3; k++) {
        at[k] = (volume->field.size[k] - 1) * volume->field.scale[k] / 2;
        longest = fmax(longest, 2 * at[k]);
    }
    vector_normalize(way);
    for (int k = 0; k < 3; k++)
        eye[k] = at[k] + way[k] * sides * longest;
    volume->view = (VolumeView){ .camera = { .eye = { eye[0], eye[1], eye[2] },
                                             .at = { at[0], at[1], at[2] },
                                             .up = { 0, 1, 0.01 },
                                             .fovy = 30,
                                             .near = 0.5,
                                             .far = (sides + 3) * longest },
                                 .width = SPLATTED_SIDE,
                                 .height = SPLATTED_SIDE };
}

void splatted_take(Field *field, const char *transfer, const double direction[3], double sides,
                   SplattedVolume *volume)
{
    GpError error = { "" };
    *volume = (SplattedVolume){ .field = *field };
    *field = (Field){ .scale = { 0 } };
    succeed(transfer_open(transfer, &volume->field, &volume->transfer, &error), &error);
    succeed(volume_splats_make(&volume->field, &volume->transfer, &volume->splats, &error), &error);
    splatted_look(volume, direction, sides);
}

void splatted_open(const char *name, const char *transfer, const double direction[3], double sides,
                   SplattedVolume *volume)
{
    GpError error = { "" };
    Field field;
    succeed(field_open(name, &field, &error), &error);
    splatted_take(&field, transfer, direction, sides, volume);
}

void splatted_close(SplattedVolume *volume)
{
    volume_splats_free(&volume->splats);
    field_free(&volume->field);
}

void splatted_build(const SplattedVolume *volume, const VolumeSplatSetting *setting, Frame *frame)
{
    static const float black[4] = { 0 };
    GpError error = { "" };
    VolumeTarget target = volume->target;
    frame->color =
        frame_surface(frame, GP_A32B32G32R32F, volume->view.width, volume->view.height, 1);
    frame_pass(frame, "clear", frame->color, NULL, black);
    target.color = frame->color;
    succeed(volume_splats_add(&volume->splats, &volume->view, setting, &target, frame, &error),
            &error);
}

void splatted_draw(const SplattedVolume *volume, const VolumeSplatSetting *setting, float *rgba)
{
    GpError error = { "" };
    Frame frame = { .color = NULL };
    splatted_build(volume, setting, &frame);
    run_list(&frame.list);
    succeed(gp_surface_read_floats(frame.color, 0, NULL, rgba, &error), &error);
    frame_free(&frame);
}

static VolumeScene scene_of(const SplattedVolume *volume, VolumeStop *stops)
{
    const Field *field = &volume->field;
    VolumeScene scene = { .value = field->value,
                          .stops = stops,
                          .stop_count = volume->transfer.count,
                          .camera = volume->view.camera,
                          .width = volume->view.width,
                          .height = volume->view.height };
    memcpy(scene.size, field->size, sizeof scene.size);
    memcpy(scene.scale, field->scale, sizeof scene.scale);
    for (uint32_t i = 0; i < volume->transfer.count; i++) {
        stops[i].value = volume->transfer.stops[i].value;
        memcpy(stops[i].rgba, volume->transfer.stops[i].rgba, sizeof stops[i].rgba);
    }
    return scene;
}

static void keep_picture(VolumePicture *picture, float *rgba)
{
    for (size_t i = 0; i < 4 * PIXELS; i++)
        rgba[i] = (float)picture->rgba[i];
    volume_picture_free(picture);
}

void splatted_truth_of_method(const SplattedVolume *volume, const VolumeSplatSetting *setting,
                              float *rgba)
{
    VolumeStop stops[TRANSFER_MAX_STOPS];
    const VolumeScene scene = scene_of(volume, stops);
    const VolumeKernels kernels = { .deviation = setting->deviation,
                                    .cut = KERNEL_CUT * setting->deviation,
                                    .low_pass = setting->low_pass,
                                    .rays = volume->rays ? volume->rays : 2 };
    VolumePicture picture;
    GpPool *pool = NULL;
    assert_int_equal(gp_pool_create(2, &pool, NULL), GP_OK);
    assert_int_equal(volume_kernels_picture(&scene, &kernels, pool, &picture), GP_OK);
    gp_pool_destroy(&pool);
    keep_picture(&picture, rgba);
}

void splatted_truth_of_data(const SplattedVolume *volume, float *rgba)
{
    VolumeStop stops[TRANSFER_MAX_STOPS];
    const VolumeScene scene = scene_of(volume, stops);
    VolumePicture picture;
    GpPool *pool = NULL;
    assert_int_equal(gp_pool_create(2, &pool, NULL), GP_OK);
    assert_int_equal(volume_rays_picture(&scene, 1, pool, &picture), GP_OK);
    gp_pool_destroy(&pool);
    keep_picture(&picture, rgba);
}

double splatted_psnr(const float *a, const float *b)
{
    double sum = 0;
    for (size_t i = 0; i < 4 * PIXELS; i++)
        if (i % 4 < 3)
            sum += ((double)a[i] - (double)b[i]) * ((double)a[i] - (double)b[i]);
    return -10 * log10(sum / (3 * PIXELS) + 1e-30);
}

double splatted_difference(const float *a, const float *b)
{
    double sum = 0;
    for (size_t i = 0; i < 4 * PIXELS; i++)
        if (i % 4 < 3)
            sum += fabs((double)a[i] - (double)b[i]);
    return sum / (3 * PIXELS);
}
