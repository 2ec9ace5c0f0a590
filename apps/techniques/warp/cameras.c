#include "apps/techniques/warp/cameras.h"

#include "apps/base/stable_math.h"

Camera camera_beside(const Bounds *bounds, OrbitUp up, double aspect)
{
    const Orbit orbit = { .azimuth = 30, .elevation = 20, .up = up, .zoom = 1 };
    return orbit_camera(&orbit, bounds, aspect, bounds_longest(bounds) * 1e-3);
}

/* Parallel eyes move back until near is before them. */
static void fit_range(const Bounds *bounds, Camera *camera)
{
    double middle[3], forward[3], radius = 0;
    vector_subtract(camera->at, camera->eye, forward);
    vector_normalize(forward);
    for (int k = 0; k < 3; k++) {
        const double half = (bounds->high[k] - bounds->low[k]) / 2;
        middle[k] = bounds->low[k] + half - camera->eye[k];
        radius += half * half;
    }
    const double distance = vector_dot(middle, forward);
    const double least = distance != 0 ? fabs(distance) * 1e-6 : 1e-6; /* of what is a point */
    radius = radius > 0 ? sqrt(radius) : least;
    if (!(camera->fovy > 0))
        vector_add_scaled(camera->eye, distance - 2 * radius, forward, camera->eye);
    const double ahead = camera->fovy > 0 ? distance : 2 * radius;
    camera->near = fmax(ahead - radius, radius * 1e-3);
    camera->far = fmax(ahead + radius, 2 * camera->near);
}

Camera camera_turned(const Camera *camera, const Bounds *bounds, double degrees)
{
    double turned[4][4], from[3];
    Camera made = *camera;
    matrix_rotation(camera->up, degrees, turned);
    vector_subtract(camera->eye, camera->at, from);
    for (int k = 0; k < 3; k++)
        made.eye[k] = camera->at[k] + vector_dot(turned[k], from);
    fit_range(bounds, &made);
    return made;
}

Camera camera_of_plane(const DepthPlane *plane, const Bounds *bounds)
{
    double middle[3];
    Camera camera = { .up = { plane->up[0], plane->up[1], plane->up[2] } };
    for (int k = 0; k < 3; k++) {
        camera.eye[k] = plane->eye[k];
        middle[k] = (bounds->low[k] + bounds->high[k]) / 2 - plane->eye[k];
    }
    const double ahead = fmax(vector_dot(middle, plane->forward), bounds_longest(bounds) * 1e-3);
    vector_add_scaled(camera.eye, fmax(ahead, 1e-9), plane->forward, camera.at);
    const double half = fmax(fabs(plane->bottom), fabs(plane->bottom + plane->height));
    if (plane->is_parallel)
        camera.height = 2 * half;
    else
        camera.fovy = 2 * stable_atan2(half, 1) * (180 / 3.14159265358979323846);
    fit_range(bounds, &camera);
    return camera;
}

static void add_pixels(const DepthImage *image, const DepthPixels *pixels, Bounds *bounds)
{
    for (size_t at = 0; at < (size_t)pixels->width * pixels->height; at++) {
        const double x = (double)(at % pixels->width) + 0.5, y = (double)(at / pixels->width) + 0.5;
        double point[3];
        if (!isfinite(pixels->depth[at]))
            continue;
        if (image->is_cylinder)
            depth_cylinder_point(&image->cylinder, pixels, x, y, (double)pixels->depth[at], point);
        else
            depth_plane_point(&image->plane, pixels, x, y, (double)pixels->depth[at], point);
        bounds_add(bounds, point);
    }
}

Bounds bounds_of_images(const DepthModel *model)
{
    Bounds bounds = bounds_of_nothing;
    for (uint32_t i = 0; i < model->count; i++) {
        add_pixels(&model->images[i], &model->images[i].front, &bounds);
        add_pixels(&model->images[i], &model->images[i].behind, &bounds);
    }
    if (bounds.low[0] <= bounds.high[0])
        return bounds;
    const DepthImage *first = &model->images[0];
    for (int k = 0; k < 3; k++) {
        const double middle = first->is_cylinder ? first->cylinder.center[k]
                                                 : first->plane.eye[k] + first->plane.forward[k];
        bounds.low[k] = middle - 0.5;
        bounds.high[k] = middle + 0.5;
    }
    return bounds;
}
