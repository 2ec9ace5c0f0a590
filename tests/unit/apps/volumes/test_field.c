/* Whatever a volume's samples are, a field has bytes of them, and says what they stand for. */
#include "apps/volumes/builtin.h"
#include "tests/support/folder.h"

#include <math.h>

static GpError error;

/* owns: the caller, until gp_volume_free */
static GpVolume volume_of(GpVolumeType type, const void *data)
{
    GpVolume volume = { .dims = { 2, 2, 1 }, .type = type, .spacing = { 1, 1, 1 } };
    volume.data = gp_alloc_unset(gp_volume_bytes(&volume));
    assert_non_null(volume.data);
    memcpy(volume.data, data, gp_volume_bytes(&volume));
    return volume;
}

/* --- samples ---------------------------------------------------------------------------------- */

static void bytes_stay_and_all_else_goes_from_the_least_to_the_greatest(void **state)
{
    (void)state;
    int16_t numbers[] = { -100, 155, 0, 27 };
    uint16_t words[] = { 1000, 65535, 1000, 33268 };
    float floats[] = { 1, __builtin_nanf(""), 3, 2 }, flat[] = { 7, 7, 7, 7 };
    float nothing[] = { __builtin_nanf(""), __builtin_inff(), -__builtin_inff(), 0 };
    uint8_t bits[] = { 0x06 }, bytes[] = { 3, 7, 200, 9 };
    const struct {
        GpVolumeType type;
        void *data;
        uint8_t expected[4];
        double least, most;
    } cases[] = {
        { GP_VOLUME_U8, bytes, { 3, 7, 200, 9 }, 0, 255 },
        { GP_VOLUME_I16, numbers, { 0, 255, 100, 127 }, -100, 155 },
        { GP_VOLUME_U16, words, { 0, 255, 0, 128 }, 1000, 65535 },
        { GP_VOLUME_F32, floats, { 0, 0, 255, 128 }, 1, 3 },
        { GP_VOLUME_F32, flat, { 0, 0, 0, 0 }, 7, 7 },
        { GP_VOLUME_F32, nothing, { 0, 0, 0, 0 }, 0, 0 },
        { GP_VOLUME_BITS, bits, { 0, 255, 255, 0 }, 0, 1 },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        Field field;
        GpVolume volume = volume_of(cases[i].type, cases[i].data);
        assert_int_equal(field_make(&volume, &field, &error), GP_OK);
        assert_true((volume.data == NULL) == (cases[i].type == GP_VOLUME_U8));
        assert_memory_equal(field.value, cases[i].expected, 4);
        if (field.least != cases[i].least || field.most != cases[i].most)
            fail_msg("case %zu: %g to %g", i, field.least, field.most);
        field_free(&field);
        gp_volume_free(&volume);
    }
}

static void the_closest_samples_are_one_apart(void **state)
{
    (void)state;
    uint8_t bytes[4] = { 0 };
    GpVolume volume = volume_of(GP_VOLUME_U8, bytes);
    volume.spacing[0] = 3.2;
    volume.spacing[1] = 1.6;
    volume.spacing[2] = 0.8;
    Field field;
    assert_int_equal(field_make(&volume, &field, &error), GP_OK);
    assert_true(field.scale[0] == 4 && field.scale[1] == 2 && field.scale[2] == 1);
    assert_int_equal(field_samples(&field), 4);
    field_free(&field);
    gp_volume_free(&volume);
}

static void what_is_too_large_or_too_uneven_is_refused(void **state)
{
    (void)state;
    Field field = { .least = 5 };
    GpVolume volume = { .dims = { 1025, 1, 1 }, .type = GP_VOLUME_U8, .spacing = { 1, 1, 1 } };
    assert_int_equal(field_make(&volume, &field, &error), GP_ERROR_UNSUPPORTED);
    assert_string_equal(error.text, "1025 x 1 x 1 samples, expected at most 1024 a side");
    volume.dims[0] = 1;
    volume.spacing[1] = 1e300;
    assert_int_equal(field_make(&volume, &field, &error), GP_ERROR_UNSUPPORTED);
    assert_non_null(strstr(error.text, "expected none to be 1000 times another"));
    assert_true(field.least == 5);
}

/* --- by name ---------------------------------------------------------------------------------- */

static void files_are_opened_and_their_errors_name_them(void **state)
{
    (void)state;
    Field field;
    put_text("a.json", "{ \"dims\": [2, 1, 2], \"type\": \"uint8\", \"spacing\": [1, 1, 2] }");
    assert_int_equal(field_open(put_file("a.raw", "\1\2\3\4", 4), &field, &error), GP_OK);
    assert_true(field.size[0] == 2 && field.size[1] == 1 && field.size[2] == 2);
    assert_true(field.scale[2] == 2 && field.value[3] == 4);
    field_free(&field);
    assert_int_equal(field_open(put_file("a.raw", "\1\2\3", 3), &field, &error), GP_ERROR_FORMAT);
    assert_int_equal(field_open("nowhere/x.nrrd", &field, &error), GP_ERROR_IO);
    char *zeros = calloc(1025, 1);
    put_text("b.json", "{ \"dims\": [1025, 1, 1], \"type\": \"uint8\" }");
    assert_int_equal(field_open(put_file("b.raw", zeros, 1025), &field, &error),
                     GP_ERROR_UNSUPPORTED);
    assert_non_null(strstr(error.text, "b.raw: 1025 x 1 x 1 samples"));
    free(zeros);
}

static uint8_t at(const Field *field, uint32_t x, uint32_t y, uint32_t z)
{
    return field->value[((size_t)z * field->size[1] + y) * field->size[0] + x];
}

static void the_marschner_lobb_signal_has_its_values(void **state)
{
    (void)state;
    Field field;
    assert_int_equal(field_open("builtin:marschner-lobb:41", &field, &error), GP_OK);
    for (uint32_t z = 0; z < 41; z += 5) {
        for (uint32_t y = 0; y < 41; y += 3) {
            for (uint32_t x = 0; x < 41; x++) {
                const double r = hypot(x / 20.0 - 1, y / 20.0 - 1);
                const double wave = 1 + cos(2 * M_PI * 6 * cos(M_PI / 2 * r));
                const double value = (1 - sin(M_PI / 2 * (z / 20.0 - 1)) + 0.25 * wave) / 2.5;
                assert_true(fabs(at(&field, x, y, z) - 255 * value) < 0.500001);
            }
        }
    }
    field_free(&field);
}

static void the_checkerboard_and_the_ball_are_as_they_are_described(void **state)
{
    (void)state;
    Field field;
    assert_int_equal(field_open("builtin:checkerboard", &field, &error), GP_OK);
    assert_true(field.size[0] == 512 && field.size[1] == 512 && field.size[2] == 3);
    for (uint32_t z = 0; z < 3; z++) {
        assert_int_equal(at(&field, 15, 15, z), 85);
        assert_int_equal(at(&field, 16, 15, z), 170);
        assert_int_equal(at(&field, 15, 16, z), 170);
        assert_int_equal(at(&field, 511, 511, z), 85);
    }
    field_free(&field);
    assert_int_equal(field_open("builtin:ball:101", &field, &error), GP_OK);
    const uint8_t along[] = { 255, 255, 191, 128, 64, 0, 0 }; /* from 37 to 43 of the centre */
    for (uint32_t i = 0; i < GP_COUNT(along); i++)
        assert_int_equal(at(&field, 87 + i, 50, 50), along[i]);
    assert_int_equal(at(&field, 50, 10, 50), 128);
    field_free(&field);
    for (int i = 0; builtin_field_names[i]; i++) { /* one sample is a volume too */
        char name[60];
        snprintf(name, sizeof name, "builtin:%s:1", builtin_field_names[i]);
        assert_int_equal(field_open(name, &field, &error), GP_OK);
        assert_int_equal(field.size[0], 1);
        field_free(&field);
    }
}

static void no_other_builtin_is_known(void **state)
{
    (void)state;
    static const char *const names[] = { "builtin:",
                                         "builtin:cup",
                                         "builtin:bal",
                                         "builtin:balls",
                                         "builtin:ball:",
                                         "builtin:ball:0",
                                         "builtin:ball:1025",
                                         "builtin:ball:-1",
                                         "builtin:ball:9x",
                                         "builtin:ball:1:1",
                                         "builtin:ball:99999999999999999999" };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        Field field;
        if (field_open(names[i], &field, &error) != GP_ERROR_INVALID)
            fail_msg("%s", names[i]);
        assert_non_null(strstr(error.text, "expected"));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_stay_and_all_else_goes_from_the_least_to_the_greatest),
        cmocka_unit_test(the_closest_samples_are_one_apart),
        cmocka_unit_test(what_is_too_large_or_too_uneven_is_refused),
        cmocka_unit_test_setup_teardown(files_are_opened_and_their_errors_name_them, folder_set_up,
                                        folder_tear_down),
        cmocka_unit_test(the_marschner_lobb_signal_has_its_values),
        cmocka_unit_test(the_checkerboard_and_the_ball_are_as_they_are_described),
        cmocka_unit_test(no_other_builtin_is_known),
    };
    return cmocka_run_group_tests_name("field", tests, NULL, NULL);
}
