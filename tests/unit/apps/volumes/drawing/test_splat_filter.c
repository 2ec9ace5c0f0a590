/* Which filter voxels need: the thresholds of paper 003, (8) and 4.1.5, for eyes of any opening. */
#include "apps/volumes/drawing/splat_filter.h"

#include "tests/support/unit.h"

#include <math.h>

static VoxelEye eye_of(double half_height)
{
    return (VoxelEye){ .focal = 150 / half_height,
                       .half_width = half_height,
                       .half_height = half_height,
                       .near = 0.01,
                       .least = 1,
                       .reach = 1.5,
                       .low_pass = 2 };
}

/* rk / rh, with rh in the plane at distance 1. */
static double ratio_of(const VoxelEye *eye)
{
    return eye->reach / (eye->low_pass / eye->focal);
}

static double most_of(const VoxelEye *eye)
{
    const double wide = 1 + 2 * eye->half_height;
    return ratio_of(eye) * 2 * pow(wide, 2);
}

static const double half_heights[] = { 0.1, 0.36, 0.58, 1, 1.7 };

static void what_is_near_is_reconstructed_and_what_is_far_is_smoothed(void **state)
{
    (void)state;
    const VolumeSplatSetting setting = { .filter = VOXEL_ADAPTIVE };
    for (size_t i = 0; i < GP_COUNT(half_heights); i++) {
        const VoxelEye eye = eye_of(half_heights[i]);
        const double least = 0.3 * ratio_of(&eye), most = most_of(&eye);
        const struct {
            double nearest, farthest;
            VoxelFilter filter;
        } rows[] = {
            { least / 2, least * 0.999, VOXEL_RECONSTRUCTION },
            { least / 2, least * 1.001, VOXEL_EWA }, /* one corner is too far */
            { least * 1.001, most * 0.999, VOXEL_EWA },
            { most * 0.999, most * 9, VOXEL_EWA }, /* one corner is too near */
            { most * 1.001, most * 9, VOXEL_LOW_PASS },
            { eye.near / 2, least / 2, VOXEL_EWA }, /* in front of the near plane */
        };
        for (size_t k = 0; k < GP_COUNT(rows); k++)
            assert_int_equal(
                splat_filter_of_depths(&eye, &setting, rows[k].nearest, rows[k].farthest),
                rows[k].filter);
    }
}

/* Wherever the eye is, and however much it sees. */
static void parallel_rays_have_one_filter(void **state)
{
    (void)state;
    static const struct {
        double focal; /* pixels a unit */
        VoxelFilter filter;
        VoxelSums sums;
    } rows[] = {
        { 0.6, VOXEL_LOW_PASS, VOXEL_HALVES }, /* rk / rh is 0.45, of which twice is below 1 */
        { 0.7, VOXEL_EWA, VOXEL_HALVES },
        { 4.4, VOXEL_EWA, VOXEL_BYTES }, /* 3.3, of which 0.3 is below 1, and 0.6 above it */
        { 4.5, VOXEL_RECONSTRUCTION, VOXEL_BYTES },
    };
    const VolumeSplatSetting setting = { .filter = VOXEL_ADAPTIVE, .sums = VOXEL_BYTES_NEAR };
    const Field field = { .size = { 9, 9, 9 }, .scale = { 1, 1, 1 } };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        for (double distance = 1e-3; distance < 1e6; distance *= 10) {
            VoxelEye eye = eye_of(3 + distance);
            eye.parallel = true;
            eye.focal = rows[i].focal;
            eye.position[2] = -distance;
            assert_int_equal(splat_filter_of_depths(&eye, &setting, distance, distance + 8),
                             rows[i].filter);
            assert_int_equal(splat_sums(&eye, &field, &setting), rows[i].sums);
        }
}

static void what_a_setting_says_is_taken(void **state)
{
    (void)state;
    const VoxelEye eye = eye_of(0.5);
    for (VoxelFilter filter = 0; filter < VOXEL_ADAPTIVE; filter++)
        for (double at = 1e-3; at < 1e9; at *= 10)
            assert_int_equal(
                splat_filter_of_depths(&eye, &(VolumeSplatSetting){ .filter = filter }, at, 2 * at),
                filter);
}

/* From beside a corner of the volume's box, an edge and a side of it, and from inside. */
static void sums_are_halves_from_far_away(void **state)
{
    (void)state;
    const Field field = { .size = { 11, 21, 31 }, .scale = { 1, 2, 0.5 } };
    static const double ways[][3] = { { -2, -3, -6 }, { 0, -3, 4 }, { 0, 0, 1 }, { 1, 0, 0 } };
    static const double lengths[] = { 7, 5, 1, 1 };
    for (size_t i = 0; i < GP_COUNT(half_heights); i++)
        for (size_t w = 0; w < GP_COUNT(ways); w++)
            for (int far = 0; far < 2; far++) {
                VoxelEye eye = eye_of(half_heights[i]);
                const double away = 0.3 * most_of(&eye) * (far ? 1.001 : 0.999) / lengths[w];
                for (int k = 0; k < 3; k++) {
                    const double end = (field.size[k] - 1) * field.scale[k];
                    const double from = ways[w][k] < 0 ? 0 : ways[w][k] > 0 ? end : end / 3;
                    eye.position[k] = from + away * ways[w][k];
                }
                const VolumeSplatSetting open = { .sums = VOXEL_BYTES_NEAR };
                assert_int_equal(splat_sums(&eye, &field, &open), far ? VOXEL_HALVES : VOXEL_BYTES);
                for (VoxelSums sums = 0; sums < VOXEL_BYTES_NEAR; sums++)
                    assert_int_equal(
                        splat_sums(&eye, &field, &(VolumeSplatSetting){ .sums = sums }), sums);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_near_is_reconstructed_and_what_is_far_is_smoothed),
        cmocka_unit_test(parallel_rays_have_one_filter),
        cmocka_unit_test(what_a_setting_says_is_taken),
        cmocka_unit_test(sums_are_halves_from_far_away),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
