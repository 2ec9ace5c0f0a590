#include "apps/depth_images/drawing/view_planes.h"

ViewPlanes view_planes(const WarpView *view)
{
    double eye_space[4][4], projection[4][4], clip[4][4];
    ViewPlanes planes;
    camera_view(&view->camera, eye_space);
    camera_projection(&view->camera, (double)view->width / view->height, projection);
    matrix_multiply(projection, eye_space, clip);
    for (int i = 0; i < 6; i++) {
        double *plane = planes.plane[i];
        for (int k = 0; k < 4; k++) {
            const double axis = clip[i / 2][k];
            plane[k] = i == 4 ? axis : i % 2 ? clip[3][k] - axis : clip[3][k] + axis;
        }
        const double length = sqrt(vector_dot(plane, plane));
        for (int k = 0; k < 4; k++)
            plane[k] /= length;
    }
    return planes;
}

bool view_planes_may_see(const ViewPlanes *planes, const double center[3], double radius)
{
    return view_planes_may_see_way(planes, center, center, radius);
}

bool view_planes_may_see_way(const ViewPlanes *planes, const double from[3], const double to[3],
                             double radius)
{
    for (int i = 0; i < 6; i++) {
        const double *plane = planes->plane[i];
        if (fmax(vector_dot(plane, from), vector_dot(plane, to)) + plane[3] < -radius)
            return false;
    }
    return true;
}
