/* What one planar depth image does not show, and what fills it: the second layer, where a little
 * comes into view behind edges; images from other sides, where much does, as through the hole of a
 * ring. */
#include "apps/depth_images/capture.h"
#include "apps/depth_images/drawing/direct.h"
#include "tests/support/depth/around.h"

enum { IMAGE = 2 * AROUND_SIDE };

/* Captured without normals, which the shape does not have. owns: the caller */
static DepthImage capture(const DepthShape *shape, const Camera *camera)
{
    GpDevice *device = device_open(&(GpDeviceDesc){ .threads = 2 });
    const GpMesh mesh = { .positions = shape->positions,
                          .normals = shape->positions,
                          .indices = shape->indices,
                          .vertex_count = shape->vertex_count,
                          .triangle_count = shape->triangle_count };
    const CaptureShot shot = {
        .plane = depth_plane_of_camera(camera, 1), .width = IMAGE, .height = IMAGE, .behind = true
    };
    DepthImage image;
    GpError error = { "" };
    if (capture_planar(device, &(CaptureSource){ &mesh, shape->paint.waves }, &shot, &image,
                       &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
    gp_free(image.front.normal);
    gp_free(image.behind.normal);
    image.front.normal = image.behind.normal = NULL;
    return image;
}

/* All images over each other, seen by a camera. */
static DepthCompared compare(const DepthShape *shape, const DepthImage *images, uint32_t count,
                             const DirectSetting *setting, const Camera *camera)
{
    Frame frame = { .color = NULL };
    const WarpView view = around_view(camera, false);
    const WarpTarget target = around_target(&frame, GP_A8R8G8B8);
    Direct direct[DEPTH_MODEL_IMAGES];
    for (uint32_t i = 0; i < count; i++) {
        assert_int_equal(direct_open(&images[i], &direct[i], NULL), GP_OK);
        assert_int_equal(direct_add(&direct[i], setting, &view, &target, &frame, NULL), GP_OK);
    }
    const DepthCompared compared = around_compare(shape, camera, &frame);
    print_message("# %u images, layers %d: %u of %u missing, %u too much, %.1f dB\n", count,
                  setting->layers, compared.missing, compared.covered, compared.extra,
                  compared.psnr);
    for (uint32_t i = 0; i < count; i++)
        direct_close(&direct[i]);
    frame_free(&frame);
    return compared;
}

static void free_images(DepthImage *images, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        depth_pixels_free(&images[i].front);
        depth_pixels_free(&images[i].behind);
    }
}

/* Wrongly is drawn what only the third layer has. */
static void a_second_layer_fills_what_edges_hid(void **state)
{
    (void)state;
    DepthShape shape = depth_shape_open("builtin:knot", 20, 0);
    const Camera source = around_camera(&shape, 270, 10, 4 * shape.radius);
    const Camera camera = around_camera(&shape, 284, 16, 4 * shape.radius);
    DepthImage image = capture(&shape, &source);
    const DepthCompared front =
        compare(&shape, &image, 1, &(DirectSetting){ .layers = false }, &camera);
    const DepthCompared layers =
        compare(&shape, &image, 1, &(DirectSetting){ .layers = true }, &camera);
    assert_true(front.missing > 80 && layers.missing < front.missing / 2);
    assert_true(front.psnr > 28 && layers.extra < layers.covered / 50);
    free_images(&image, 1);
    depth_shape_close(&shape);
}

/* A hole whose walls no ray of one image meets: six, from the sides of a box, have most of them, as
 * long as none shows the inside of what another has from outside. */
static void images_from_all_sides_show_the_walls_of_holes(void **state)
{
    (void)state;
    DepthShape ring = depth_shape_open("builtin:torus", 20, 70);
    DepthImage images[DEPTH_MODEL_IMAGES];
    const Camera camera = around_camera(&ring, 310, 35, 4 * ring.radius);
    for (int i = 0; i < DEPTH_MODEL_IMAGES; i++) {
        Camera face = { .up = { 0, i / 2 != 2, i / 2 == 2 },
                        .height = 2.1 * fmax(ring.radius, ring.half_height),
                        .near = 0.01,
                        .far = 10 };
        for (int k = 0; k < 3; k++)
            face.eye[k] = face.at[k] = ring.center[k];
        face.eye[(i / 2 + 2) % 3] += (i & 1 ? -3 : 3) * ring.radius;
        images[i] = capture(&ring, &face);
    }
    const DirectSetting both = { .step = 0 }, outside = { .one_sided = true };
    const DepthCompared one = compare(&ring, images, 1, &outside, &camera),
                        insides = compare(&ring, images, DEPTH_MODEL_IMAGES, &both, &camera),
                        all = compare(&ring, images, DEPTH_MODEL_IMAGES, &outside, &camera);
    assert_true(one.missing > one.covered / 10 && all.missing < one.missing / 10);
    assert_true(all.psnr > 35 && insides.psnr < all.psnr - 5);
    free_images(images, DEPTH_MODEL_IMAGES);
    depth_shape_close(&ring);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_second_layer_fills_what_edges_hid),
        cmocka_unit_test(images_from_all_sides_show_the_walls_of_holes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
