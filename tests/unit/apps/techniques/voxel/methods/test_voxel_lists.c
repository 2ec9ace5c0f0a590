/* How far triangles reach, by the mathematics library's functions; on the borders of voxels and far
 * from any volume. */
#include "apps/techniques/voxel/methods/lists.h"
#include "tests/support/unit.h"

#include <math.h>
#include <string.h>

enum { TRIANGLES = 20000 };

static uint32_t random_bits(uint32_t *state)
{
    return *state = *state * 1664525 + 1013904223;
}

/* Triangles of many sizes about quarters of voxels, often with corners at the same place; one of 16
 * up to 2^60 off. */
static void make_positions(float *positions, uint32_t *indices)
{
    static const float parts[] = { 1, 16, 256, 4096, 4112, 1e6f }; /* of a voxel */
    uint32_t state = 7;
    for (uint32_t i = 0; i < 3 * TRIANGLES; i++) {
        const uint32_t triangle = i / 3, axis = i % 3;
        const float part = parts[triangle % GP_COUNT(parts)];
        const float far = triangle % 16 ? 1 : ldexpf(1, (int)(random_bits(&state) >> 26) - 3);
        const float about = (float)((int32_t)(random_bits(&state) >> 22) - 512) / 4 * far;
        for (uint32_t corner = 0; corner < 3; corner++) {
            const float step = (float)((int32_t)(random_bits(&state) >> 20) - 2048) / part;
            const float steps = (float)(random_bits(&state) >> 31);
            positions[9 * triangle + 3 * corner + axis] = about + steps * step;
        }
        indices[i] = i;
    }
}

static const double rounding = 1.0 / 256;

static bool is_in_one(double low, double high)
{
    return floor(low - rounding) == floor(high + rounding);
}

static bool has_centre(double low, double high)
{
    return floor(high + rounding - 0.5) >= ceil(low - rounding - 0.5);
}

static void extents_are_those_of_the_library(void **state)
{
    (void)state;
    static float positions[9 * TRIANGLES];
    static uint32_t indices[3 * TRIANGLES];
    make_positions(positions, indices);
    const VoxelModel model = { .positions = positions,
                               .indices = indices,
                               .vertex_count = 3 * TRIANGLES,
                               .triangle_count = TRIANGLES,
                               .motion.to_voxels = { { 1 }, { 0, 1 }, { 0, 0, 1 } } };
    Frame frame = { .color = NULL };
    const VoxelExtent *extents = voxel_extents(&model, &frame);
    uint32_t far = 0, kinds[2][2] = { { 0 } };
    assert_non_null(extents);
    for (uint32_t i = 0; i < TRIANGLES; i++) {
        double low[3], high[3];
        bool is_far = false;
        for (uint32_t k = 0; k < 3; k++) {
            const float *p = positions + 9 * i + k;
            low[k] = fmin((double)p[0], fmin((double)p[3], (double)p[6]));
            high[k] = fmax((double)p[0], fmax((double)p[3], (double)p[6]));
            is_far = is_far || low[k] < -1e9 || high[k] > 1e9;
        }
        far += is_far;
        if (is_far)
            continue;
        const VoxelExtent *e = &extents[i];
        assert_true(e->low == (float)low[2] - (float)rounding);
        assert_true(e->high == (float)high[2] + (float)rounding);
        assert_true(e->side == (float)fmax(high[0] - low[0], high[1] - low[1]));
        assert_int_equal(e->in_column, is_in_one(low[0], high[0]) && is_in_one(low[1], high[1]));
        assert_int_equal(e->meets_lines, has_centre(low[0], high[0]) + has_centre(low[1], high[1]) +
                                                 has_centre(low[2], high[2]) >=
                                             2);
        kinds[e->in_column][e->meets_lines]++;
    }
    assert_true(far > 100 && far < TRIANGLES / 8);
    for (int i = 0; i < 4; i++)
        assert_true(kinds[i / 2][i % 2] > 10);
    frame_free(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(extents_are_those_of_the_library),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
