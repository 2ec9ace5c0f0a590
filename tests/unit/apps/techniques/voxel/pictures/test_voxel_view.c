/* Pictures of volumes: each pixel's voxel, and how much light comes through, against rays. */
#include "apps/frame/view_slices.h"
#include "apps/techniques/voxel/pictures/scan.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"
#include "tests/support/view_case.h"
#include "tests/support/voxel_walk.h"

#include <math.h>

enum { SIDE = VIEW_CASE_SIDE, MOST = 64 };

/* --- rays ------------------------------------------------------------------------------------- */

/* Through a place of the picture, in pixels. */
static void ray_of(const Camera *camera, double x, double y, double origin[3], double direction[3])
{
    double view[4][4], sine, cosine;
    camera_view(camera, view);
    angle_sincos(camera->fovy / 2, &sine, &cosine);
    const bool perspective = camera->fovy > 0;
    const double half = perspective ? sine / cosine : camera->height / 2;
    const double right = (2 * x / SIDE - 1) * half, up = (1 - 2 * y / SIDE) * half;
    for (int k = 0; k < 3; k++) {
        const double aside = right * view[0][k] + up * view[1][k];
        origin[k] = camera->eye[k] + (perspective ? 0 : aside);
        direction[k] = -view[2][k] + (perspective ? aside : 0);
    }
}

/* Number of the first voxel on the ray, from 1; 0: none. */
static uint32_t first_on_ray(const FlatTexture *flat, const Camera *camera, double x, double y)
{
    static VoxelStep steps[3 * MOST + 1];
    double origin[3], direction[3];
    ray_of(camera, x, y, origin, direction);
    const uint32_t count = voxel_walk(flat->size, origin, direction, steps);
    for (uint32_t i = 0; i < count; i++)
        if (view_case_get(flat, steps[i].voxel))
            return 1 + steps[i].voxel[0] +
                   flat->size * (steps[i].voxel[1] + flat->size * steps[i].voxel[2]);
    return 0;
}

/* Rays so far beside a pixel's centre find the same voxel, or the pixel is not compared: corners
 * are snapped to 1/256 pixel, and places are floats. */
#define BESIDE 0.02

static bool is_certain(const FlatTexture *flat, const Camera *camera, double x, double y,
                       uint32_t *first)
{
    *first = first_on_ray(flat, camera, x, y);
    for (int i = 0; i < 4; i++)
        if (first_on_ray(flat, camera, x + (i & 1 ? BESIDE : -BESIDE),
                         y + (i & 2 ? BESIDE : -BESIDE)) != *first)
            return false;
    return true;
}

/* Compares all pixels; returns how many were certain. */
static int compare_with_rays(const Frame *frame, const FlatTexture *flat, const Camera *camera)
{
    int certain = 0;
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            uint32_t first;
            float pixel[4];
            if (!is_certain(flat, camera, x + 0.5, y + 0.5, &first))
                continue;
            certain++;
            view_case_pixel(frame, "voxels", x, y, pixel);
            const uint32_t drawn =
                pixel[3] == 0
                    ? 0
                    : 1 + (uint32_t)pixel[0] +
                          flat->size * ((uint32_t)pixel[1] + flat->size * (uint32_t)pixel[2]);
            if (drawn != first)
                fail_msg("size %u, pixel %d %d: voxel %u is drawn, %u is there", flat->size, x, y,
                         drawn, first);
        }
    return certain;
}

/* --- what is seen ----------------------------------------------------------------------------- */

static const struct {
    uint32_t size;
    double x, y, z, distance, fovy;
} views[] = {
    { 32, 0.1, 0.05, 1, 2.2, 40 },  { 33, -1, 0.3, 0.2, 2, 42 },
    { 24, 0.2, 1, -0.4, 1.6, 45 },  { 40, -0.7, -0.69, -0.68, 2.2, 40 },
    { 64, 0.6, 0.5, -0.62, 2, 34 }, { 17, 0, 0, -1, 1, 0 },
    { 33, 0.7, 0.5, 0.6, 1.5, 0 },  { 32, 1, 0.95, 0.2, 0.3, 40 }, /* the eye is inside */
};

static void every_pixel_shows_the_first_voxel_of_its_ray(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(views); i++) {
        Frame frame;
        view_case_begin(&frame);
        const FlatTexture flat = view_case_random(&frame, views[i].size, 150, i);
        VoxelView view = voxel_view_defaults;
        view.shading = VOXEL_FACES_OF_CUBES;
        view.camera = view_case_camera(views[i].size, views[i].x, views[i].y, views[i].z,
                                       views[i].distance, views[i].fovy);
        const bool inside = views[i].distance < 0.5;
        if (inside) { /* nothing is drawn of the slab that the eye is in */
            memset(flat.texels->level[0].texels, 0, flat.texels->level[0].pitch * flat.size);
            view_case_put(&flat, 2, 3, 15);
            view_case_put(&flat, 1, 12, 20);
        }
        view_case_draw(&frame, &flat, &view);
        const int certain = compare_with_rays(&frame, &flat, &view.camera);
        assert_true(certain > SIDE * SIDE * 8 / 10);
        frame_free(&frame);
    }
}

/* Also at the volume's sides and corners, where rays enter it beside the slices' own squares. */
static void one_voxel_is_one_cube(void **state)
{
    (void)state;
    static const uint32_t places[][3] = { { 0, 0, 0 }, { 8, 0, 8 }, { 8, 8, 8 }, { 4, 5, 3 } };
    for (size_t i = 0; i < GP_COUNT(views); i++)
        for (size_t p = 0; p < GP_COUNT(places); p++) {
            Frame frame;
            view_case_begin(&frame);
            const FlatTexture flat = flat_texture_make(&frame, 9, 1);
            view_case_put(&flat, places[p][0], places[p][1], places[p][2]);
            VoxelView view = voxel_view_defaults;
            const bool anywhere = i % 2;
            for (int k = 0; k < 3 && !anywhere; k++) {
                view.range.low[k] = places[p][k];
                view.range.end[k] = places[p][k] + 1;
            }
            view.camera = view_case_camera(9, views[i].x, views[i].y, views[i].z, 2, views[i].fovy);
            view_case_draw(&frame, &flat, &view);
            assert_true(compare_with_rays(&frame, &flat, &view.camera) > SIDE * SIDE * 8 / 10);
            frame_free(&frame);
        }
}

static void kinds_tell_which_volumes_have_a_voxel(void **state)
{
    (void)state;
    Frame frame;
    view_case_begin(&frame);
    const FlatTexture a = view_case_random(&frame, 24, 3, 1),
                      b = view_case_random(&frame, 24, 3, 2);
    VoxelView view = voxel_view_defaults;
    view.second = &b;
    view.camera = view_case_camera(24, 0.3, 0.4, 0.8, 2, 40);
    view_case_draw(&frame, &a, &view);
    int seen[4] = { 0 };
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            float pixel[4];
            view_case_pixel(&frame, "voxels", x, y, pixel);
            const uint32_t voxel[3] = { (uint32_t)pixel[0], (uint32_t)pixel[1],
                                        (uint32_t)pixel[2] };
            seen[(int)pixel[3]]++;
            if (pixel[3] > 0)
                assert_int_equal(pixel[3], view_case_get(&a, voxel) + 2 * view_case_get(&b, voxel));
        }
    for (int kind = 0; kind < 4; kind++)
        assert_true(seen[kind] > 100);
    frame_free(&frame);
}

/* --- what comes through ----------------------------------------------------------------------- */

/* Voxels of the ray's way that are there. */
static double way_in_voxels(const FlatTexture *flat, const Camera *camera, double x, double y)
{
    static VoxelStep steps[3 * MOST + 1];
    double origin[3], direction[3], sum = 0;
    ray_of(camera, x, y, origin, direction);
    const uint32_t count = voxel_walk(flat->size, origin, direction, steps);
    for (uint32_t i = 0; i < count; i++)
        if (view_case_get(flat, steps[i].voxel))
            sum += steps[i].leave - steps[i].enter;
    return sum * sqrt(vector_dot(direction, direction));
}

static void layers_take_their_share_of_light(void **state)
{
    (void)state;
    enum { SIZE = 16 };
    for (uint32_t layers = 1; layers <= 8; layers++) {
        Frame frame;
        view_case_begin(&frame);
        const FlatTexture flat = flat_texture_make(&frame, SIZE, 1);
        for (uint32_t i = 0; i < SIZE * SIZE * layers; i++)
            view_case_put(&flat, i % SIZE, 3 + i / SIZE % layers, i / SIZE / layers);
        VoxelView view = voxel_view_defaults;
        view.mode = VOXEL_TRANSPARENT;
        view.paint.opacity = 0.25f;
        view.camera = view_case_camera(SIZE, 0, 1, 0, 2, 0); /* along the layers' normal */
        view.camera.up[0] = 1;
        view_case_draw(&frame, &flat, &view);
        float pixel[4];
        view_case_pixel(&frame, "haze", SIDE / 2, SIDE / 2, pixel);
        assert_true(fabs((double)pixel[3] - (1 - pow(0.75, layers))) < 2e-3);
        frame_free(&frame);
    }
}

/* Halves of the sum so far are rounded once a slab. */
#define HALF_ERROR 0.01

/* How far alpha is outside what the rays beside the pixel's centre give: along a voxel's side they
 * see it or not. */
static double alpha_error(const FlatTexture *flat, const Camera *camera, int x, int y, double alpha)
{
    double least = 1, most = 0;
    for (int i = 0; i < 5; i++) {
        const double beside_x = i == 4 ? 0 : i & 1 ? BESIDE : -BESIDE;
        const double beside_y = i == 4 ? 0 : i & 2 ? BESIDE : -BESIDE;
        const double way = way_in_voxels(flat, camera, x + 0.5 + beside_x, y + 0.5 + beside_y);
        const double expected = 1 - pow(0.85, way);
        least = expected < least ? expected : least;
        most = expected > most ? expected : most;
    }
    return alpha < least ? least - alpha : alpha > most ? alpha - most : 0;
}

static void light_fades_by_the_way_in_voxels(void **state)
{
    (void)state;
    for (size_t i = 0; i + 1 < GP_COUNT(views); i++) {
        Frame frame;
        view_case_begin(&frame);
        const FlatTexture flat = view_case_random(&frame, views[i].size, 4, 100 + i);
        VoxelView view = voxel_view_defaults;
        view.mode = VOXEL_TRANSPARENT;
        view.paint.opacity = 0.15f;
        view.camera = view_case_camera(views[i].size, views[i].x, views[i].y, views[i].z,
                                       views[i].distance, views[i].fovy);
        view_case_draw(&frame, &flat, &view);
        int seen = 0;
        for (int y = 0; y < SIDE; y += 2)
            for (int x = 0; x < SIDE; x += 2) {
                float pixel[4];
                view_case_pixel(&frame, "haze", x, y, pixel);
                const double error = alpha_error(&flat, &view.camera, x, y, (double)pixel[3]);
                if (error > HALF_ERROR)
                    fail_msg("view %zu, pixel %d %d: alpha is %g off", i, x, y, error);
                seen += pixel[3] > 0.2f;
            }
        assert_true(seen > 100);
        frame_free(&frame);
    }
}

/* --- light ------------------------------------------------------------------------------------ */

/* Light of pictures/light.c on white, from the right, of a unit normal whose part to the right is
 * given and whose part towards the eye follows from the part upwards. */
static double light_of_ball(double right, double up)
{
    const double toward = sqrt(1 - right * right - up * up);
    return 0.28 + 0.72 * right + 0.22 * pow((right + toward) / sqrt(2), 40);
}

/* Mean difference of a picture of a solid ball from what its true normals give. */
static double ball_error(VoxelShading shading)
{
    enum { SIZE = 48 };
    const double centre = SIZE / 2.0, radius = 20;
    Frame frame;
    view_case_begin(&frame);
    const FlatTexture flat = flat_texture_make(&frame, SIZE, 1);
    for (uint32_t i = 0; i < SIZE * SIZE * SIZE; i++) {
        const double x = i % SIZE + 0.5 - centre, y = i / SIZE % SIZE + 0.5 - centre;
        const double z = i / SIZE / SIZE + 0.5 - centre;
        if (x * x + y * y + z * z < radius * radius)
            view_case_put(&flat, i % SIZE, i / SIZE % SIZE, i / SIZE / SIZE);
    }
    VoxelView view = voxel_view_defaults;
    view.shading = shading;
    view.paint = (VoxelPaint){ { 1, 1, 1 }, 0 };
    memcpy(view.light, (float[3]){ 1, 0, 0 }, sizeof view.light);
    view.camera = view_case_camera(SIZE, 0.4, 0.5, 1, 2, 0);
    view.camera.height = SIZE;
    view_case_draw(&frame, &flat, &view);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            const double scale = (double)SIZE / SIDE / radius;
            const double right = (x + 0.5 - SIDE / 2) * scale, up = (y + 0.5 - SIDE / 2) * scale;
            if (right * right + up * up > 0.9 || right < 0.05)
                continue;
            float pixel[4];
            gp_texel_load(GP_A8R8G8B8,
                          gp_surface_texel(&frame.color->level[0], 4, (uint32_t)x, (uint32_t)y),
                          pixel);
            const double expected = light_of_ball(right, up);
            sum += fabs((double)pixel[0] - (expected < 1 ? expected : 1));
            count++;
        }
    assert_true(count > 400);
    frame_free(&frame);
    return sum / count;
}

static void smooth_normals_are_those_of_the_ball(void **state)
{
    (void)state;
    const double smooth = ball_error(VOXEL_SMOOTH), faces = ball_error(VOXEL_FACES_OF_CUBES);
    if (smooth > 0.04 || faces < 0.12)
        fail_msg("mean error %g of smooth shading, %g of faces", smooth, faces);
}

/* --- refusals, and bits ----------------------------------------------------------------------- */

static void what_cannot_be_drawn_is_refused(void **state)
{
    (void)state;
    Frame frame;
    GpError error = { "" };
    view_case_begin(&frame);
    const FlatTexture a = flat_texture_make(&frame, 16, 1), b = flat_texture_make(&frame, 24, 1);
    VoxelView view = voxel_view_defaults;
    view.camera = view_case_camera(16, 1, 1, 1, 0.2, 100);
    assert_int_equal(voxel_view_build(&a, &view, SIDE, SIDE, &frame, &error), GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "too wide"));
    const VoxelRange range = { { 3, 4, 5 }, { 13, 14, 15 } };
    ViewSlices found;
    assert_int_equal(view_slices_find(&range, &view.camera, 1, &found, &error), GP_ERROR_INVALID);
    view.camera = view_case_camera(16, 1, 1, 1, 2, 30);
    assert_int_equal(view_slices_find(&range, &view.camera, 1, &found, &error), GP_OK);
    const uint32_t slices = view_slices_count(&found);
    assert_true(slices >= 10 && slices % 10 == 0);
    view.second = &b;
    assert_int_equal(voxel_view_build(&a, &view, SIDE, SIDE, &frame, &error), GP_ERROR_INVALID);
    assert_int_equal(frame.list.pass_count, 0);
    frame_free(&frame);
}

/* Pictures of all programs: opaque or not, smooth or faces, one volume, two, or a scan. */
static bool build_picture(Frame *frame, int number)
{
    enum { SIZE = 34, SECOND = 1, SCAN = 2, WIDTH = 35, HEIGHT = 40 };
    static uint8_t samples[SIZE * SIZE * SIZE], ramp[256][4];
    static const uint32_t dims[3] = { SIZE, SIZE, SIZE };
    static FlatTexture sheets[3];
    const int with = number / 4;
    Random random = { 3 };
    for (size_t i = 0; i < sizeof samples; i++)
        samples[i] = (uint8_t)random_bits(&random);
    for (int i = 0; i < 1024; i++)
        ramp[i / 4][i % 4] = (uint8_t)(i % 4 == 3 ? i / 64 : 255 - i / 8);
    view_case_begin(frame);
    sheets[0] = view_case_random(frame, SIZE, 40, 8);
    sheets[1] = view_case_random(frame, SIZE, 40, 9);
    VoxelView view = voxel_view_defaults;
    view.mode = number & 1;
    view.shading = number >> 1 & 1;
    view.camera = view_case_camera(SIZE, 0.5, 0.35, 0.8, 1.8, 38);
    if (with == SECOND)
        view.second = &sheets[1];
    if (with == SCAN) {
        const FlatTexture scan = voxel_scan(frame, samples, dims, NULL, SIZE);
        sheets[2] = voxel_scan_slopes(frame, &scan);
        view.scan = &sheets[2];
        view.transfer = &ramp[0][0];
    }
    GpError error = { "" };
    return !voxel_view_build(&sheets[0], &view, WIDTH, HEIGHT, frame, &error);
}

static void pictures_are_the_same_on_every_device(void **state)
{
    (void)state;
    for (int number = 0; number < 12; number++) {
        Frame frame;
        assert_true(build_picture(&frame, number));
        run_everywhere(&frame);
        frame_free(&frame);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_shows_the_first_voxel_of_its_ray),
        cmocka_unit_test(one_voxel_is_one_cube),
        cmocka_unit_test(kinds_tell_which_volumes_have_a_voxel),
        cmocka_unit_test(layers_take_their_share_of_light),
        cmocka_unit_test(light_fades_by_the_way_in_voxels),
        cmocka_unit_test(smooth_normals_are_those_of_the_ball),
        cmocka_unit_test(what_cannot_be_drawn_is_refused),
        cmocka_unit_test(pictures_are_the_same_on_every_device),
    };
    return cmocka_run_group_tests_name("voxel view", tests, NULL, NULL);
}
