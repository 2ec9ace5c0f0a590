/* What the shaders of splatted volumes cost: within the profiles that they name, and beside paper 003's 42
 * slots of EWA, 32 of reconstruction alone and 28 of the low-pass filter alone, vertex and pixel shader
 * together. */
#include "pipeline/shader/counts.h"
#include "shaders_c/common/texel_copy.h"
#include "shaders_c/volume/raycast.h"
#include "shaders_c/volume/sheet.h"
#include "shaders_c/volume/slices.h"
#include "shaders_c/volume/splat_after.h"
#include "shaders_c/volume/splat_flat.h"
#include "shaders_c/volume/splat_quad.h"
#include "shaders_c/volume/splat_slab.h"
#include "shaders_c/volume/splat_texture.h"
#include "tests/support/unit.h"

static const struct {
    const GpProgram *program;
    int vertex, pixel; /* slots at most: what they take today */
} rows[] = {
#define ROW(name, vertex, pixel)                                                                   \
    {                                                                                              \
        &name##_program, vertex, pixel                                                             \
    }
    ROW(voxel_ewa, 87, 11),
    ROW(voxel_reconstruction, 87, 11),
    ROW(voxel_low_pass, 68, 11),
    ROW(voxel_vt_ewa, 96, 11),
    ROW(voxel_vt_reconstruction, 96, 11),
    ROW(voxel_vt_low_pass, 77, 11),
    ROW(voxel_pt_ewa, 83, 23),
    ROW(voxel_pt_reconstruction, 83, 23),
    ROW(voxel_pt_low_pass, 64, 23),
    ROW(voxel_qd_ewa, 96, 11),
    ROW(voxel_qd_reconstruction, 96, 11),
    ROW(voxel_qd_low_pass, 77, 11),
    ROW(voxel_slab_ewa, 112, 11),
    ROW(voxel_slab_reconstruction, 112, 11),
    ROW(voxel_slab_low_pass, 93, 11),
    ROW(voxel_flat_ewa, 119, 11),
    ROW(voxel_flat_reconstruction, 119, 11),
    ROW(voxel_after_ewa, 93, 11),
    ROW(voxel_after_reconstruction, 93, 11),
    ROW(voxel_after_low_pass, 74, 11),
    ROW(sheets_after, 1, 62),
    ROW(sheets, 1, 41),
    ROW(sheets_of_alphas, 1, 14),
    ROW(sheets_over, 1, 2),
    ROW(sheets_opaque, 1, 4),
    ROW(texel_depth, 1, 3), /* rays and slices were not in the paper */
    ROW(raycast, 3, 233),
    ROW(raycast_lit, 3, 475),
    ROW(volume_slice, 8, 19),
    ROW(volume_slice_lit, 8, 58),
};

static void shaders_stay_within_profiles_and_slots(void **state)
{
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const GpProgram *program = rows[i].program;
        GpShaderCounts vertex = { 0 }, pixel = { 0 };
        GpError error = { "" };
        if (gp_program_check(program, &error))
            fail_msg("%s", error.text);
        if (!program->count)
            skip();
        program->count(program, &vertex, &pixel);
        print_message("# %s: %d slots, %d registers; %d slots, %d registers\n", program->name,
                      vertex.slots, vertex.temporaries, pixel.slots, pixel.temporaries);
        failed += vertex.slots > rows[i].vertex || pixel.slots > rows[i].pixel;
    }
    assert_int_equal(failed, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shaders_stay_within_profiles_and_slots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
