/* What the shaders of splatted volumes cost: within the profiles that they name, and beside paper
 * 003's 42 slots of EWA, 32 of reconstruction alone and 28 of the low-pass filter alone, vertex and
 * pixel shader together. */
#include "shaders_c/common/texel_copy.h"
#include "shaders_c/volume/raycast.h"
#include "shaders_c/volume/sheet.h"
#include "shaders_c/volume/slices.h"
#include "shaders_c/volume/splat_after.h"
#include "shaders_c/volume/splat_flat.h"
#include "shaders_c/volume/splat_quad.h"
#include "shaders_c/volume/splat_slab.h"
#include "shaders_c/volume/splat_texture.h"
#include "tests/support/slots.h"

static const SlotsRow rows[] = {
    SLOTS_ROW(voxel_ewa, 87, 11),
    SLOTS_ROW(voxel_reconstruction, 87, 11),
    SLOTS_ROW(voxel_low_pass, 68, 11),
    SLOTS_ROW(voxel_vt_ewa, 96, 11),
    SLOTS_ROW(voxel_vt_reconstruction, 96, 11),
    SLOTS_ROW(voxel_vt_low_pass, 77, 11),
    SLOTS_ROW(voxel_pt_ewa, 83, 23),
    SLOTS_ROW(voxel_pt_reconstruction, 83, 23),
    SLOTS_ROW(voxel_pt_low_pass, 64, 23),
    SLOTS_ROW(voxel_qd_ewa, 96, 11),
    SLOTS_ROW(voxel_qd_reconstruction, 96, 11),
    SLOTS_ROW(voxel_qd_low_pass, 77, 11),
    SLOTS_ROW(voxel_slab_ewa, 112, 11),
    SLOTS_ROW(voxel_slab_reconstruction, 112, 11),
    SLOTS_ROW(voxel_slab_low_pass, 93, 11),
    SLOTS_ROW(voxel_flat_ewa, 119, 11),
    SLOTS_ROW(voxel_flat_reconstruction, 119, 11),
    SLOTS_ROW(voxel_after_ewa, 93, 11),
    SLOTS_ROW(voxel_after_reconstruction, 93, 11),
    SLOTS_ROW(voxel_after_low_pass, 74, 11),
    SLOTS_ROW(sheets_after, 1, 62),
    SLOTS_ROW(sheets, 1, 41),
    SLOTS_ROW(sheets_of_alphas, 1, 14),
    SLOTS_ROW(sheets_over, 1, 2),
    SLOTS_ROW(sheets_opaque, 1, 4),
    SLOTS_ROW(texel_depth, 1, 3), /* rays and slices were not in the paper */
    SLOTS_ROW(raycast, 3, 233),
    SLOTS_ROW(raycast_lit, 3, 475),
    SLOTS_ROW(volume_slice, 8, 19),
    SLOTS_ROW(volume_slice_lit, 8, 58),
};

static void shaders_stay_within_profiles_and_slots(void **state)
{
    (void)state;
    check_slots(rows, GP_COUNT(rows));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shaders_stay_within_profiles_and_slots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
