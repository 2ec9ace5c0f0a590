#include "apps/base/reach.h"

bool reach_find(double corners[8][3], const Camera *camera, const CameraAxes *axes, double reach[2])
{
    double nearest = HUGE_VAL, farthest = -HUGE_VAL;
    for (int corner = 0; corner < 8; corner++) {
        double distance = 0;
        for (int i = 0; i < 3; i++)
            distance += (corners[corner][i] - camera->eye[i]) * axes->forward[i];
        nearest = fmin(nearest, distance);
        farthest = fmax(farthest, distance);
    }
    reach[0] = fmax(nearest, camera->near);
    reach[1] = fmin(farthest, camera->far);
    return reach[0] < reach[1];
}

GpRect reach_rect(double corners[8][3], const Camera *camera, const CameraAxes *axes,
                  uint32_t width, uint32_t height)
{
    const double half[2] = { axes->half_width, axes->half_height };
    const double size[2] = { width, height };
    double low[2] = { 1, 1 }, high[2] = { -1, -1 };
    for (int corner = 0; corner < 8; corner++) {
        double at[3] = { 0 };
        for (int i = 0; i < 3; i++) {
            const double off = corners[corner][i] - camera->eye[i];
            at[0] += off * axes->right[i];
            at[1] -= off * axes->up[i];
            at[2] += off * axes->forward[i];
        }
        for (int i = 0; i < 2; i++) {
            const double place = at[i] / (half[i] * (camera->fovy > 0 ? at[2] : 1));
            low[i] = fmin(low[i], at[2] < camera->near ? -1 : fmax(place, -1));
            high[i] = fmax(high[i], at[2] < camera->near ? 1 : fmin(place, 1));
        }
    }
    int32_t pixels[2][2];
    for (int i = 0; i < 2; i++) {
        pixels[0][i] = (int32_t)floor((low[i] + 1) / 2 * size[i]) - 1;
        pixels[1][i] = (int32_t)ceil((high[i] + 1) / 2 * size[i]) + 1;
    }
    return gp_rect_common((GpRect){ pixels[0][0], pixels[0][1], pixels[1][0], pixels[1][1] },
                          (GpRect){ 0, 0, (int32_t)width, (int32_t)height });
}

void reach_depth(const Camera *camera, const double reach[2], float depth[4])
{
    const double near = camera->near, far = camera->far, way = reach[1] - reach[0];
    const bool meet = camera->fovy > 0;
    depth[0] = (float)((reach[0] - near) * (meet ? far : 1));
    depth[1] = (float)(way * (meet ? far : 1));
    depth[2] = (float)((far - near) * (meet ? reach[0] : 1));
    depth[3] = (float)(meet ? (far - near) * way : 0);
}
