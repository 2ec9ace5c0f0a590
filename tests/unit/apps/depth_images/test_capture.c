/* Captured layers against rays in double: coverage, depth, colour and normal, from cameras and from
 * planes that stand anywhere; models far from the origin; what is behind; the same bits
 * everywhere. */
#include "tests/support/depth/depth_case.h"
#include "tests/support/devices.h"
#include "tests/support/groups/device.h"

#include <string.h>

enum { W = 96, H = 72 };

static DepthImage captured(const DepthCase *seen, double waves, const CaptureShot *shot)
{
    DepthImage image;
    GpError error = { "" };
    if (capture_planar(device, &(CaptureSource){ &seen->mesh, waves }, shot, &image, &error))
        fail_msg("%s", error.text);
    assert_true(!image.is_cylinder && image.front.width == shot->width);
    assert_true(image.front.height == shot->height && image.front.normal);
    return image;
}

static void image_free(DepthImage *image)
{
    depth_pixels_free(&image->front);
    depth_pixels_free(&image->behind);
}

static CaptureShot shot_of(const Camera *camera)
{
    return (CaptureShot){ .plane = depth_plane_of_camera(camera, (double)W / H),
                          .width = W,
                          .height = H,
                          .behind = true };
}

static const Camera over_there = { { 1.5, 2, 3 }, { 0.1, 0, 0 }, { 0, 1, 0 },
                                   .fovy = 40,    .near = 0.1,   .far = 20 };

/* How the pixels of a front layer are off from rays: those covered wrongly, and the largest error
 * of depth, in parts of what 1/256 of a pixel and the surface's slope allow. */
typedef struct Off {
    uint32_t covered, wrong;
    double depth, color, normal;
} Off;

static Off off_from_rays(const DepthCase *seen, const DepthImage *image, double waves)
{
    Off off = { 0 };
    for (uint32_t i = 0; i < image->front.width * image->front.height; i++) {
        const double x = i % image->front.width + 0.5, y = i / image->front.width + 0.5;
        double depth = (double)DEPTH_NOTHING, square[3], direction[3], place[3], a[3];
        const bool meets =
            depth_case_hit(seen, &image->plane, &image->front, x, y, 0, &depth, square);
        off.covered += meets;
        if (meets != isfinite(image->front.depth[i])) {
            off.wrong++;
            continue;
        }
        if (!meets)
            continue;
        depth_plane_point(&image->plane, &image->front, x, y, depth, place);
        depth_plane_point(&image->plane, &image->front, x, y, depth + 1, direction);
        depth_plane_point(&image->plane, &image->front, x + 1, y, depth, a);
        vector_subtract(direction, place, direction);
        vector_subtract(a, place, a);
        const double pixel = sqrt(vector_dot(a, a)), cosine = fabs(vector_dot(direction, square));
        const double error = fabs((double)image->front.depth[i] - depth);
        if (cosine < 0.05 || error > 30 * pixel) /* edges, where another triangle may be met */
            continue;
        const double room = pixel / 128 / cosine + 0x1p-20 * depth;
        off.depth = fmax(off.depth, error / room);
        double length = 0;
        for (uint32_t k = 0; k < 3; k++) {
            const double n = (double)image->front.normal[3 * i + k];
            const double c = (double)image->front.color[3 * i + k];
            const double wanted = waves > 0 ? 0.5 + 0.5 * sin(waves * place[k]) : 1;
            off.color = fmax(off.color, fabs(c - wanted) / (1e-5 + waves * room));
            length += n * n;
        }
        off.normal = fmax(off.normal, fabs(length - 1));
    }
    return off;
}

static void assert_near(const DepthCase *seen, const DepthImage *image, double waves)
{
    const Off off = off_from_rays(seen, image, waves);
    assert_true(off.covered > 500);
    if (off.wrong > off.covered / 400 || off.depth > 1 || off.color > 1 || off.normal > 1e-5)
        fail_msg("%u of %u wrong, depth %g, color %g, normal %g", off.wrong, off.covered, off.depth,
                 off.color, off.normal);
}

static void images_of_cameras_are_what_rays_meet(void **state)
{
    (void)state;
    DepthCase knot;
    depth_case_open("builtin:knot", 1, NULL, &knot);
    Camera camera = over_there;
    for (int parallel = 0; parallel < 2; parallel++) {
        camera.fovy = parallel ? 0 : 40;
        camera.height = 3;
        const CaptureShot shot = shot_of(&camera);
        assert_true(shot.plane.is_parallel == parallel);
        DepthImage image = captured(&knot, 7, &shot);
        assert_near(&knot, &image, 7);
        image_free(&image);
        image = captured(&knot, 0, &shot);
        assert_near(&knot, &image, 0);
        image_free(&image);
    }
    depth_case_close(&knot);
}

/* A window beside the eye's middle is a part of the larger picture, pixel by pixel. */
static void pictures_beside_the_middle_are_what_rays_meet(void **state)
{
    (void)state;
    DepthCase knot;
    depth_case_open("builtin:knot", 1, NULL, &knot);
    CaptureShot shot = shot_of(&over_there);
    shot.plane.left *= 0.75;
    shot.plane.bottom *= 0.5;
    shot.plane.width /= 2;
    shot.plane.height /= 2;
    DepthImage image = captured(&knot, 5, &shot);
    assert_near(&knot, &image, 5);
    image_free(&image);
    depth_case_close(&knot);
}

/* Floats at a million are 1/16 apart, so the mesh itself is coarse; but it is captured as it is. */
static void models_far_from_the_origin_lose_nothing_more(void **state)
{
    (void)state;
    const double far_off[3] = { 1e6, -5e5, 25e4 };
    DepthCase torus;
    depth_case_open("builtin:torus", 10, far_off, &torus);
    Camera camera = over_there;
    for (uint32_t k = 0; k < 3; k++) {
        camera.eye[k] = far_off[k] + 10 * camera.eye[k] + 1.0 / 3;
        camera.at[k] = far_off[k] + 10 * camera.at[k];
    }
    const CaptureShot shot = shot_of(&camera);
    DepthImage image = captured(&torus, 0, &shot);
    assert_near(&torus, &image, 0);
    image_free(&image);
    depth_case_close(&torus);
}

/* The rule by rays: beyond the front, the first that faces the eye, else the first. */
static bool ray_behind(const DepthCase *seen, const DepthImage *image, uint32_t pixel,
                       double *depth)
{
    const double x = pixel % W + 0.5, y = pixel / W + 0.5;
    double at = 0, square[3], next, back = -1, from[3], to[3];
    depth_plane_point(&image->plane, &image->front, x, y, 1, from);
    depth_plane_point(&image->plane, &image->front, x, y, 2, to);
    vector_subtract(to, from, from);
    for (int n = 0; depth_case_hit(seen, &image->plane, &image->front, x, y, at, &next, square);
         n++) {
        const bool faces = vector_dot(from, square) < 0;
        if (n > 0 && faces) {
            *depth = next;
            return true;
        }
        back = n > 0 && back < 0 ? next : back;
        at = next * (1 + 1e-9);
    }
    *depth = back;
    return back >= 0;
}

static void behind_is_what_faces_the_eye_next_or_else_the_next_back(void **state)
{
    (void)state;
    DepthCase knot;
    depth_case_open("builtin:knot", 1, NULL, &knot);
    const CaptureShot shot = shot_of(&over_there);
    DepthImage image = captured(&knot, 0, &shot);
    uint32_t both = 0, off = 0;
    for (uint32_t i = 0; i < W * H; i++) {
        double depth = 0;
        const bool has = ray_behind(&knot, &image, i, &depth);
        assert_true(isinf(image.behind.depth[i]) || image.behind.depth[i] > image.front.depth[i]);
        both += has;
        off += has != isfinite(image.behind.depth[i]) ||
               (has && fabs(depth - (double)image.behind.depth[i]) > 0.01);
    }
    image_free(&image);
    depth_case_close(&knot);
    if (both < 500 || off > both / 50)
        fail_msg("%u pixels have something behind, %u are off", both, off);
}

static uint32_t count_of(const CaptureShot *shot, const DepthCase *seen)
{
    uint32_t count = 0;
    DepthImage image = captured(seen, 0, shot);
    for (uint32_t i = 0; i < shot->width * shot->height; i++)
        count += isfinite(image.front.depth[i]) && image.front.depth[i] >= 0;
    image_free(&image);
    return count;
}

/* Inside, behind, cut by near and far, one pixel: none is an error. */
static void eyes_anywhere_have_a_picture(void **state)
{
    (void)state;
    DepthCase ball;
    depth_case_open("builtin:ball", 1, NULL, &ball);
    Camera camera = over_there;
    CaptureShot shot = shot_of(&camera);
    assert_in_range(count_of(&shot, &ball), 500, W * H / 2);
    shot.near = 0.1;
    shot.far = 2;
    assert_int_equal(count_of(&shot, &ball), 0);
    shot.near = 3.8; /* past the middle: the inside of its far half */
    shot.far = 100;
    assert_in_range(count_of(&shot, &ball), 500, W * H / 2);
    for (uint32_t k = 0; k < 3; k++)
        camera.at[k] = 2 * camera.eye[k];
    shot = shot_of(&camera);
    assert_int_equal(count_of(&shot, &ball), 0);
    for (uint32_t k = 0; k < 3; k++)
        camera.eye[k] *= 1e-3;
    shot = shot_of(&camera);
    assert_int_equal(count_of(&shot, &ball), W * H);
    shot.width = shot.height = 1;
    assert_int_equal(count_of(&shot, &ball), 1);
    depth_case_close(&ball);
}

static void sizes_that_cannot_be_drawn_are_refused(void **state)
{
    (void)state;
    DepthCase ball;
    depth_case_open("builtin:ball", 1, NULL, &ball);
    CaptureShot shot = shot_of(&over_there);
    DepthImage image;
    GpError error;
    memset(&image, 77, sizeof image);
    const DepthImage before = image;
    for (int i = 0; i < 2; i++) {
        shot.width = i ? GP_MAX_SIZE + 1 : 0;
        assert_int_equal(
            capture_planar(device, &(CaptureSource){ &ball.mesh, 0 }, &shot, &image, &error),
            GP_ERROR_INVALID);
    }
    assert_string_equal(error.text, "a depth image of 8193x72 pixels; sides are 1 to 8192");
    assert_memory_equal(&image, &before, sizeof image);
    depth_case_close(&ball);
}

static void every_device_captures_the_same_bits(void **state)
{
    (void)state;
    DepthCase knot;
    depth_case_open("builtin:knot", 1, NULL, &knot);
    const CaptureShot shot = shot_of(&over_there);
    DepthImage first = captured(&knot, 9, &shot);
    for (size_t d = 0; device_here(d); d++) {
        GpDevice *other = device_open(device_here(d));
        DepthImage image;
        assert_int_equal(
            capture_planar(other, &(CaptureSource){ &knot.mesh, 9 }, &shot, &image, NULL), GP_OK);
        const DepthPixels *a[2] = { &first.front, &first.behind };
        const DepthPixels *b[2] = { &image.front, &image.behind };
        for (int layer = 0; layer < 2; layer++) {
            assert_memory_equal(a[layer]->depth, b[layer]->depth, W * H * sizeof(float));
            assert_memory_equal(a[layer]->color, b[layer]->color, 3 * W * H * sizeof(float));
            assert_memory_equal(a[layer]->normal, b[layer]->normal, 3 * W * H * sizeof(float));
        }
        image_free(&image);
        gp_device_destroy(&other);
    }
    image_free(&first);
    depth_case_close(&knot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(images_of_cameras_are_what_rays_meet),
        cmocka_unit_test(pictures_beside_the_middle_are_what_rays_meet),
        cmocka_unit_test(models_far_from_the_origin_lose_nothing_more),
        cmocka_unit_test(behind_is_what_faces_the_eye_next_or_else_the_next_back),
        cmocka_unit_test(eyes_anywhere_have_a_picture),
        cmocka_unit_test(sizes_that_cannot_be_drawn_are_refused),
        cmocka_unit_test(every_device_captures_the_same_bits),
    };
    return cmocka_run_group_tests(tests, device_set_up, device_tear_down);
}
