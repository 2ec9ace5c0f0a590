#include "apps/truth/volume_picture.h"

#include <math.h>

void volume_classify(const VolumeScene *scene, double value, double rgba[4])
{
    const VolumeStop *above = scene->stops, *end = above + scene->stop_count;
    while (above < end && above->value <= value)
        above++;
    const VolumeStop *a = above > scene->stops ? above - 1 : above, *b = above < end ? above : a;
    const double share = a < b ? (value - a->value) / (b->value - a->value) : 0;
    for (int c = 0; c < 4; c++)
        rgba[c] = (1 - share) * a->rgba[c] + share * b->rgba[c];
}

double volume_extinction(double opacity)
{
    return -log1p(-fmin(opacity, 1 - 0x1p-24));
}

VolumeEye volume_eye(const VolumeScene *scene)
{
    return (VolumeEye){ scene, camera_axes(&scene->camera, (double)scene->width / scene->height) };
}

/* How far along the view the opaque thing of a pixel is; infinite where there is none. */
static double opaque_distance(const VolumeScene *scene, double x, double y)
{
    const Camera *camera = &scene->camera;
    const uint32_t column = (uint32_t)fmin(fmax(x, 0), scene->width - 1.0),
                   row = (uint32_t)fmin(fmax(y, 0), scene->height - 1.0);
    if (!scene->depth)
        return (double)INFINITY;
    const double depth = (double)scene->depth[(size_t)row * scene->width + column];
    if (depth >= 1)
        return (double)INFINITY;
    const double length = camera->far - camera->near;
    return camera->fovy > 0 ? camera->far * camera->near / (camera->far - depth * length)
                            : camera->near + depth * length;
}

/* Cuts a ray to the part between two planes of an axis. */
static void cut(VolumeRay *ray, int axis, double low, double high)
{
    const double begin = ray->begin[axis], way = ray->way[axis];
    if (way == 0) {
        if (begin < low || begin > high)
            ray->high = ray->low;
        return;
    }
    const double a = (low - begin) / way, b = (high - begin) / way;
    ray->low = fmax(ray->low, fmin(a, b));
    ray->high = fmin(ray->high, fmax(a, b));
}

VolumeRay volume_ray(const VolumeEye *eye, double x, double y, double margin)
{
    const VolumeScene *scene = eye->scene;
    const CameraAxes *axes = &eye->axes;
    const double right = (2 * x / scene->width - 1) * axes->half_width,
                 up = (1 - 2 * y / scene->height) * axes->half_height;
    const bool is_parallel = !(scene->camera.fovy > 0);
    double way[3];
    VolumeRay ray;
    for (int k = 0; k < 3; k++) {
        const double across = right * axes->right[k] + up * axes->up[k];
        way[k] = axes->forward[k] + (is_parallel ? 0 : across);
        ray.begin[k] = (scene->camera.eye[k] + (is_parallel ? across : 0)) / scene->scale[k];
    }
    const double length = sqrt(vector_dot(way, way));
    const double opaque = opaque_distance(scene, x, y);
    ray.low = scene->camera.near * length;
    ray.high = fmin(scene->camera.far, opaque) * length;
    for (int k = 0; k < 3; k++) {
        ray.way[k] = way[k] / length / scene->scale[k];
        cut(&ray, k, -margin, scene->size[k] - 1 + margin);
    }
    return ray;
}

GpResult volume_picture_create(uint32_t width, uint32_t height, VolumePicture *picture)
{
    double *rgba = gp_alloc((size_t)width * height, 4 * sizeof *rgba);
    if (!rgba)
        return GP_ERROR_MEMORY;
    *picture = (VolumePicture){ width, height, rgba };
    return GP_OK;
}

void volume_picture_free(VolumePicture *picture)
{
    gp_free(picture->rgba);
    *picture = (VolumePicture){ .width = 0 };
}
