/* Voxels in 8 bytes: what they say, in which order they stand, and what a transfer function
 * shows. */
#include "apps/volumes/voxels.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

static GpError error;

static Field random_field(const uint32_t size[3], uint64_t seed)
{
    Field field = { .size = { size[0], size[1], size[2] }, .scale = { 1, 1, 2 }, .most = 255 };
    Random random = { seed };
    field.value = gp_alloc(field_samples(&field), 1);
    assert_non_null(field.value);
    for (size_t i = 0; i < field_samples(&field); i++) /* most of them 0 */
        field.value[i] = random_word(&random) % 3 ? 0 : (uint8_t)random_word(&random);
    return field;
}

static size_t sample_of(const Field *field, const Voxel *voxel)
{
    const size_t x = voxel->place[0] + 256u * (voxel->place[3] / 32);
    const size_t y = voxel->place[1] + 256u * (voxel->place[3] / 4 % 8);
    const size_t z = voxel->place[2] + 256u * (voxel->place[3] % 4);
    assert_true(x < field->size[0] && y < field->size[1] && z < field->size[2]);
    return (z * field->size[1] + y) * field->size[0] + x;
}

static void every_sample_but_the_background_is_there_once_in_each_order(void **state)
{
    (void)state;
    static const uint32_t sizes[][3] = {
        { 7, 5, 3 }, { 300, 2, 3 }, { 2, 270, 65 }, { 1, 1, 1024 }
    };
    static const bool none[FIELD_VALUES] = { false };
    for (size_t s = 0; s < GP_COUNT(sizes); s++) {
        Field field = random_field(sizes[s], s);
        Voxels voxels;
        assert_int_equal(voxels_make(&field, none, &voxels, &error), GP_OK);
        assert_int_equal(voxels.background, 0);
        for (uint32_t axis = 0; axis < 3; axis++) {
            const VoxelOrder *order = &voxels.along[axis];
            uint8_t *seen = gp_alloc(field_samples(&field), 1);
            const size_t lists =
                (size_t)order->slices * order->patches[0] * order->patches[1] * FIELD_VALUES;
            for (size_t list = 0; list < lists; list++)
                for (uint32_t i = order->first[list]; i < order->first[list + 1]; i++) {
                    const size_t sample = sample_of(&field, &order->voxels[i]);
                    assert_int_equal(seen[sample]++, 0);
                    assert_int_equal(order->voxels[i].value, field.value[sample]);
                    assert_int_equal(order->voxels[i].value, list % FIELD_VALUES);
                }
            for (size_t i = 0; i < field_samples(&field); i++)
                assert_int_equal(seen[i], field.value[i] != 0);
            gp_free(seen);
        }
        voxels_free(&voxels);
        field_free(&field);
    }
}

static void a_gradient_points_to_where_values_rise_in_space(void **state)
{
    (void)state;
    const uint32_t size[3] = { 4, 4, 4 };
    Field field = random_field(size, 1);
    for (int i = 0; i < 64;
         i++) /* 20 a sample along z, whose samples are 2 apart: 10; 10 along x */
        field.value[i] = (uint8_t)(20 * (i / 16) + 10 * (i % 4));
    uint8_t attributes[64][4];
    voxels_attributes(&field, attributes[0]);
    for (int i = 0; i < 64; i++) {
        assert_int_equal(attributes[i][0], field.value[i]);
        assert_int_equal(attributes[i][1], 218); /* 128 + 127 / sqrt 2 */
        assert_int_equal(attributes[i][2], 128);
        assert_int_equal(attributes[i][3], 218);
    }
    field_free(&field);
}

/* What runs hold is what the function shows, whatever was shown before. */
static void a_transfer_function_gathers_what_it_shows(void **state)
{
    (void)state;
    const uint32_t size[3] = { 70, 9, 66 };
    Field field = random_field(size, 2);
    bool shown[FIELD_VALUES] = { false };
    Voxels voxels;
    assert_int_equal(voxels_make(&field, shown, &voxels, &error), GP_OK);
    size_t expected = 0;
    for (int v = 1; v < FIELD_VALUES; v++)
        shown[v] = v % 50 < 20;
    for (size_t i = 0; i < field_samples(&field); i++)
        expected += shown[field.value[i]];
    for (uint32_t axis = 0; axis < 3; axis++) {
        const VoxelOrder *order = &voxels.along[axis];
        VoxelRun *runs;
        uint32_t *run_of;
        size_t found = 0;
        assert_int_equal(voxels_gather(order, shown, &runs, &run_of, &error), GP_OK);
        for (uint32_t slice = 0; slice < order->slices; slice++)
            for (uint32_t r = run_of[slice]; r < run_of[slice + 1]; r++)
                for (uint32_t i = 0; i < runs[r].count; i++, found++) {
                    const Voxel *voxel = &order->voxels[runs[r].first + i];
                    assert_true(shown[voxel->value]);
                    assert_int_equal(voxel->place[axis], slice);
                }
        assert_int_equal(found, expected);
        gp_free(runs);
        gp_free(run_of);
    }
    voxels_free(&voxels);
    field_free(&field);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_sample_but_the_background_is_there_once_in_each_order),
        cmocka_unit_test(a_gradient_points_to_where_values_rise_in_space),
        cmocka_unit_test(a_transfer_function_gathers_what_it_shows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
