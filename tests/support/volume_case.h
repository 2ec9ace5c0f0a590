/* Small volumes, how they are looked at, and their pictures beside the truth of the data. */
#ifndef TESTS_VOLUME_CASE_H
#define TESTS_VOLUME_CASE_H

#include "apps/truth/volume_rays.h"
#include "apps/volumes/drawing/view.h"
#include "tests/support/devices.h"
#include "tests/support/groups/pool.h"
#include "tests/support/unit.h"

#include <math.h>

enum { VOLUME_SIDE = 72 };

/* A volume by name, its samples as far apart as `scale` says; NULL: 1. */
static inline Field volume_field(const char *name, const double scale[3])
{
    Field field;
    GpError error = { "" };
    if (field_open(name, &field, &error))
        fail_msg("%s", error.text);
    for (int i = 0; i < 3 && scale; i++)
        field.scale[i] = scale[i];
    return field;
}

static inline VolumeView volume_view(Camera camera)
{
    return (VolumeView){ .camera = camera, .width = VOLUME_SIDE, .height = VOLUME_SIDE };
}

/* A frame whose pass "below" leaves a target empty, for a method to draw over. */
static inline VolumeTarget volume_target(Frame *frame, GpFormat format)
{
    static const float nothing[4] = { 0 };
    const VolumeTarget target = { frame_surface(frame, format, VOLUME_SIDE, VOLUME_SIDE, 1), NULL };
    frame_pass(frame, "below", target.color, NULL, nothing);
    frame->color = target.color;
    return target;
}

/* 10 log10 (1 / mean square error) of red, green and blue, against the truth of the data.
 * in   depth: [VOLUME_SIDE][VOLUME_SIDE] of opaque things, or NULL */
static inline double volume_psnr(const VolumeSource *source, const VolumeView *view,
                                 const float *depth, const GpSurface *drawn)
{
    static float rgba[VOLUME_SIDE * VOLUME_SIDE][4];
    static VolumeStop stops[TRANSFER_MAX_STOPS];
    const Field *field = source->field;
    VolumeScene scene = { .value = field->value,
                          .stops = stops,
                          .stop_count = source->transfer->count,
                          .camera = view->camera,
                          .width = view->width,
                          .height = view->height,
                          .depth = depth };
    VolumePicture truth = { .rgba = NULL };
    for (uint32_t i = 0; i < scene.stop_count; i++) {
        stops[i].value = source->transfer->stops[i].value;
        memcpy(stops[i].rgba, source->transfer->stops[i].rgba, sizeof stops[i].rgba);
    }
    memcpy(scene.size, field->size, sizeof scene.size);
    memcpy(scene.scale, field->scale, sizeof scene.scale);
    assert_int_equal(volume_rays_picture(&scene, 1, pool, &truth), GP_OK);
    assert_int_equal(gp_surface_read_floats(drawn, 0, NULL, &rgba[0][0], NULL), GP_OK);
    double sum = 0, all = 0;
    for (int i = 0; i < VOLUME_SIDE * VOLUME_SIDE; i++)
        for (int c = 0; c < 3; c++) {
            const double off = (double)rgba[i][c] - truth.rgba[4 * i + c];
            sum += off * off;
            all += truth.rgba[4 * i + c];
        }
    volume_picture_free(&truth);
    assert_true(all > 100); /* there is something to be seen */
    return -10 * log10(sum / (3.0 * VOLUME_SIDE * VOLUME_SIDE));
}

#endif
