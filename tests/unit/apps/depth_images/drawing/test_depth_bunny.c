/* A scanned model, taken from in front and seen from 12 degrees aside, as peers were measured with
 * it: the
 * errors of planar warping, without and with the second layer, and as printed. */
#include "apps/depth_images/capture.h"
#include "apps/depth_images/drawing/direct.h"
#include "apps/depth_images/drawing/planar.h"
#include "pipeline/io/mesh/mesh_file.h"
#include "tests/support/depth/depth_shapes.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <time.h>
#include <unistd.h>

enum { SIDE = 512, FRAMES = 10 };

static const char model[] = "../shared/data/meshes/bunny.ply";

static const Camera source = { .eye = { -0.0168, 0.14, 0.40 },
                               .at = { -0.0168, 0.1105, -0.0014 },
                               .up = { 0, 1, 0 },
                               .fovy = 30,
                               .near = 0.1,
                               .far = 2 };
static const Camera aside = { .eye = { 0.06, 0.16, 0.38 },
                              .at = { -0.0168, 0.1105, -0.0014 },
                              .up = { 0, 1, 0 },
                              .fovy = 30,
                              .near = 0.1,
                              .far = 2 };

static double processor_ms(void)
{
    return 1e3 * (double)clock() / CLOCKS_PER_SEC;
}

/* Waves of 100 over the diagonal of the model's box. */
static DepthShape open_shape(const GpMesh *mesh)
{
    const Bounds box =
        bounds_of(mesh->positions, 3 * sizeof(float), mesh->indices, 3 * mesh->triangle_count);
    double diagonal[3];
    vector_subtract(box.high, box.low, diagonal);
    return depth_shape_open(model,
                            100 * bounds_longest(&box) / sqrt(vector_dot(diagonal, diagonal)), 0);
}

static DepthImage capture(GpDevice *device, const GpMesh *mesh, double waves)
{
    const CaptureShot shot = {
        .plane = depth_plane_of_camera(&source, 1), .width = SIDE, .height = SIDE, .behind = true
    };
    DepthImage image;
    GpError error = { "" };
    if (capture_planar(device, &(CaptureSource){ mesh, waves }, &shot, &image, &error))
        fail_msg("%s", error.text);
    return image;
}

typedef enum Way { FRONT, LAYERS, PRINTED } Way;

static DepthCompared measure(GpDevice *device, Direct *direct, const Planar *planar, Way way,
                             const RayPicture *truth)
{
    static const float nothing[4] = { 0 };
    const WarpView view = { aside, SIDE, SIDE, NULL };
    Frame frame = { .color = NULL };
    const WarpTarget target = { frame_surface(&frame, GP_A8R8G8B8, SIDE, SIDE, 1),
                                frame_surface(&frame, GP_D32F, SIDE, SIDE, 1) };
    frame_pass(&frame, "below", target.color, target.depth, nothing);
    const GpResult result =
        way == PRINTED
            ? planar_add(planar, &(PlanarSetting){ .step = 0 }, &view, &target, &frame, NULL)
            : direct_add(direct, &(DirectSetting){ .layers = way == LAYERS }, &view, &target,
                         &frame, NULL);
    assert_int_equal(result, GP_OK);
    assert_int_equal(gp_device_run(device, &frame.list, NULL), GP_OK);
    const double begin = processor_ms();
    for (int i = 0; i < FRAMES; i++)
        assert_int_equal(gp_device_run(device, &frame.list, NULL), GP_OK);
    const double ms = (processor_ms() - begin) / FRAMES;
    const DepthCompared off = depth_compare(truth, &aside, target.color, target.depth);
    print_message("# %.2f dB, %u of %u missing, %u too much; %.1f ms of processors\n", off.psnr,
                  off.missing, off.covered, off.extra, ms);
    frame_free(&frame);
    return off;
}

static void a_scan_from_aside_is_as_near_as_was_asked(void **state)
{
    (void)state;
    GpMesh mesh;
    if (access(model, R_OK)) {
        print_message("# skipped: %s is not there\n", model);
        skip();
    }
    assert_int_equal(gp_mesh_read(model, 0, &mesh, NULL), GP_OK);
    GpDevice *device = device_open(&(GpDeviceDesc){ .threads = 2 });
    DepthShape shape = open_shape(&mesh);
    RayPicture truth = depth_shape_truth(&shape, &aside, SIDE, SIDE);
    DepthImage image = capture(device, &mesh, shape.paint.waves);
    Direct direct;
    Planar planar;
    assert_int_equal(direct_open(&image, &direct, NULL), GP_OK);
    assert_int_equal(planar_open(&image, &planar, NULL), GP_OK);
    const DepthCompared front = measure(device, &direct, &planar, FRONT, &truth);
    const DepthCompared layers = measure(device, &direct, &planar, LAYERS, &truth);
    const DepthCompared printed = measure(device, &direct, &planar, PRINTED, &truth);
    assert_true(front.covered > 97000 && front.psnr >= 41 && front.missing < 2466);
    assert_true(layers.missing <= 900 && layers.psnr > 37);
    assert_true(printed.missing < 2466 && printed.psnr > 35);
    direct_close(&direct);
    planar_close(&planar);
    depth_pixels_free(&image.front);
    depth_pixels_free(&image.behind);
    ray_picture_free(&truth);
    depth_shape_close(&shape);
    gp_device_destroy(&device);
    gp_mesh_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_scan_from_aside_is_as_near_as_was_asked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
