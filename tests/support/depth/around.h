/* Eyes about a shape, for tests of its depth images. */
#ifndef TESTS_SUPPORT_DEPTH_AROUND_H
#define TESTS_SUPPORT_DEPTH_AROUND_H

#include "apps/depth_images/drawing/view.h"
#include "tests/support/depth/depth_shapes.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <math.h>

enum { AROUND_SIDE = 128 };

/* Looks at the shape's centre; azimuths as its cylinder has them. */
static inline Camera around_camera(const DepthShape *shape, double azimuth, double elevation,
                                   double distance)
{
    Camera camera = { .up = { 0, 1, 0 }, .fovy = 40, .near = 0.01, .far = 50 };
    double sa, ca, se, ce;
    angle_sincos(azimuth, &sa, &ca);
    angle_sincos(elevation, &se, &ce);
    const double way[3] = { ca * ce, se, -sa * ce };
    for (int k = 0; k < 3; k++)
        camera.at[k] = shape->center[k];
    vector_add_scaled(camera.at, distance, way, camera.eye);
    if (fabs(se) > 0.99)
        vector_set(camera.up, 1, 0, 0);
    camera.near = distance > 1 ? distance / 20 : 0.01;
    return camera;
}

/* A frame with a pass "nothing" that clears its target, seen by a camera; lit into floats. */
static inline WarpTarget around_target(Frame *frame, GpFormat format)
{
    static const float nothing[4] = { 0 };
    frame->color = frame_surface(frame, format, AROUND_SIDE, AROUND_SIDE, 1);
    frame->depth = frame_surface(frame, GP_D32F, AROUND_SIDE, AROUND_SIDE, 1);
    frame_pass(frame, "nothing", frame->color, frame->depth, nothing);
    return (WarpTarget){ frame->color, frame->depth };
}

static inline WarpView around_view(const Camera *camera, bool lit)
{
    static const WarpLight light = { .position = { 0.6, 0.8, 0 },
                                     .directional = true,
                                     .color = { 1, 1, 1 },
                                     .ambient = { 0.2f, 0.2f, 0.2f } };
    return (WarpView){
        .camera = *camera, .width = AROUND_SIDE, .height = AROUND_SIDE, .light = lit ? &light : NULL
    };
}

/* Runs a frame and holds it against the shape's truth. */
static inline DepthCompared around_compare(const DepthShape *shape, const Camera *camera,
                                           const Frame *frame)
{
    RayPicture truth = depth_shape_truth(shape, camera, AROUND_SIDE, AROUND_SIDE);
    run_list(&frame->list);
    const DepthCompared compared = depth_compare(&truth, camera, frame->color, frame->depth);
    ray_picture_free(&truth);
    return compared;
}

/* Runs a frame into floats, of which all must be numbers. returns how many pixels are covered */
static inline uint32_t around_finite(const Frame *frame)
{
    static float rgba[AROUND_SIDE * AROUND_SIDE][4];
    uint32_t covered = 0;
    run_list(&frame->list);
    assert_int_equal(gp_surface_read_floats(frame->color, 0, NULL, &rgba[0][0], NULL), GP_OK);
    for (int i = 0; i < AROUND_SIDE * AROUND_SIDE; i++) {
        assert_true(isfinite(rgba[i][0] + rgba[i][1] + rgba[i][2]) && rgba[i][3] <= 1);
        covered += rgba[i][3] > 0;
    }
    return covered;
}

#endif
