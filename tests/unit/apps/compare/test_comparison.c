/* Pictures as their files hold them: what is the same is told from samples as from floats. */
#include "apps/compare/comparison.h"
#include "tests/support/groups/pool.h"
#include "tests/support/unit.h"

#include <math.h>

/* Samples of any bits: infinite and not numbers too, where the type has them. */
static GpImage make_image(uint32_t side, uint32_t channels, GpImageType type)
{
    GpImage image = { side, side, channels, type, NULL };
    const size_t bytes = (size_t)side * side * channels * gp_image_sample_size(type);
    uint8_t *data = image.data = gp_alloc(bytes, 1);
    uint32_t random = 1;
    assert_non_null(data);
    for (size_t i = 0; i < bytes; i++)
        data[i] = (uint8_t)((random = random * 1664525 + 1013904223) >> 24);
    return image;
}

static Comparison compare(const GpImage images[2], bool views, Picture pictures[2])
{
    Comparison made;
    assert_int_equal(
        comparison_make(images, views, &comparison_defaults, pool, pictures, &made, NULL), GP_OK);
    return made;
}

static void expect_nothing_differs(const Comparison *made, uint32_t side)
{
    const CompareReport *report = &made->report;
    assert_true(report->same && !report->failed && !report->warned);
    assert_true(!made->failed && !made->warned && !made->other_sizes && !made->flip_map);
    assert_true(report->pixels == (uint64_t)side * side);
    assert_true(report->differing + report->failing + report->warning + report->tile_differing ==
                0);
    assert_true(report->max == 0 && report->mean == 0 && report->rmse == 0);
    assert_true(isinf(report->psnr) && (side < 11 ? isnan(report->ssim) : report->ssim == 1));
}

static void the_same_samples_are_told_without_floats_as_with_them(void **state)
{
    (void)state;
    for (int type = 0; type < GP_IMAGE_TYPES; type++)
        for (uint32_t channels = 1; channels <= 4; channels++)
            for (uint32_t side = 10; side <= 12; side++) {
                const GpImage image = make_image(side, channels, (GpImageType)type);
                const GpImage pair[2] = { image, image };
                Picture pictures[2];
                Comparison made = compare(pair, false, pictures);
                expect_nothing_differs(&made, side);
                assert_int_equal(made.alpha, channels % 2 ? ALPHA_NONE : ALPHA_COMPARED);
                assert_true(!pictures[0].values && !pictures[1].values);
                made = compare(pair, true, pictures);
                expect_nothing_differs(&made, side);
                for (int i = 0; i < 2; i++) {
                    assert_int_equal(pictures[i].channels, channels);
                    assert_non_null(pictures[i].values);
                    picture_free(&pictures[i]);
                }
                gp_free(image.data);
            }
}

/* 0 and 1 as bytes and as floats. */
static void the_same_values_of_other_types_are_found_by_floats(void **state)
{
    (void)state;
    uint8_t bytes[12 * 12];
    float floats[12 * 12];
    for (int i = 0; i < 12 * 12; i++)
        floats[i] = (bytes[i] = i % 5 ? 255 : 0) ? 1 : 0;
    const GpImage pair[2] = { { 12, 12, 1, GP_IMAGE_U8, bytes },
                              { 12, 12, 1, GP_IMAGE_F32, floats } };
    Picture pictures[2];
    Comparison made = compare(pair, false, pictures);
    expect_nothing_differs(&made, 12);
    picture_free(&pictures[0]);
    picture_free(&pictures[1]);
}

static void one_sample_of_any_type_is_found(void **state)
{
    (void)state;
    for (int type = 0; type < GP_IMAGE_TYPES; type++) {
        GpImage pair[2] = { make_image(12, 3, (GpImageType)type),
                            make_image(12, 3, (GpImageType)type) };
        uint8_t *last = (uint8_t *)pair[1].data + 12 * 12 * 3 * gp_image_sample_size(pair[1].type);
        last[-1] ^= 4;
        Picture pictures[2];
        Comparison made = compare(pair, false, pictures);
        assert_true(!made.report.same && made.failed && made.report.differing == 1);
        assert_true(made.report.first_x == 11 && made.report.first_y == 11);
        comparison_free(&made);
        for (int i = 0; i < 2; i++) {
            picture_free(&pictures[i]);
            gp_image_free(&pair[i]);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_samples_are_told_without_floats_as_with_them),
        cmocka_unit_test(the_same_values_of_other_types_are_found_by_floats),
        cmocka_unit_test(one_sample_of_any_type_is_found),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
