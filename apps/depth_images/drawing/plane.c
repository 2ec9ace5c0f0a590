#include "apps/depth_images/drawing/plane.h"

#include "apps/base/bounds.h"
#include "apps/depth_images/drawing/footprint.h"

void plane_to_world(const DepthPlane *plane, const DepthPixels *pixels, double matrix[4][4])
{
    const double across = plane->width / pixels->width, down = -plane->height / pixels->height;
    const double top = plane->bottom + plane->height;
    const int shift = plane->is_parallel ? 3 : 2; /* what the corner's place is multiplied with */
    matrix_identity(matrix);
    for (int k = 0; k < 3; k++) {
        matrix[k][0] = across * plane->right[k];
        matrix[k][1] = down * plane->up[k];
        matrix[k][2] = plane->forward[k];
        matrix[k][3] = plane->eye[k];
        matrix[k][shift] += plane->left * plane->right[k] + top * plane->up[k];
    }
}

void view_to_clip(const WarpView *view, double matrix[4][4])
{
    double eye[4][4], projection[4][4];
    camera_view(&view->camera, eye);
    camera_projection(&view->camera, (double)view->width / view->height, projection);
    matrix_multiply(projection, eye, matrix);
}

bool depth_extent(const DepthPixels *pixels, DepthExtent *extent)
{
    *extent = (DepthExtent){ .low = { HUGE_VAL, HUGE_VAL, HUGE_VAL },
                             .high = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };
    for (uint32_t y = 0; y < pixels->height; y++)
        for (uint32_t x = 0; x < pixels->width; x++) {
            const float depth = pixels->depth[(size_t)y * pixels->width + x];
            const double at[3] = { x, y, (double)depth };
            for (int k = 0; k < 3 && depth < DEPTH_NOTHING; k++) {
                extent->low[k] = fmin(extent->low[k], at[k]);
                extent->high[k] = fmax(extent->high[k], k < 2 ? at[k] + 1 : at[k]);
            }
        }
    return extent->low[2] <= extent->high[2];
}

void plane_eye(const DepthPlane *plane, const WarpView *view, double eye[4])
{
    const CameraAxes axes = camera_axes(&view->camera, 1);
    const double *image_axes[3] = { plane->right, plane->up, plane->forward };
    const bool is_parallel = !(view->camera.fovy > 0);
    double off[3];
    vector_subtract(view->camera.eye, plane->eye, off);
    for (int k = 0; k < 3; k++)
        eye[k] =
            is_parallel ? -vector_dot(axes.forward, image_axes[k]) : vector_dot(off, image_axes[k]);
    eye[3] = is_parallel ? 0 : 1;
}

const char *plane_warning(const DepthPlane *plane, const DepthExtent *extent, const WarpView *view)
{
    double eye[4];
    plane_eye(plane, view, eye);
    return eye[2] > eye[3] * extent->high[2] ? "the eye sees a planar depth image from behind: the "
                                               "insides of what its own eye saw"
                                             : NULL;
}

uint32_t plane_step(const double center[3], double radius, double pixel, const WarpView *view)
{
    const uint32_t step = footprint_step(center, radius, pixel, view) / 2;
    return step > 1 ? step : 1;
}

void plane_ball(const DepthImage *image, double center[3], double *radius)
{
    const DepthPixels *pixels = &image->front;
    Bounds box = bounds_of_nothing;
    double diagonal[3];
    for (uint32_t y = 0; y < pixels->height; y++)
        for (uint32_t x = 0; x < pixels->width; x++) {
            const float depth = pixels->depth[(size_t)y * pixels->width + x];
            double point[3];
            if (!(depth < DEPTH_NOTHING))
                continue;
            depth_plane_point(&image->plane, pixels, x + 0.5, y + 0.5, (double)depth, point);
            bounds_add(&box, point);
        }
    *radius = 0;
    vector_set(center, 0, 0, 0);
    if (!(box.low[0] <= box.high[0]))
        return;
    for (int k = 0; k < 3; k++)
        center[k] = (box.low[k] + box.high[k]) / 2;
    vector_subtract(box.high, center, diagonal);
    *radius = sqrt(vector_dot(diagonal, diagonal));
}
