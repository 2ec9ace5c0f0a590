/* The two truths of volumes against closed forms, and against walks that leave nothing out. */
#include "apps/truth/volume_kernels.h"
#include "apps/truth/volume_rays.h"
#include "apps/volumes/transfer.h"
#include "tests/support/groups/pool.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

enum { MAX_SAMPLES = 40 * 40 * 40 };
static uint8_t samples[MAX_SAMPLES];

static Field field_of(uint32_t x, uint32_t y, uint32_t z)
{
    assert_true(x * y * z <= MAX_SAMPLES);
    memset(samples, 0, sizeof samples);
    return (Field){
        .size = { x, y, z }, .scale = { 1, 1, 1 }, .value = samples, .most = FIELD_VALUES - 1
    };
}

static const Transfer level = { 1, { { 0, { 0.5, 1, 0.25, 0.1 } } } };
static const Transfer rising = { 2,
                                 { { 0, { 0.5, 1, 0.25, 0 } }, { 255, { 0.5, 1, 0.25, 0.8 } } } };
static const Transfer bands = { 5,
                                { { 20, { 1, 0, 0, 0 } },
                                  { 60, { 0, 1, 0, 0.3 } },
                                  { 68, { 0, 1, 1, 0 } },
                                  { 150, { 0, 1, 1, 0 } },
                                  { 255, { 1, 1, 1, 0.95 } } } };

/* What a truth is told of a volume; stops stay until four more are told. */
static VolumeScene scene_of(const Field *field, const Transfer *transfer)
{
    static VolumeStop stops[4][TRANSFER_MAX_STOPS];
    static unsigned turn;
    VolumeStop *to = stops[turn++ % 4];
    for (uint32_t i = 0; i < transfer->count; i++) {
        to[i].value = transfer->stops[i].value;
        memcpy(to[i].rgba, transfer->stops[i].rgba, sizeof to[i].rgba);
    }
    VolumeScene scene = { .value = field->value, .stops = to, .stop_count = transfer->count };
    memcpy(scene.size, field->size, sizeof scene.size);
    memcpy(scene.scale, field->scale, sizeof scene.scale);
    return scene;
}

/* Along z from below, parallel, `height` wide and high, at the middle of a field. */
static VolumeScene looking_up(const Field *field, const Transfer *transfer, uint32_t side,
                              double height)
{
    const double *scale = field->scale;
    const double x = (field->size[0] - 1) * scale[0] / 2, y = (field->size[1] - 1) * scale[1] / 2;
    VolumeScene scene = scene_of(field, transfer);
    scene.camera = (Camera){ .eye = { x, y, -100 },
                             .at = { x, y, 0 },
                             .up = { 0, 1, 0 },
                             .height = height,
                             .near = 1,
                             .far = 1000 };
    scene.width = scene.height = side;
    return scene;
}

static VolumePicture rays(const VolumeScene *scene, uint32_t fineness)
{
    VolumePicture picture;
    assert_int_equal(volume_rays_picture(scene, fineness, pool, &picture), GP_OK);
    return picture;
}

static VolumePicture kernels(const VolumeScene *scene, const VolumeKernels *setting)
{
    VolumePicture picture;
    assert_int_equal(volume_kernels_picture(scene, setting, pool, &picture), GP_OK);
    return picture;
}

/* Of a colour of (0.5, 1, 0.25) that has the alpha of an extinction. */
static void assert_pixel(const double *rgba, double extinction, double within)
{
    const double alpha = 1 - exp(-extinction);
    if (!(fabs(rgba[3] - alpha) <= within) || !(fabs(rgba[0] - 0.5 * alpha) <= within) ||
        !(fabs(rgba[1] - alpha) <= within) || !(fabs(rgba[2] - 0.25 * alpha) <= within))
        fail_msg("%.9f %.9f %.9f %.9f, expected an alpha of %.9f", rgba[0], rgba[1], rgba[2],
                 rgba[3], alpha);
}

static double largest_difference(const VolumePicture *a, const VolumePicture *b)
{
    double largest = 0;
    for (size_t i = 0; i < 4 * (size_t)a->width * a->height; i++)
        largest = fmax(largest, fabs(a->rgba[i] - b->rgba[i]));
    return largest;
}

/* --- of the data ------------------------------------------------------------------------------ */

static void a_slab_takes_what_its_opacity_says(void **state)
{
    (void)state;
    Field field = field_of(5, 5, 11);
    for (int k = 0; k < 2; k++) { /* opacity is of a length in space, not of samples */
        field.scale[2] = k ? 2.5 : 1;
        const VolumeScene scene = looking_up(&field, &level, 4, 3.9);
        VolumePicture picture = rays(&scene, 1);
        for (int i = 0; i < 16; i++)
            assert_pixel(picture.rgba + 4 * (size_t)i, -log(0.9) * 10 * field.scale[2], 1e-12);
        volume_picture_free(&picture);
    }
}

static void outside_of_the_samples_is_nothing(void **state)
{
    (void)state;
    const Field field = field_of(5, 5, 11), one = field_of(1, 1, 1);
    const VolumeScene scene = looking_up(&field, &level, 12, 12),
                      single = looking_up(&one, &level, 5, 2);
    VolumePicture picture = rays(&scene, 1);
    for (int i = 0; i < 144; i++) {
        const bool is_inside = abs(2 * (i % 12) - 11) < 4 && abs(2 * (i / 12) - 11) < 4;
        assert_true((picture.rgba[4 * i + 3] > 0) == is_inside);
    }
    volume_picture_free(&picture);
    picture = rays(&single, 1);
    for (int i = 0; i < 100; i++)
        assert_true(picture.rgba[i] == 0);
    volume_picture_free(&picture);
}

/* The integral of -ln(1 - a t) over t from 0 to 1 is 1 + (1 - a) ln(1 - a) / a. */
static void a_ramp_has_its_integral(void **state)
{
    (void)state;
    Field field = field_of(3, 3, 18);
    for (int i = 0; i < 3 * 3 * 18; i++)
        samples[i] = (uint8_t)(i / 9 * 15);
    const VolumeScene scene = looking_up(&field, &rising, 2, 1);
    VolumePicture picture = rays(&scene, 1);
    assert_pixel(picture.rgba, 17 * (1 + 0.2 * log(0.2) / 0.8), 1e-6);
    volume_picture_free(&picture);
}

static void opaque_things_and_the_near_plane_cut_it(void **state)
{
    (void)state;
    Field field = field_of(5, 5, 11);
    VolumeScene scene = looking_up(&field, &level, 2, 2);
    const float behind = (float)((103.0 - 1) / 999);
    const float depth[] = { 0, behind, 1, 1 };
    scene.depth = depth;
    VolumePicture picture = rays(&scene, 1);
    assert_pixel(picture.rgba, 0, 0);
    assert_pixel(picture.rgba + 4, -log(0.9) * 3, 1e-5);
    assert_pixel(picture.rgba + 8, -log(0.9) * 10, 1e-12);
    volume_picture_free(&picture);
    scene.depth = NULL;
    scene.camera.near = 104;
    picture = rays(&scene, 1);
    assert_pixel(picture.rgba, -log(0.9) * 6, 1e-12);
    volume_picture_free(&picture);
    scene.camera.far = 106;
    picture = rays(&scene, 1);
    assert_pixel(picture.rgba, -log(0.9) * 2, 1e-12);
    volume_picture_free(&picture);
}

/* --- against a plain walk --------------------------------------------------------------------- */

static double interpolate(const VolumeScene *field, const double at[3])
{
    double sum = 0;
    for (int i = 0; i < 8; i++) {
        double weight = 1;
        size_t index = 0;
        for (int k = 2; k >= 0; k--) {
            const double cell = fmin(floor(at[k]), field->size[k] - 2.0);
            weight *= i >> k & 1 ? at[k] - cell : 1 - (at[k] - cell);
            index = index * field->size[k] + (size_t)cell + (i >> k & 1);
        }
        sum += weight * field->value[index];
    }
    return sum;
}

static void plain_ray(const VolumeScene *scene, const Transfer *transfer, double x, double y,
                      double rgba[4])
{
    const VolumeEye eye = volume_eye(scene);
    const VolumeRay ray = volume_ray(&eye, x, y, 0);
    const int steps = 60000;
    double through = 1;
    for (int c = 0; c < 4; c++)
        rgba[c] = 0;
    for (int i = 0; i < steps && ray.low < ray.high; i++) {
        const double length = (ray.high - ray.low) / steps, t = ray.low + (i + 0.5) * length;
        double at[3], color[4];
        for (int k = 0; k < 3; k++)
            at[k] = fmin(fmax(ray.begin[k] + t * ray.way[k], 0), scene->size[k] - 1.0);
        transfer_at(transfer, interpolate(scene, at), color);
        const double alpha = 1 - pow(1 - color[3], length);
        for (int c = 0; c < 3; c++)
            rgba[c] += through * alpha * color[c];
        through *= 1 - alpha;
    }
    rgba[3] = 1 - through;
}

/* Blobs with much empty room between them, seen in perspective, from outside and from inside. */
static void what_is_left_out_of_a_walk_is_nothing(void **state)
{
    (void)state;
    Field field = field_of(37, 30, 33);
    field.scale[1] = 1.5;
    Random random = { 3 };
    for (int blob = 0; blob < 16; blob++) {
        const uint32_t at = random_word(&random) % (30 * 37 * 30);
        for (uint32_t i = 0; i < 27; i++)
            samples[at + i % 3 + 37 * (i / 3 % 3) + 37 * 30 * (i / 9)] =
                (uint8_t)random_bits(&random);
    }
    VolumeScene scene = scene_of(&field, &bands);
    scene.width = 8;
    scene.height = 6;
    scene.camera = (Camera){ .eye = { 60, 70, -50 },
                             .at = { 18, 20, 16 },
                             .up = { 0, 1, 0 },
                             .fovy = 40,
                             .near = 1,
                             .far = 1000 };
    for (int inside = 0; inside < 2; inside++) {
        VolumePicture picture = rays(&scene, 1);
        double seen = 0;
        for (uint32_t i = 0; i < 8 * 6; i++) {
            double rgba[4];
            plain_ray(&scene, &bands, i % 8 + 0.5, i / 8 + 0.5, rgba);
            for (uint32_t c = 0; c < 4; c++)
                if (!(fabs(rgba[c] - picture.rgba[4 * i + c]) < 1e-4))
                    fail_msg("pixel %u: %.6f, expected %.6f", i, picture.rgba[4 * i + c], rgba[c]);
            seen += rgba[3];
        }
        assert_true(seen > 0.1);
        volume_picture_free(&picture);
        vector_set(scene.camera.eye, 15, 18, 14);
        scene.camera.near = 0.1;
        scene.camera.fovy = 90;
    }
}

static void finer_steps_change_next_to_nothing(void **state)
{
    (void)state;
    Field field;
    assert_int_equal(field_open("builtin:marschner-lobb:24", &field, NULL), GP_OK);
    Transfer transfer;
    assert_int_equal(transfer_open("marschner-lobb", &field, &transfer, NULL), GP_OK);
    const VolumeScene scene = looking_up(&field, &transfer, 24, 30);
    VolumePicture coarse = rays(&scene, 1), fine = rays(&scene, 4);
    assert_true(largest_difference(&coarse, &fine) < 1e-5);
    volume_picture_free(&coarse);
    volume_picture_free(&fine);
    const VolumeKernels setting = { .deviation = 0.6, .cut = 1.5, .low_pass = 0.4, .rays = 2 };
    VolumeKernels finer = setting;
    finer.fineness = 4;
    coarse = kernels(&scene, &setting);
    fine = kernels(&scene, &finer);
    assert_true(largest_difference(&coarse, &fine) < 2e-3);
    finer.rays = 4;
    volume_picture_free(&fine);
    fine = kernels(&scene, &finer);
    assert_true(largest_difference(&coarse, &fine) < 2e-3);
    volume_picture_free(&coarse);
    volume_picture_free(&fine);
    field_free(&field);
}

/* --- of the kernels --------------------------------------------------------------------------- */

static void a_kernels_integral_is_one(void **state)
{
    (void)state;
    for (double cut = 1; cut < 4; cut += 0.7) {
        double sum = 0;
        const double height = volume_kernel_height(0.6, cut), step = cut / 20000;
        for (double r = step / 2; r < cut; r += step)
            sum += 4 * M_PI * r * r * exp(-r * r / 0.72) * height * step;
        assert_true(fabs(sum - 1) < 1e-6);
    }
}

/* Through a single kernel: D = e h s sqrt(2 pi) erf(c / (s sqrt 2)) exp(-d^2 / (2 s^2)), c half the
 * chord. */
static void a_kernels_profile_is_its_line_integral(void **state)
{
    (void)state;
    Field field = field_of(9, 9, 9);
    samples[9 * 9 * 4 + 9 * 4 + 4] = 255;
    const VolumeScene scene = looking_up(&field, &rising, 11, 5.5); /* half a sample a pixel */
    const VolumeKernels setting = { .deviation = 0.6, .cut = 1.6, .fineness = 32 };
    const double height = volume_kernel_height(0.6, 1.6), extinction = -log(0.2);
    VolumePicture picture = kernels(&scene, &setting);
    for (int i = 0; i < 121; i++) {
        const double x = (i % 11 - 5) * 0.5, y = (i / 11 - 5) * 0.5, d2 = x * x + y * y;
        const double half = sqrt(fmax(1.6 * 1.6 - d2, 0));
        const double along = 0.6 * sqrt(2 * M_PI) * erf(half / (0.6 * M_SQRT2));
        assert_pixel(picture.rgba + 4 * (size_t)i, extinction * height * along * exp(-d2 / 0.72),
                     1e-3);
    }
    volume_picture_free(&picture);
}

/* From anywhere: sums of kernels on a lattice are 1 but for 6 exp(-2 pi^2 deviation^2). */
static void kernels_of_one_value_are_a_slab(void **state)
{
    (void)state;
    Field field = field_of(24, 24, 30);
    const VolumeKernels setting = { .deviation = 0.8, .cut = 3.2, .low_pass = 0.5, .rays = 2 };
    VolumeScene scene = looking_up(&field, &level, 6, 6);
    VolumePicture picture = kernels(&scene, &setting);
    for (int i = 0; i < 36; i++)
        assert_pixel(picture.rgba + 4 * (size_t)i, -log(0.9) * 30, 1e-4);
    volume_picture_free(&picture);
    for (int from = 0; from < 2; from++) { /* from inside, along no axis, in front of an end */
        vector_set(scene.camera.eye, 11.5, 11.5, from ? 24 : 8);
        vector_set(scene.camera.at, 12.5, 13, from ? 8 : 24);
        scene.camera.near = 1;
        scene.camera.far = 9;
        picture = kernels(&scene, &setting);
        for (int i = 0; i < 36; i++)
            assert_pixel(picture.rgba + 4 * (size_t)i, -log(0.9) * 8, 1e-3);
        volume_picture_free(&picture);
    }
}

/* Of a faint kernel: Gaussians' variances add. */
static void the_pixels_filter_widens_kernels(void **state)
{
    (void)state;
    Field field = field_of(15, 15, 15);
    const Transfer faint = { 2, { { 0, { 1, 1, 1, 0 } }, { 255, { 1, 1, 1, 1e-3 } } } };
    samples[15 * 15 * 7 + 15 * 7 + 7] = 255;
    field.scale[0] = 2;
    const VolumeScene scene = looking_up(&field, &faint, 9, 9); /* a pixel a sample along y */
    const VolumeKernels setting = { .deviation = 0.7, .cut = 3.5, .low_pass = 0.9, .rays = 2 };
    const double x2 = 4 * 0.49 + 0.81, y2 = 0.49 + 0.81;
    VolumePicture picture = kernels(&scene, &setting);
    for (int i = 0; i < 81; i++) {
        const double x = i % 9 - 4, y = i / 9 - 4;
        const double expected =
            2e-3 * exp(-0.5 * (x * x / x2 + y * y / y2)) / (2 * M_PI * sqrt(x2 * y2));
        assert_true(fabs(picture.rgba[4 * i + 3] - expected) < 4e-6);
    }
    volume_picture_free(&picture);
}

static void threads_change_no_bit(void **state)
{
    (void)state;
    Field field;
    GpPool *three;
    assert_int_equal(field_open("builtin:ball:20", &field, NULL), GP_OK);
    assert_int_equal(gp_pool_create(3, &three, NULL), GP_OK);
    VolumeScene scene = looking_up(&field, &bands, 16, 16);
    scene.camera.eye[0] += 30;
    const VolumeKernels setting = { .deviation = 0.6, .cut = 1.5, .low_pass = 0.4, .rays = 2 };
    VolumePicture pictures[4] = { rays(&scene, 1), kernels(&scene, &setting) };
    assert_int_equal(volume_rays_picture(&scene, 1, three, &pictures[2]), GP_OK);
    assert_int_equal(volume_kernels_picture(&scene, &setting, three, &pictures[3]), GP_OK);
    for (int i = 0; i < 2; i++)
        assert_memory_equal(pictures[i].rgba, pictures[i + 2].rgba, 16 * 16 * 4 * sizeof(double));
    assert_true(largest_difference(&pictures[0], &pictures[1]) > 0.01);
    for (int i = 0; i < 4; i++)
        volume_picture_free(&pictures[i]);
    gp_pool_destroy(&three);
    field_free(&field);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slab_takes_what_its_opacity_says),
        cmocka_unit_test(outside_of_the_samples_is_nothing),
        cmocka_unit_test(a_ramp_has_its_integral),
        cmocka_unit_test(opaque_things_and_the_near_plane_cut_it),
        cmocka_unit_test(what_is_left_out_of_a_walk_is_nothing),
        cmocka_unit_test(finer_steps_change_next_to_nothing),
        cmocka_unit_test(a_kernels_integral_is_one),
        cmocka_unit_test(a_kernels_profile_is_its_line_integral),
        cmocka_unit_test(kernels_of_one_value_are_a_slab),
        cmocka_unit_test(the_pixels_filter_widens_kernels),
        cmocka_unit_test(threads_change_no_bit),
    };
    return cmocka_run_group_tests_name("truth volume", tests, pool_set_up, pool_tear_down);
}
