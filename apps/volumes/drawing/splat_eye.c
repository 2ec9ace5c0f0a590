#include "apps/volumes/drawing/splat_eye.h"

#include "apps/base/stable_math.h"

#include <math.h>

VoxelEye voxel_eye(const Field *field, const VolumeView *view, const VolumeSplatSetting *setting)
{
    const Camera *camera = &view->camera;
    const CameraAxes axes = camera_axes(camera, (double)view->width / view->height);
    VoxelEye eye = { .focal = view->height / (2 * axes.half_height),
                     .parallel = camera->fovy == 0,
                     .centre = { view->width / 2.0, view->height / 2.0 },
                     .half_width = axes.half_width,
                     .half_height = axes.half_height,
                     .near = camera->near,
                     .least = setting->deviation,
                     .low_pass = setting->cut * setting->low_pass };
    double largest = 0;
    for (int k = 0; k < 3; k++) {
        eye.axis[0][k] = axes.right[k];
        eye.axis[1][k] = -axes.up[k];
        eye.axis[2][k] = axes.forward[k];
        eye.position[k] = camera->eye[k];
        eye.reach = fmax(eye.reach, setting->cut * setting->deviation * field->scale[k]);
        if (fabs(axes.forward[k]) > largest) {
            largest = fabs(axes.forward[k]);
            eye.along = (uint32_t)k;
            eye.falling = axes.forward[k] < 0;
        }
    }
    for (int i = 0; i < 3; i++) {
        eye.row[i][3] = -vector_dot(eye.axis[i], camera->eye);
        for (int k = 0; k < 3; k++)
            eye.row[i][k] = eye.axis[i][k] * field->scale[k];
    }
    return eye;
}

/* W S W^T of kernels that are round in samples. */
static void set_spread(const VoxelEye *eye, const double scale[3], double deviation,
                       float spread[6])
{
    static const int pair[6][2] = { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 } };
    for (int i = 0; i < 6; i++) {
        double sum = 0;
        for (int k = 0; k < 3; k++)
            sum += eye->axis[pair[i][0]][k] * eye->axis[pair[i][1]][k] * scale[k] * scale[k];
        spread[i] = (float)(sum * deviation * deviation);
    }
}

VoxelUniforms voxel_uniforms(const VoxelEye *eye, const Field *field, const VolumeView *view,
                             const VolumeSplatSetting *setting)
{
    const double pi = 3.14159265358979323846, log_2 = stable_log(2);
    const double near = view->camera.near, far = view->camera.far, range = far - near;
    const double cell = field->scale[0] * field->scale[1] * field->scale[2];
    const double edge = setting->cut * setting->cut / 2;
    const double light[3] = { -0.3, -0.4, -1 }, length = sqrt(1.25);
    VoxelUniforms uniforms = {
        .focal = (float)eye->focal,
        .perspective = { eye->parallel ? 0 : 1, eye->parallel ? 1 : 0 },
        .centre = { (float)eye->centre[0], (float)eye->centre[1] },
        .ndc = { 2 / (float)view->width, 2 / (float)view->height },
        .depth = { (float)(eye->parallel ? 1 / range : far / range),
                   (float)(eye->parallel ? -near / range : -far * near / range) },
        .nearest = (float)near,
        .low_pass = (float)(setting->low_pass * setting->low_pass),
        .cut = (float)setting->cut,
        .farthest = (float)(edge / log_2),
        .strength = (float)(cell / (2 * pi * (1 - stable_exp(-edge)))),
        .ambient = view->lit ? 0.25f : 1,
        .diffuse = view->lit ? 0.75f : 0,
    };
    const double half[2] = { eye->half_width, eye->half_height };
    set_spread(eye, field->scale, setting->deviation, uniforms.spread);
    for (int i = 0; i < 2; i++) { /* a ball's distance from a side of the view */
        uniforms.side[i] = (float)(half[i] + eye->low_pass / eye->focal);
        uniforms.reach[i] = (float)(eye->reach * (eye->parallel ? 1 : sqrt(1 + half[i] * half[i])));
    }
    for (int i = 0; i < 3; i++) {
        uniforms.light[i] = (float)(light[i] / length);
        for (int k = 0; k < 4; k++)
            uniforms.eye[i][k] = (float)eye->row[i][k];
        for (int k = 0; k < 3; k++)
            uniforms.normal[i][k] = (float)eye->axis[i][k];
    }
    return uniforms;
}

void voxel_eye_place(const VoxelEye *eye, const double place[3], double at[3])
{
    for (int i = 0; i < 3; i++)
        at[i] = eye->row[i][0] * place[0] + eye->row[i][1] * place[1] + eye->row[i][2] * place[2] +
                eye->row[i][3];
}

/* The longer axis of a footprint that J stretches is at most sqrt(1 + (x^2 + y^2) / z^2) that of
 * the round one. */
double voxel_eye_project(const VoxelEye *eye, const double at[3], double pixel[2])
{
    const double scale = eye->parallel ? eye->focal : eye->focal / at[2];
    for (int i = 0; i < 2; i++)
        pixel[i] = eye->centre[i] + at[i] * scale;
    const double slope = eye->parallel ? 0 : (at[0] * at[0] + at[1] * at[1]) / (at[2] * at[2]);
    return sqrt(1 + slope) * scale * eye->reach + eye->low_pass + 1;
}

double voxel_eye_pixel(const VoxelEye *eye, const double place[3], double pixel[2])
{
    double at[3];
    voxel_eye_place(eye, place, at);
    return at[2] >= eye->near ? voxel_eye_project(eye, at, pixel) : -1;
}
