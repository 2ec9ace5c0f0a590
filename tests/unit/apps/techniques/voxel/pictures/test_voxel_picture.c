/* Pictures of models as the command makes them: all of them is seen, the right way up, with what
 * two have in common, and with scans of every type. */
#include "apps/techniques/voxel/options.h"
#include "tests/support/unit.h"
#include "tests/support/view_case.h"

#include <math.h>

enum { SIZE = 24, MOST_PIXELS = 96 };

/* An empty volume. */
static void begin(Frame *frame, VoxelPairMade *made)
{
    *frame = (Frame){ .color = NULL };
    *made = (VoxelPairMade){ .range = voxel_range_whole(SIZE), .around = voxel_range_whole(SIZE) };
    for (int i = 0; i < 2; i++)
        made->volumes[i] = flat_texture_make(frame, SIZE, 1);
    made->result = made->volumes[0];
}

static void draw(const VoxelPicture *picture, const VoxelPairMade *made, const GpVolume *scan,
                 Frame *frame)
{
    GpError error = { "" };
    GpDevice *device = NULL;
    if (voxel_picture_build(picture, made, scan, frame, &error))
        fail_msg("%s", error.text);
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &device, &error), GP_OK);
    if (gp_device_run(device, &frame->list, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
}

static void fill_range(const FlatTexture *flat, const VoxelRange *range)
{
    for (uint32_t z = range->low[2]; z < range->end[2]; z++)
        for (uint32_t y = range->low[1]; y < range->end[1]; y++)
            for (uint32_t x = range->low[0]; x < range->end[0]; x++)
                view_case_put(flat, x, y, z);
}

static void get_pixel(const Frame *frame, uint32_t x, uint32_t y, float rgba[4])
{
    gp_texel_load(GP_A8R8G8B8, gp_surface_texel(&frame->color->level[0], 4, x, y), rgba);
}

static bool is_background(const float rgba[4])
{
    for (int c = 0; c < 3; c++)
        if (fabsf(rgba[c] - voxel_view_defaults.background[c]) > 1.5f / 255)
            return false;
    return true;
}

/* Pixels from the picture's left, right, top and bottom to what is seen. */
static void find_borders(const Frame *frame, const VoxelPicture *picture, uint32_t borders[4])
{
    borders[0] = borders[1] = picture->width;
    borders[2] = borders[3] = picture->height;
    for (uint32_t y = 0; y < picture->height; y++)
        for (uint32_t x = 0; x < picture->width; x++) {
            float rgba[4];
            get_pixel(frame, x, y, rgba);
            const uint32_t from[4] = { x, picture->width - 1 - x, y, picture->height - 1 - y };
            for (int i = 0; i < 4 && !is_background(rgba); i++)
                borders[i] = from[i] < borders[i] ? from[i] : borders[i];
        }
}

static void every_view_shows_all_of_the_box(void **state)
{
    (void)state;
    static const VoxelRange ranges[] = { { { 0, 0, 0 }, { SIZE, SIZE, SIZE } },
                                         { { 3, 10, 2 }, { 20, 12, 19 } },
                                         { { 4, 0, 0 }, { 5, SIZE, 3 } } };
    static const double views[][2] = { { 30, 20 }, { 0, 0 }, { -100, -50 }, { 225, 85 } };
    static const uint32_t sizes[][2] = { { 64, 64 }, { MOST_PIXELS, 40 }, { 32, MOST_PIXELS } };
    for (size_t i = 0; i < GP_COUNT(ranges) * GP_COUNT(views) * GP_COUNT(sizes); i++) {
        const double *view = views[i / GP_COUNT(sizes) % GP_COUNT(views)];
        VoxelPicture picture = voxel_option_defaults.picture;
        picture.width = sizes[i % GP_COUNT(sizes)][0];
        picture.height = sizes[i % GP_COUNT(sizes)][1];
        picture.orbit.azimuth = view[0];
        picture.orbit.elevation = view[1];
        picture.orbit.up = (OrbitUp)(i % 5);
        Frame frame;
        VoxelPairMade made;
        begin(&frame, &made);
        made.range = ranges[i / GP_COUNT(sizes) / GP_COUNT(views)];
        fill_range(&made.result, &made.range);
        draw(&picture, &made, NULL, &frame);
        uint32_t borders[4];
        find_borders(&frame, &picture, borders);
        for (int k = 0; k < 4; k++)
            assert_true(borders[k] >= 1);
        /* and none of it is wasted: the box is near some side */
        const uint32_t least_x = borders[0] < borders[1] ? borders[0] : borders[1];
        const uint32_t least_y = borders[2] < borders[3] ? borders[2] : borders[3];
        assert_true(least_x <= picture.width / 10 || least_y <= picture.height / 10);
        frame_free(&frame);
    }
}

static void the_axis_that_is_up_points_up(void **state)
{
    (void)state;
    /* y, z, x, -y, -z: voxels at that end of the volume */
    static const VoxelRange ends[] = {
        { { 8, 20, 8 }, { 16, 24, 16 } }, { { 8, 8, 20 }, { 16, 16, 24 } },
        { { 20, 8, 8 }, { 24, 16, 16 } }, { { 8, 0, 8 }, { 16, 4, 16 } },
        { { 8, 8, 0 }, { 16, 16, 4 } },
    };
    for (size_t i = 0; i < GP_COUNT(ends); i++) {
        VoxelPicture picture = voxel_option_defaults.picture;
        picture.width = picture.height = 64;
        picture.orbit.up = (OrbitUp)i;
        Frame frame;
        VoxelPairMade made;
        begin(&frame, &made);
        fill_range(&made.result, &ends[i]);
        draw(&picture, &made, NULL, &frame);
        uint32_t borders[4];
        find_borders(&frame, &picture, borders);
        assert_true(borders[2] < 20 && borders[3] > 36); /* all of it in the upper half */
        frame_free(&frame);
    }
}

static void a_zoom_makes_it_larger(void **state)
{
    (void)state;
    uint32_t before = 0;
    static const double zooms[] = { 0.25, 0.5, 1 };
    for (size_t i = 0; i < GP_COUNT(zooms); i++) {
        VoxelPicture picture = voxel_option_defaults.picture;
        picture.width = picture.height = 64;
        picture.orbit.zoom = zooms[i];
        Frame frame;
        VoxelPairMade made;
        begin(&frame, &made);
        fill_range(&made.result, &made.range);
        draw(&picture, &made, NULL, &frame);
        uint32_t borders[4];
        find_borders(&frame, &picture, borders);
        const uint32_t wide = 64 - borders[0] - borders[1];
        assert_in_range(wide, i ? 2 * before - 4 : 1, i ? 2 * before + 4 : 20);
        before = wide;
        frame_free(&frame);
    }
}

/* Pixels that are more red than all else. */
static int count_red(const Frame *frame, const VoxelPicture *picture)
{
    int count = 0;
    for (uint32_t y = 0; y < picture->height; y++)
        for (uint32_t x = 0; x < picture->width; x++) {
            float rgba[4];
            get_pixel(frame, x, y, rgba);
            count += rgba[2] < rgba[0] * 0.5f && rgba[1] < rgba[0] * 0.5f;
        }
    return count;
}

static void what_two_have_in_common_is_red(void **state)
{
    (void)state;
    for (int touching = 0; touching < 2; touching++)
        for (VoxelViewMode look = VOXEL_OPAQUE; look <= VOXEL_TRANSPARENT; look++) {
            VoxelPicture picture = voxel_option_defaults.picture;
            picture.width = picture.height = 64;
            picture.shows_both = true;
            picture.look = look;
            const uint32_t first = touching ? 10 : 12;
            const VoxelRange boxes[2] = { { { 4, 4, 4 }, { 12, 20, 20 } },
                                          { { first, 4, 4 }, { 20, 20, 20 } } };
            Frame frame;
            VoxelPairMade made;
            begin(&frame, &made);
            for (int i = 0; i < 2; i++)
                fill_range(&made.volumes[i], &boxes[i]);
            draw(&picture, &made, NULL, &frame);
            const int red = count_red(&frame, &picture);
            assert_true(touching ? red > 20 : red == 0);
            frame_free(&frame);
        }
}

/* --- scans ------------------------------------------------------------------------------------ */

enum { SCAN = 16, SAMPLES = SCAN * SCAN * SCAN };

/* A ball of bone in skin. */
static uint8_t ball_sample(int i)
{
    const int x = i % SCAN - SCAN / 2, y = i / SCAN % SCAN - SCAN / 2,
              z = i / SCAN / SCAN - SCAN / 2;
    const int square = x * x + y * y + z * z;
    return square < 10 ? 255 : square < 40 ? 90 : 0;
}

static uint64_t hash_of_scan(GpVolumeType type, void *data, bool has_model, VoxelViewMode look)
{
    const GpVolume scan = {
        .dims = { SCAN, SCAN, SCAN }, .type = type, .spacing = { 1, 1, 1 }, .data = data
    };
    VoxelPicture picture = voxel_option_defaults.picture;
    picture.width = picture.height = 64;
    picture.look = look;
    Frame frame;
    VoxelPairMade made;
    begin(&frame, &made);
    if (has_model)
        fill_range(&made.result, &(VoxelRange){ { 10, 10, 10 }, { 14, 14, 14 } });
    draw(&picture, &made, &scan, &frame);
    const uint64_t hash = gp_surface_hash(frame.color);
    frame_free(&frame);
    return hash;
}

static void scans_of_every_type_look_alike(void **state)
{
    (void)state;
    static uint8_t bytes[SAMPLES];
    static uint16_t words[SAMPLES];
    static int16_t integers[SAMPLES];
    static float floats[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        bytes[i] = ball_sample(i);
        words[i] = (uint16_t)(bytes[i] * 257);
        integers[i] = (int16_t)(4 * bytes[i] - 1000);
        floats[i] = bytes[i] / 255.0f;
    }
    const uint64_t hash = hash_of_scan(GP_VOLUME_U8, bytes, false, VOXEL_TRANSPARENT);
    assert_true(hash_of_scan(GP_VOLUME_U16, words, false, VOXEL_TRANSPARENT) == hash);
    assert_true(hash_of_scan(GP_VOLUME_I16, integers, false, VOXEL_TRANSPARENT) == hash);
    assert_true(hash_of_scan(GP_VOLUME_F32, floats, false, VOXEL_TRANSPARENT) == hash);
    floats[0] = NAN; /* what is no number is nothing */
    assert_true(hash_of_scan(GP_VOLUME_F32, floats, false, VOXEL_TRANSPARENT) == hash);
    memset(bytes, 77, sizeof bytes); /* all alike: nothing */
    assert_true(hash_of_scan(GP_VOLUME_U8, bytes, false, VOXEL_TRANSPARENT) != hash);
}

static void a_model_is_seen_in_a_scan(void **state)
{
    (void)state;
    static uint8_t bytes[SAMPLES];

    for (int i = 0; i < SAMPLES; i++)
        bytes[i] = ball_sample(i);
    for (VoxelViewMode look = VOXEL_OPAQUE; look <= VOXEL_TRANSPARENT; look++)
        assert_true(hash_of_scan(GP_VOLUME_U8, bytes, true, look) !=
                    hash_of_scan(GP_VOLUME_U8, bytes, false, look));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_view_shows_all_of_the_box),
        cmocka_unit_test(the_axis_that_is_up_points_up),
        cmocka_unit_test(a_zoom_makes_it_larger),
        cmocka_unit_test(what_two_have_in_common_is_red),
        cmocka_unit_test(scans_of_every_type_look_alike),
        cmocka_unit_test(a_model_is_seen_in_a_scan),
    };
    return cmocka_run_group_tests_name("voxel picture", tests, NULL, NULL);
}
