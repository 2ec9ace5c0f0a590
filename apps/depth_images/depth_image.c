#include "apps/depth_images/depth_image.h"

#include "apps/base/camera.h"
#include "apps/base/stable_math.h"

/* --- memory ----------------------------------------------------------------------------------- */

GpResult depth_pixels_make(uint32_t width, uint32_t height, bool has_normals, DepthPixels *pixels)
{
    const size_t count = (size_t)width * height;
    DepthPixels made = { .width = width, .height = height };
    made.depth = gp_alloc(count, sizeof *made.depth);
    made.color = gp_alloc(count, 3 * sizeof *made.color);
    made.normal = has_normals ? gp_alloc(count, 3 * sizeof *made.normal) : NULL;
    if (!made.depth || !made.color || (has_normals && !made.normal)) {
        depth_pixels_free(&made);
        return GP_ERROR_MEMORY;
    }
    for (size_t i = 0; i < count; i++)
        made.depth[i] = DEPTH_NOTHING;
    *pixels = made;
    return GP_OK;
}

void depth_pixels_free(DepthPixels *pixels)
{
    gp_free(pixels->depth);
    gp_free(pixels->color);
    gp_free(pixels->normal);
    *pixels = (DepthPixels){ 0 };
}

void depth_model_free(DepthModel *model)
{
    for (uint32_t i = 0; i < model->count; i++) {
        depth_pixels_free(&model->images[i].front);
        depth_pixels_free(&model->images[i].behind);
    }
    *model = (DepthModel){ 0 };
}

/* --- planes ----------------------------------------------------------------------------------- */

void depth_plane_point(const DepthPlane *plane, const DepthPixels *pixels, double x, double y,
                       double depth, double point[3])
{
    const double u = plane->left + x / pixels->width * plane->width;
    const double v = plane->bottom + (1 - y / pixels->height) * plane->height;
    const double spread = plane->is_parallel ? 1 : depth;
    for (int k = 0; k < 3; k++)
        point[k] = plane->eye[k] + depth * plane->forward[k] +
                   spread * (u * plane->right[k] + v * plane->up[k]);
}

bool depth_plane_place(const DepthPlane *plane, const DepthPixels *pixels, const double point[3],
                       double place[2], double *depth)
{
    double off[3];
    vector_subtract(point, plane->eye, off);
    const double z = vector_dot(off, plane->forward);
    if (!plane->is_parallel && !(z > 0))
        return false;
    const double spread = plane->is_parallel ? 1 : z;
    const double u = vector_dot(off, plane->right) / spread;
    const double v = vector_dot(off, plane->up) / spread;
    place[0] = (u - plane->left) / plane->width * pixels->width;
    place[1] = (1 - (v - plane->bottom) / plane->height) * pixels->height;
    *depth = z;
    return true;
}

/* --- cylinders -------------------------------------------------------------------------------- */

void depth_cylinder_point(const DepthCylinder *cylinder, const DepthPixels *pixels, double x,
                          double y, double depth, double point[3])
{
    double sine, cosine, aside[3];
    angle_sincos(360 * (x / pixels->width), &sine, &cosine);
    vector_cross(cylinder->axis, cylinder->zero, aside);
    const double out = cylinder->radius - depth;
    const double up = (0.5 - y / pixels->height) * cylinder->height;
    for (int k = 0; k < 3; k++)
        point[k] = cylinder->center[k] + up * cylinder->axis[k] +
                   out * (cosine * cylinder->zero[k] + sine * aside[k]);
}

bool depth_cylinder_place(const DepthCylinder *cylinder, const DepthPixels *pixels,
                          const double point[3], double place[2], double *depth)
{
    double off[3], aside[3];
    vector_subtract(point, cylinder->center, off);
    vector_cross(cylinder->axis, cylinder->zero, aside);
    const double along = vector_dot(off, cylinder->zero), across = vector_dot(off, aside);
    const double out = sqrt(along * along + across * across);
    if (!(out > 0))
        return false;
    const double turn = stable_atan2(across, along) / 0x1.921fb54442d18p+2;
    place[0] = (turn < 0 ? turn + 1 : turn) * pixels->width;
    place[1] = (0.5 - vector_dot(off, cylinder->axis) / cylinder->height) * pixels->height;
    *depth = cylinder->radius - out;
    return true;
}
