/* Boxes and cylinders about models, against rays in double: every pixel, the seam, caps, models
 * that are thin, on the axis or off it; and how much is lost where faces are sampled a second time,
 * as printed. */
#include "apps/depth_images/making/capture_box.h"
#include "apps/depth_images/making/capture_cylinder.h"
#include "tests/support/depth/depth_case.h"
#include "tests/support/devices.h"
#include "tests/support/groups/device.h"

#include <string.h>

static DepthModel turned(const DepthCase *seen, const CaptureTurn *turn)
{
    DepthModel model;
    GpError error = { "" };
    if (capture_cylinder(device, &(CaptureSource){ &seen->mesh, 3 }, turn, &model, &error))
        fail_msg("%s", error.text);
    assert_true(model.count == 3 && model.images[0].is_cylinder && !model.images[1].is_cylinder);
    return model;
}

/* What rays find of a cylinder's pixels. */
typedef struct Off {
    uint32_t seen, wrong;
    double depth, color; /* means over what both see */
} Off;

static Off off_from_rays(const DepthCase *seen, const DepthImage *image)
{
    const DepthCylinder *cylinder = &image->cylinder;
    const DepthPixels *pixels = &image->front;
    Off off = { 0 };
    uint32_t both = 0;
    for (uint32_t i = 0; i < pixels->width * pixels->height; i++) {
        const double x = i % pixels->width + 0.5, y = i / pixels->width + 0.5;
        double from[3], to[3];
        depth_cylinder_point(cylinder, pixels, x, y, 0, from);
        depth_cylinder_point(cylinder, pixels, x, y, cylinder->radius, to);
        vector_subtract(to, from, to);
        TruthHit hit;
        const bool meets = truth_first_hit(seen->truth, from, to, &hit) && hit.t <= 1;
        off.seen += meets;
        off.wrong += meets != isfinite(pixels->depth[i]);
        if (!meets || !isfinite(pixels->depth[i]))
            continue;
        both++;
        off.depth += fabs((double)pixels->depth[i] - hit.t * cylinder->radius);
        for (uint32_t k = 0; k < 3; k++) {
            const double place = from[k] + hit.t * to[k];
            off.color += fabs((double)pixels->color[3 * i + k] - 0.5 - 0.5 * sin(3 * place)) / 3;
        }
    }
    off.depth /= both ? both : 1;
    off.color /= both ? both : 1;
    return off;
}

/* The issue of two ways: columns are the mesh's own, to a hundredth of what faces are off. */
static void columns_are_what_rays_meet_and_faces_are_near_it(void **state)
{
    (void)state;
    static const char *const models[] = { "builtin:knot", "builtin:teapot" };
    for (size_t m = 0; m < GP_COUNT(models); m++) {
        DepthCase seen;
        depth_case_open(models[m], 1, NULL, &seen);
        Off off[2];
        for (int rays = 0; rays < 2; rays++) {
            const CaptureTurn turn = { .rays = (CaptureRays)rays, .width = 128, .height = 96 };
            DepthModel model = turned(&seen, &turn);
            off[rays] = off_from_rays(&seen, &model.images[0]);
            depth_model_free(&model);
        }
        print_message(
            "# %s: columns %u of %u wrong, depth %.2g, color %.2g; faces %u, %.2g, %.2g\n",
            models[m], off[0].wrong, off[0].seen, off[0].depth, off[0].color, off[1].wrong,
            off[1].depth, off[1].color);
        assert_true(off[0].seen > 2000);
        assert_true(off[0].wrong <= off[0].seen / 400);
        assert_true(off[0].depth < 1e-3 && off[0].color < 2e-3);
        assert_true(off[1].wrong < off[1].seen / 10 && off[1].depth < 0.05);
        assert_true(off[1].depth > 5 * off[0].depth);
        depth_case_close(&seen);
    }
}

/* Whichever axis points up; in front is azimuth 0. */
static void cylinders_stand_along_the_axis_that_points_up(void **state)
{
    (void)state;
    static const double ups[][2][3] = {
        [ORBIT_UP_Y] = { { 0, 1, 0 }, { 0, 0, 1 } },
        [ORBIT_UP_Z] = { { 0, 0, 1 }, { 0, -1, 0 } },
        [ORBIT_UP_X] = { { 1, 0, 0 }, { 0, 0, -1 } },
        [ORBIT_DOWN_Y] = { { 0, -1, 0 }, { 0, 0, -1 } },
        [ORBIT_DOWN_Z] = { { 0, 0, -1 }, { 0, 1, 0 } },
    };
    DepthCase seen;
    depth_case_open("builtin:knot", 1, (double[3]){ 3, -2, 1 }, &seen);
    for (size_t up = 0; up < GP_COUNT(ups); up++) {
        const CaptureTurn turn = { .up = (OrbitUp)up, .width = 96, .height = 64 };
        DepthModel model = turned(&seen, &turn);
        const DepthCylinder *cylinder = &model.images[0].cylinder;
        assert_memory_equal(cylinder->axis, ups[up][0], sizeof cylinder->axis);
        assert_memory_equal(cylinder->zero, ups[up][1], sizeof cylinder->zero);
        for (uint32_t i = 0; i < seen.mesh.vertex_count; i++) {
            double off[3];
            for (int k = 0; k < 3; k++)
                off[k] = (double)seen.mesh.positions[3 * i + (uint32_t)k] - cylinder->center[k];
            const double along = vector_dot(off, cylinder->axis);
            assert_true(fabs(along) < cylinder->height / 2);
            assert_true(vector_dot(off, off) - along * along < cylinder->radius * cylinder->radius);
        }
        const Off off = off_from_rays(&seen, &model.images[0]);
        if (off.seen < 1000 || off.wrong > off.seen / 200 || off.depth > 1e-3)
            fail_msg("%u of %u wrong, depth %g", off.wrong, off.seen, off.depth);
        depth_model_free(&model);
    }
    depth_case_close(&seen);
}

/* The seam lies where the model is, and the model off the origin; a cylinder round another axis. */
static void cylinders_that_stand_anywhere_are_what_rays_meet(void **state)
{
    (void)state;
    DepthCase seen;
    depth_case_open("builtin:torus", 1, (double[3]){ 3, -2, 1 }, &seen);
    CaptureTurn turn = { .width = 90, .height = 70, .behind = true };
    turn.cylinder = (DepthCylinder){ .center = { 3.2, -2, 1.1 },
                                     .axis = { 0.6, 0.8, 0 },
                                     .zero = { 0.8, -0.6, 0 },
                                     .radius = 2.5,
                                     .height = 4 };
    DepthModel model = turned(&seen, &turn);
    const Off off = off_from_rays(&seen, &model.images[0]);
    if (off.seen < 1000 || off.wrong > off.seen / 400 || off.depth > 1e-3)
        fail_msg("%u of %u wrong, depth %g", off.wrong, off.seen, off.depth);
    const DepthImage *wall = &model.images[0];
    uint32_t behind = 0;
    for (uint32_t i = 0; i < 90 * 70; i++) {
        assert_true(isinf(wall->behind.depth[i]) || wall->behind.depth[i] > wall->front.depth[i]);
        behind += isfinite(wall->behind.depth[i]) != 0;
    }
    assert_true(behind > 500);
    depth_model_free(&model);
    depth_case_close(&seen);
}

/* How far points of an image's pixels are from the mesh: along the ray that found them, back and
 * on. */
static void assert_on_mesh(const DepthCase *seen, const DepthImage *image, uint32_t least)
{
    uint32_t shown = 0, off = 0;
    const DepthPixels *pixels = &image->front;
    for (uint32_t i = 0; i < pixels->width * pixels->height; i++) {
        double depth = 0, square[3];
        const bool meets = depth_case_hit(seen, &image->plane, pixels, i % pixels->width + 0.5,
                                          i / pixels->width + 0.5, 0, &depth, square);
        shown += isfinite(pixels->depth[i]) != 0;
        off += meets != isfinite(pixels->depth[i]) ||
               (meets && fabs(depth - (double)pixels->depth[i]) > 0.02);
    }
    if (shown < least || off > shown / 100)
        fail_msg("%u pixels, %u off the mesh", shown, off);
}

static void caps_and_faces_are_what_rays_meet(void **state)
{
    (void)state;
    DepthCase seen;
    depth_case_open("builtin:teapot", 1, NULL, &seen);
    DepthModel model = turned(&seen, &(CaptureTurn){ .width = 120, .height = 40 });
    assert_int_equal(model.images[1].front.width, 60);
    assert_true(model.images[1].plane.forward[1] == -1 && model.images[2].plane.forward[1] == 1);
    assert_on_mesh(&seen, &model.images[1], 1000);
    assert_on_mesh(&seen, &model.images[2], 600);
    depth_model_free(&model);
    assert_int_equal(capture_box(device, &(CaptureSource){ &seen.mesh, 0 }, 70, true, &model, NULL),
                     GP_OK);
    assert_int_equal(model.count, 6);
    for (int i = 0; i < 6; i++) {
        const DepthPlane *plane = &model.images[i].plane;
        double back[3];
        vector_cross(plane->right, plane->up, back);
        for (int k = 0; k < 3; k++)
            assert_true(back[k] == -plane->forward[k]);
        assert_true(plane->forward[i / 2] == (i & 1 ? 1 : -1));
        assert_true(fabs(plane->width / model.images[i].front.width -
                         plane->height / model.images[i].front.height) < 1e-12);
        assert_on_mesh(&seen, &model.images[i], 800);
        assert_int_equal(model.images[i].behind.width, model.images[i].front.width);
    }
    depth_model_free(&model);
    depth_case_close(&seen);
}

/* A square upright through the axis, one that lies flat, one triangle, sizes of one pixel. */
static void thin_models_are_captured(void **state)
{
    (void)state;
    static const char *const models[] = { "builtin:quad", "builtin:disc", "builtin:plane" };
    for (size_t m = 0; m < GP_COUNT(models); m++) {
        DepthCase seen;
        depth_case_open(models[m], 1, NULL, &seen);
        for (uint32_t size = 1; size <= 33; size += 32) {
            DepthModel model = turned(&seen, &(CaptureTurn){ .width = size, .height = size });
            const DepthCylinder *cylinder = &model.images[0].cylinder;
            assert_true(cylinder->radius > 0 && cylinder->height > 0);
            for (uint32_t i = 0; i < size * size; i++)
                assert_true(isinf(model.images[0].front.depth[i]) ||
                            (double)model.images[0].front.depth[i] <=
                                cylinder->radius * (1 + 1e-6));
            if (size > 1)
                assert_on_mesh(&seen, &model.images[1], m ? 120 : 0);
            depth_model_free(&model);
            assert_int_equal(
                capture_box(device, &(CaptureSource){ &seen.mesh, 0 }, size, false, &model, NULL),
                GP_OK);
            depth_model_free(&model);
        }
        depth_case_close(&seen);
    }
}

static void sizes_that_cannot_be_drawn_are_refused(void **state)
{
    (void)state;
    DepthCase seen;
    depth_case_open("builtin:ball", 1, NULL, &seen);
    static const uint32_t sizes[][2] = { { 0, 5 }, { 5, 0 }, { 8193, 5 }, { 5, 8193 } };
    const CaptureSource source = { &seen.mesh, 0 };
    DepthModel model = { .count = 77 };
    for (size_t i = 0; i < GP_COUNT(sizes); i++)
        assert_int_equal(
            capture_cylinder(device, &source,
                             &(CaptureTurn){ .width = sizes[i][0], .height = sizes[i][1] }, &model,
                             NULL),
            GP_ERROR_INVALID);
    assert_int_equal(capture_box(device, &source, 100000, false, &model, NULL), GP_ERROR_INVALID);
    assert_int_equal(model.count, 77);
    depth_case_close(&seen);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_are_what_rays_meet_and_faces_are_near_it),
        cmocka_unit_test(cylinders_stand_along_the_axis_that_points_up),
        cmocka_unit_test(cylinders_that_stand_anywhere_are_what_rays_meet),
        cmocka_unit_test(caps_and_faces_are_what_rays_meet),
        cmocka_unit_test(thin_models_are_captured),
        cmocka_unit_test(sizes_that_cannot_be_drawn_are_refused),
    };
    return cmocka_run_group_tests(tests, device_set_up, device_tear_down);
}
