#include "apps/depth_images/making/capture_box.h"

/* The plane of face `face` of a box, looking inwards, with pixels of one size. */
static CaptureShot face_shot(const Bounds *box, int face, double pixel)
{
    const int axis = face / 2, up = axis == 1 ? 2 : 1;
    const double out = face & 1 ? -1 : 1;
    CaptureShot shot = { .plane.is_parallel = true };
    DepthPlane *plane = &shot.plane;
    double normal[3] = { 0 }, extent[2] = { 0 };
    normal[axis] = out;
    plane->forward[axis] = -out;
    plane->up[up] = 1;
    vector_cross(plane->up, normal, plane->right);
    for (int k = 0; k < 3; k++) {
        plane->eye[k] = k != axis ? (box->low[k] + box->high[k]) / 2
                        : out > 0 ? box->high[k]
                                  : box->low[k];
        extent[0] += fabs(plane->right[k]) * (box->high[k] - box->low[k]);
        extent[1] += plane->up[k] * (box->high[k] - box->low[k]);
    }
    shot.width = (uint32_t)fmax(1, ceil(extent[0] / pixel - 1e-9));
    shot.height = (uint32_t)fmax(1, ceil(extent[1] / pixel - 1e-9));
    plane->width = shot.width * pixel;
    plane->height = shot.height * pixel;
    plane->left = -plane->width / 2;
    plane->bottom = -plane->height / 2;
    return shot;
}

GpResult capture_box(GpDevice *device, const CaptureSource *source, uint32_t side, bool behind,
                     DepthModel *model, GpError *error)
{
    Bounds box = capture_bounds(source);
    const double margin = fmax(bounds_longest(&box), 1e-30) / 100;
    for (int k = 0; k < 3; k++) {
        box.low[k] -= margin;
        box.high[k] += margin;
    }
    DepthModel made = { 0 };
    GpResult result = GP_OK;
    for (int face = 0; result == GP_OK && face < 6; face++) {
        CaptureShot shot = face_shot(&box, face, bounds_longest(&box) / (side ? side : 1));
        shot.behind = behind;
        result = capture_planar(device, source, &shot, &made.images[face], error);
        made.count += result == GP_OK;
    }
    if (result == GP_OK)
        *model = made;
    else
        depth_model_free(&made);
    return result;
}
