/* The printed method with 8 and 16 bits a voxel: what voxels hold. And the bits of all of it: the
 * same on every device, within the profiles that shaders declare. */
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

#include "pipeline/shader/counts.h"
#include "shaders_c/voxel/volume/patch_copy.h"
#include "shaders_c/voxel/methods/rows.h"
#include "shaders_c/voxel/methods/sheets.h"
#include "shaders_c/voxel/methods/turn.h"

#include <math.h>

static VoxelSetting with_value(uint32_t size, uint32_t bits, VoxelValue value, VoxelBlend blend)
{
    return (VoxelSetting){ .method = VOXEL_SHEETS,
                           .size = size,
                           .bits = bits,
                           .blend = blend,
                           .axes = 3,
                           .value = value };
}

static uint32_t value_at(const uint8_t *voxels, uint32_t bits, size_t voxel)
{
    return bits == 8 ? voxels[voxel] : voxels[2 * voxel] | (uint32_t)voxels[2 * voxel + 1] << 8;
}

/* A value is where a bit is, and nowhere else; also in volumes that do not fill their last slab. */
static void values_are_where_bits_are(void **state)
{
    (void)state;
    static const uint32_t sizes[] = { 32, 45, 64 };
    for (size_t i = 0; i < GP_COUNT(sizes); i++)
        for (uint32_t bits = 8; bits <= 16; bits += 8)
            for (VoxelValue value = VOXEL_DENSITY; value <= VOXEL_COLOR; value++) {
                const uint32_t size = sizes[i];
                VoxelCase given = voxel_case_open("torus", 0.5, size);
                VoxelSetting setting = with_value(size, 1, VOXEL_DENSITY, VOXEL_OR);
                uint8_t *set = voxel_case_volume(&given, &setting);
                setting = with_value(size, bits, value, VOXEL_OR);
                uint8_t *values = voxel_case_volume(&given, &setting);
                for (size_t v = 0; v < (size_t)size * size * size; v++)
                    assert_int_equal(set[v / 8] >> v % 8 & 1, value_at(values, bits, v) != 0);
                gp_free(set);
                gp_free(values);
                voxel_case_free(&given);
            }
}

/* Samples of a triangle that are met, for certain or perhaps. */
static uint32_t count_samples(const VoxelCase *given, double margin, uint8_t *scratch)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < given->model.triangle_count; i++) {
        memset(scratch, 0, voxel_bytes(given->size));
        voxel_thin(&given->triangles[i], 1, given->size, 0, margin, scratch);
        count += (uint32_t)voxel_count(scratch, given->size);
    }
    return count;
}

/* Weighted adding, with weight 1: what a voxel holds is the number of its fragments. */
static void densities_count_fragments(void **state)
{
    (void)state;
    enum { SIZE = 32 };
    VoxelCase given = voxel_case_open("cube", 1, SIZE);
    uint8_t scratch[SIZE * SIZE * SIZE / 8];
    const uint32_t least = count_samples(&given, -1.0 / 128, scratch);
    const uint32_t most = count_samples(&given, 1.0 / 128, scratch);
    for (uint32_t bits = 8; bits <= 16; bits += 8) {
        VoxelSetting setting = with_value(SIZE, bits, VOXEL_DENSITY, VOXEL_ADD);
        uint8_t *counts = voxel_case_volume(&given, &setting);
        uint32_t sum = 0, more = 0;
        for (size_t v = 0; v < SIZE * SIZE * SIZE; v++) {
            sum += value_at(counts, bits, v);
            more += value_at(counts, bits, v) > 1;
        }
        assert_in_range(sum, least, most);
        assert_true(more > 0);
        setting.blend = VOXEL_OR;
        uint8_t *all = voxel_case_volume(&given, &setting);
        for (size_t v = 0; v < SIZE * SIZE * SIZE; v++)
            assert_int_equal(value_at(all, bits, v),
                             value_at(counts, bits, v) ? (1u << bits) - 1 : 0);
        gp_free(counts);
        gp_free(all);
    }
    voxel_case_free(&given);
}

/* The other way round from shaders_c/voxel/methods/sheets.c. */
static void decode_normal(uint32_t code, uint32_t bits, double normal[3])
{
    const uint32_t level = bits == 8 ? 14 : 254, next = bits == 8 ? 16 : 256;
    double x = 2.0 * (code % next - 1.0) / level - 1, y = 2.0 * (code / next - 1.0) / level - 1;
    double z = 1 - fabs(x) - fabs(y);
    if (z < 0) {
        double folded = (x < 0 ? -1 : 1) * (1 - fabs(y));
        y = (y < 0 ? -1 : 1) * (1 - fabs(x));
        x = folded;
    }
    double length = sqrt(x * x + y * y + z * z);
    normal[0] = x / length;
    normal[1] = y / length;
    normal[2] = z / length;
}

/* On a sphere normals point away from the centre, but for what codes round and what a voxel spans;
 * where the model is turned they turn with it. */
static void normals_point_outwards(void **state)
{
    (void)state;
    enum { SIZE = 64 };
    static const struct {
        uint32_t bits;
        double most; /* degrees */
    } cases[] = { { 8, 15.7 }, { 16, 1.5 } };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        VoxelCase given = voxel_case_open("sphere", 0.6, SIZE);
        VoxelSetting setting = with_value(SIZE, cases[i].bits, VOXEL_NORMAL, VOXEL_OR);
        uint8_t *values = voxel_case_volume(&given, &setting);
        double worst = 1;
        uint32_t found = 0;
        for (size_t v = 0; v < SIZE * SIZE * SIZE; v++) {
            uint32_t code = value_at(values, cases[i].bits, v);
            if (code == 0)
                continue;
            const double away[3] = { (double)(v % SIZE) + 0.5 - SIZE / 2,
                                     (double)(v / SIZE % SIZE) + 0.5 - SIZE / 2,
                                     (double)(v / SIZE / SIZE) + 0.5 - SIZE / 2 };
            double normal[3];
            decode_normal(code, cases[i].bits, normal);
            worst = fmin(worst, vector_dot(normal, away) / sqrt(vector_dot(away, away)));
            found++;
        }
        assert_true(found > 1000);
        assert_true(acos(worst) * 180 / M_PI < cases[i].most);
        gp_free(values);
        voxel_case_free(&given);
    }
}

/* A model coloured by place has in each voxel that voxel's place, but for rounding and mixing. */
static void colors_are_those_of_the_place(void **state)
{
    (void)state;
    enum { SIZE = 32 };
    static const int levels[2][3] = { { 7, 7, 3 }, { 31, 63, 31 } };
    static const int shifts[2][3] = { { 5, 2, 0 }, { 11, 5, 0 } };
    VoxelCase given = voxel_case_open("sphere", 0, SIZE);
    for (int wide = 0; wide < 2; wide++) {
        VoxelSetting setting = with_value(SIZE, wide ? 16 : 8, VOXEL_COLOR, VOXEL_OR);
        uint8_t *values = voxel_case_volume(&given, &setting);
        double worst[3] = { 0 };
        for (size_t v = 0; v < SIZE * SIZE * SIZE; v++) {
            uint32_t code = value_at(values, setting.bits, v);
            const size_t place[3] = { v % SIZE, v / SIZE % SIZE, v / SIZE / SIZE };
            for (int k = 0; k < 3 && code; k++) {
                double color =
                    (double)(code >> shifts[wide][k] & (uint32_t)levels[wide][k]) / levels[wide][k];
                worst[k] = fmax(worst[k], fabs(color - ((double)place[k] + 0.5) / SIZE));
            }
        }
        for (int k = 0; k < 3; k++) /* half a step of the code, and a little of the voxel */
            assert_true(worst[k] < 0.5 / levels[wide][k] + 0.5 / SIZE);
        gp_free(values);
    }
    voxel_case_free(&given);
}

/* --- devices ---------------------------------------------------------------------------------- */

static void all_devices_make_the_same_bits(void **state)
{
    (void)state;
    enum { MOST = 40 };
    static uint8_t voxels[MOST * MOST * MOST * 2];
    VoxelSetting settings[] = {
        with_value(40, 1, VOXEL_DENSITY, VOXEL_ADD), with_value(40, 1, VOXEL_DENSITY, VOXEL_OR),
        with_value(21, 8, VOXEL_DENSITY, VOXEL_ADD), with_value(21, 8, VOXEL_NORMAL, VOXEL_OR),
        with_value(21, 16, VOXEL_NORMAL, VOXEL_OR),  with_value(21, 8, VOXEL_COLOR, VOXEL_OR),
        with_value(21, 16, VOXEL_COLOR, VOXEL_OR),   with_value(40, 1, VOXEL_DENSITY, VOXEL_OR),
    };
    settings[GP_COUNT(settings) - 1].kind = VOXEL_SOLID;
    for (size_t i = 0; i < GP_COUNT(settings); i++) {
        VoxelCase given = voxel_case_open("teapot", 0.3, settings[i].size);
        memset(voxels, 0, sizeof voxels);
        voxel_case_draw(&given, &settings[i], true, voxels);
        int set = 0;
        for (size_t v = 0; v < sizeof voxels; v++)
            set += voxels[v] != 0;
        assert_true(set > 20);
        voxel_case_free(&given);
    }
}

/* What fits the profile, and by how much. */
static void shaders_are_within_their_profiles(void **state)
{
    (void)state;
    static const struct {
        const GpProgram *program;
        int slots, dependent; /* of the pixel shader */
    } known[] = {
        { &voxel_bits_program, 46, 1 },       { &voxel_density_program, 48, 0 },
        { &voxel_normals_program, 83, 0 },    { &voxel_colors_program, 55, 0 },
        { &voxel_turn_bits_program, 425, 3 }, { &voxel_turn_bytes_program, 65, 2 },
        { &voxel_turn_pairs_program, 46, 2 }, { &voxel_found_program, 254, 2 },
        { &voxel_row_ends_program, 27, 5 },   { &voxel_rows_program, 285, 5 },
        { &patch_copy_program, 2, 0 },
    };
    for (size_t i = 0; i < GP_COUNT(known); i++) {
        GpError error = { "" };
        if (gp_program_check(known[i].program, &error))
            fail_msg("%s", error.text);
        if (!known[i].program->count)
            skip(); /* a build without a C++ compiler counts nothing */
        GpShaderCounts vertex, pixel;
        known[i].program->count(known[i].program, &vertex, &pixel);
        assert_int_equal(pixel.slots, known[i].slots);
        assert_int_equal(pixel.dependent_reads, known[i].dependent);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_where_bits_are),
        cmocka_unit_test(densities_count_fragments),
        cmocka_unit_test(normals_point_outwards),
        cmocka_unit_test(colors_are_those_of_the_place),
        cmocka_unit_test(all_devices_make_the_same_bits),
        cmocka_unit_test(shaders_are_within_their_profiles),
    };
    return cmocka_run_group_tests_name("voxel values", tests, NULL, NULL);
}
