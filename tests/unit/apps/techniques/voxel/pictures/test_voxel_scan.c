/* Scanned volumes: their samples as voxels, and how much light they let through. */
#include "apps/techniques/voxel/pictures/scan.h"
#include "tests/support/unit.h"
#include "tests/support/view_case.h"

#include <math.h>

enum { MIDDLE = VIEW_CASE_SIDE / 2 };

static void scans_are_linear_between_samples(void **state)
{
    (void)state;
    static const uint8_t samples[2][2][2] = { { { 0, 40 }, { 80, 120 } },
                                              { { 100, 140 }, { 180, 220 } } };
    const uint32_t dims[3] = { 2, 2, 2 };
    Frame frame;
    view_case_begin(&frame);
    const FlatTexture scan = voxel_scan(&frame, &samples[0][0][0], dims, (double[3]){ 2, 2, 2 }, 8);
    uint8_t voxels[512];
    flat_texture_read(&scan, voxels);
    for (uint32_t i = 0; i < 512; i++) {
        const int at[3] = { (int)(i % 8), (int)(i / 8 % 8), (int)(i / 64) };
        static const int step[3] = { 40, 80, 100 };
        int sum = 0;
        bool inside = true;
        for (int k = 0; k < 3; k++) {
            /* samples lie at 3 and 5: voxels from 2 to 5, whose centres are 2.5 to 5.5 */
            const double past = (at[k] + 0.5 - 3) / 2;
            inside = inside && at[k] >= 2 && at[k] <= 5;
            sum += (int)(step[k] * (past < 0 ? 0 : past > 1 ? 1 : past));
        }
        assert_int_equal(voxels[i], inside ? sum : 0);
    }
    frame_free(&frame);
}

/* --- a block of one density ------------------------------------------------------------------- */

enum { SIZE = 16, DENSITY = 200 };

static FlatTexture scan_of_block(Frame *frame)
{
    static uint8_t samples[SIZE * SIZE * SIZE];
    static const uint32_t dims[3] = { SIZE, SIZE, SIZE };
    memset(samples, DENSITY, sizeof samples);
    const FlatTexture scan = voxel_scan(frame, samples, dims, NULL, SIZE);
    return voxel_scan_slopes(frame, &scan);
}

/* A block of one density absorbs as its ramp says. */
static void scans_fade_light_by_their_ramp(void **state)
{
    (void)state;
    static uint8_t ramp[256][4];
    ramp[DENSITY][3] = 51; /* a fifth */
    Frame frame;
    view_case_begin(&frame);
    const FlatTexture slopes = scan_of_block(&frame);
    const FlatTexture none = flat_texture_make(&frame, SIZE, 1);
    VoxelView view = voxel_view_defaults;
    view.mode = VOXEL_TRANSPARENT;
    view.scan = &slopes;
    view.transfer = &ramp[0][0];
    view.camera = view_case_camera(SIZE, 0, 0.3, 1, 2, 0);
    view_case_draw(&frame, &none, &view);
    float pixel[4];
    view_case_pixel(&frame, "haze", MIDDLE, MIDDLE, pixel);
    const double way = SIZE * sqrt(1 + 0.3 * 0.3); /* in front, out behind */
    assert_true(fabs((double)pixel[3] - (1 - pow(0.8, way))) < 0.01);
    frame_free(&frame);
}

/* A wall of voxels in the centre of a block: from in front, half of the block is seen. */
static void opaque_voxels_hide_the_scan_behind_them(void **state)
{
    (void)state;
    enum { WALL = 7 };
    static uint8_t ramp[256][4];
    ramp[DENSITY][3] = 26;
    Frame frame;
    view_case_begin(&frame);
    const FlatTexture slopes = scan_of_block(&frame);
    const FlatTexture wall = flat_texture_make(&frame, SIZE, 1);
    for (uint32_t i = 0; i < SIZE * SIZE; i++)
        view_case_put(&wall, i % SIZE, i / SIZE, WALL);
    VoxelView view = voxel_view_defaults;
    view.scan = &slopes;
    view.transfer = &ramp[0][0];
    view.camera = view_case_camera(SIZE, 0, 0, 1, 2, 0);
    view_case_draw(&frame, &wall, &view);
    float pixel[4];
    view_case_pixel(&frame, "haze", MIDDLE, MIDDLE, pixel);
    const double in_front = SIZE - 1 - WALL, seen = 1 - 26 / 255.0;
    assert_true(fabs((double)pixel[3] - (1 - pow(seen, in_front))) < 0.005);
    frame_free(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scans_are_linear_between_samples),
        cmocka_unit_test(scans_fade_light_by_their_ramp),
        cmocka_unit_test(opaque_voxels_hide_the_scan_behind_them),
    };
    return cmocka_run_group_tests_name("voxel scan", tests, NULL, NULL);
}
