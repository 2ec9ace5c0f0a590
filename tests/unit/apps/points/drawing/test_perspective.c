/* Splats by rays against the sum that they stand for, in double, of all surfels, without a cut; and
 * how far off affine splats are in the same wide view. */
#include "apps/points/drawing/splats.h"
#include "apps/points/drawing/view.h"

#include "apps/base/stable_math.h"
#include "tests/support/devices.h"
#include "tests/support/surfel_shapes.h"
#include "tests/support/unit.h"

#include <string.h>

enum { WIDE = 51, COUNT = WIDE * WIDE, SIDE = 96 };
static const double spread = 0.8, spacing = 0.05;

/* Surfels of the plane y = 0 about the origin; red grows to the right, green to the back. */
static void make_plane(Surfel surfels[COUNT])
{
    const double up[3] = { 0, 1, 0 };
    for (int i = 0; i < COUNT; i++) {
        const double x = i % WIDE, z = i / WIDE;
        const double at[3] = { (x - WIDE / 2) * spacing, 0, (z - WIDE / 2) * spacing };
        surfels[i] = shape_surfel(at, up, 0.75 * spacing, spacing * spacing);
        surfels[i].color[0] = (uint8_t)(x * 5);
        surfels[i].color[1] = (uint8_t)(z * 5);
    }
}

/* The plane from close above it, seen far to the sides. */
static SplatView make_view(void)
{
    return (SplatView){ .camera = { .eye = { 0, 0.35, 0.3 },
                                    .at = { 0.3, 0, -0.1 },
                                    .up = { 0, 1, 0 },
                                    .fovy = 110,
                                    .near = 0.01,
                                    .far = 10 },
                        .width = SIDE,
                        .height = SIDE };
}

/* Where the ray of a pixel's centre meets the plane; false: nowhere in front, or near its
 * border. */
static bool meet_plane(const SplatView *view, const SplatEye *eye, int x, int y, double place[2])
{
    const double across = (x + 0.5 - SIDE / 2) / eye->focal;
    const double down = (y + 0.5 - SIDE / 2) / eye->focal;
    double ray[3];
    for (int k = 0; k < 3; k++)
        ray[k] = eye->axis[2][k] + across * eye->axis[0][k] + down * eye->axis[1][k];
    const double t = -view->camera.eye[1] / ray[1];
    place[0] = view->camera.eye[0] + t * ray[0];
    place[1] = view->camera.eye[2] + t * ray[2];
    const double border = (WIDE / 2 - 5) * spacing;
    return t > 0 && fabs(place[0]) < border && fabs(place[1]) < border;
}

/* Colour times weight, and the weight. */
static void sum_all(const Surfel surfels[COUNT], const double place[2], double sum[4])
{
    memset(sum, 0, 4 * sizeof *sum);
    for (int i = 0; i < COUNT; i++) {
        const double sigma = spread * (double)surfel_width(&surfels[i]);
        const double x = place[0] - (double)surfels[i].position[0];
        const double z = place[1] - (double)surfels[i].position[2];
        const double weight = surfel_area(&surfels[i]) / (6.283185307179586 * sigma * sigma) *
                              stable_exp(-(x * x + z * z) / (2 * sigma * sigma));
        for (int k = 0; k < 3; k++)
            sum[k] += weight * surfels[i].color[k] / 255;
        sum[3] += weight;
    }
}

typedef struct Off {
    double weight, color; /* the largest errors */
    int pixels;
} Off;

static Off measure(SplatMethod method)
{
    Surfel surfels[COUNT];
    GpError error = { "" };
    Frame frame = { .color = NULL };
    make_plane(surfels);
    const SplatView view = make_view();
    const SplatRun run = { .filter = SPLAT_EWA, .count = COUNT, .radius = surfels[0].radius };
    const SplatSource source = { .surfels = surfels, .runs = &run, .run_count = 1 };
    const SplatSetting setting = { .method = method,
                                   .sums = SPLAT_FLOATS,
                                   .low_pass = 0.05,
                                   .spread = spread,
                                   .cut = 5,
                                   .epsilon = 100 };
    GpDevice *device = device_open(&(GpDeviceDesc){ 0 });
    if (splats_build(&source, &view, &setting, &frame, &error) ||
        gp_device_run(device, &frame.list, &error))
        fail_msg("%s", error.text);
    const uint8_t *texels = frame.list.passes[1].color[0].surface->level[0].texels;
    const SplatEye eye = splat_eye(&view);
    Off off = { 0 };
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            double place[2], sum[4];
            float drawn[4];
            if (!meet_plane(&view, &eye, x, y, place))
                continue;
            sum_all(surfels, place, sum);
            memcpy(drawn, texels + (size_t)(y * SIDE + x) * sizeof drawn, sizeof drawn);
            off.weight = fmax(off.weight, fabs((double)drawn[3] - sum[3]));
            for (int k = 0; k < 3 && drawn[3] > 0; k++)
                off.color = fmax(off.color, fabs((double)(drawn[k] / drawn[3]) - sum[k] / sum[3]));
            off.pixels++;
        }
    frame_free(&frame);
    gp_device_destroy(&device);
    return off;
}

static void rays_give_the_sum_in_wide_views(void **state)
{
    (void)state;
    const Off exact = measure(SPLAT_PERSPECTIVE), affine = measure(SPLAT_EWA);
    print_message("# %d pixels; weights are off by %.2g, affine %.2g, colours by %.2g, %.2g\n",
                  exact.pixels, exact.weight, affine.weight, exact.color, affine.color);
    assert_true(exact.pixels > SIDE * SIDE / 4);
    assert_true(exact.weight < 0.01 && exact.color < 0.004);
    assert_true(affine.weight > 0.1 && affine.color > 0.02);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_give_the_sum_in_wide_views),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
