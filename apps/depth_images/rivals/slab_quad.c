#include "apps/depth_images/rivals/slab_quad.h"

#include <string.h>

typedef struct QuadCorner {
    float position[3], at[2];
} QuadCorner;

bool slab_quad(const DepthSlab *slab, double z, const double first[2], const double side[2],
               Frame *frame, GpGeometry *quad)
{
    double box[4][4], world[4][4];
    QuadCorner *corners = frame_alloc(frame, 4, sizeof *corners);
    memcpy(box, slab->matrix, sizeof box);
    if (!corners || matrix_inverse(box, world) == 0)
        return false;
    for (int corner = 0; corner < 4; corner++) {
        const double at[4] = { first[0] + corner % 2 * side[0], first[1] + corner / 2 * side[1], z,
                               1 };
        double point[4] = { 0 };
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < 4; k++)
                point[i] += world[i][k] * at[k];
        for (int i = 0; i < 3; i++)
            corners[corner].position[i] = (float)(point[i] / point[3]);
        for (int i = 0; i < 2; i++)
            corners[corner].at[i] = (float)at[i];
    }
    *quad = (GpGeometry){
        .primitive = GP_TRIANGLE_STRIP,
        .vertex_count = 4,
        .streams = { [GP_POSITION] = { corners->position, sizeof *corners, 3, GP_FLOAT32 },
                     [GP_TEXCOORD0] = { corners->at, sizeof *corners, 2, GP_FLOAT32 } },
    };
    return true;
}

void slab_eye(const DepthSlab *slab, const Camera *camera, double eye[4])
{
    const bool meets = camera->fovy > 0;
    double world[4] = { 0, 0, 0, meets };
    if (meets)
        memcpy(world, camera->eye, sizeof camera->eye);
    else
        vector_subtract(camera->eye, camera->at, world);
    for (int i = 0; i < 4; i++) {
        eye[i] = 0;
        for (int k = 0; k < 4; k++)
            eye[i] += slab->matrix[i][k] * world[k];
    }
}

void slab_metric(const DepthSlab *slab, double metric[3])
{
    for (int k = 0; k < 3; k++) {
        double way[2][3];
        vector_subtract(slab->corners[1 << k], slab->corners[0], way[0]);
        vector_subtract(slab->corners[7], slab->corners[7 - (1 << k)], way[1]);
        metric[k] = (sqrt(vector_dot(way[0], way[0])) + sqrt(vector_dot(way[1], way[1]))) / 2;
    }
}
