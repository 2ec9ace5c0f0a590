#include "apps/depth_images/drawing/plane.h"

#include "apps/base/bounds.h"

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

bool depth_range(const DepthPixels *pixels, double range[2])
{
    const size_t count = (size_t)pixels->width * pixels->height;
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (size_t i = 0; i < count; i++)
        if (pixels->depth[i] < DEPTH_NOTHING) {
            range[0] = fmin(range[0], (double)pixels->depth[i]);
            range[1] = fmax(range[1], (double)pixels->depth[i]);
        }
    return range[0] <= range[1];
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
