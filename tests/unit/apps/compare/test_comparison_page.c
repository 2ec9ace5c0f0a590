/* The page of a comparison: well formed, by itself, and with every view. */
#include "apps/compare/comparison_page.h"
#include "apps/compare/comparison_views.h"
#include "tests/support/groups/pool.h"
#include "tests/support/markup.h"
#include "tests/support/unit.h"

#include <math.h>

static const char *const names[2] = { "a<b>.png", "\"c\" & d.png" };

static GpImage make_image(uint32_t width, uint32_t height, uint32_t channels, float value)
{
    const size_t count = (size_t)width * height * channels;
    float *samples = gp_alloc(count, sizeof(float));
    assert_non_null(samples);
    for (size_t i = 0; i < count; i++)
        samples[i] = value;
    return (GpImage){ width, height, channels, GP_IMAGE_F32, samples };
}

/* The page of these two, which are freed. */
static Text make_page(GpImage a, GpImage b)
{
    GpImage images[2] = { a, b };
    Picture pictures[2];
    Comparison comparison;
    Text page = { .data = NULL };
    assert_int_equal(
        comparison_make(images, true, &comparison_defaults, pool, pictures, &comparison, NULL),
        GP_OK);
    gp_image_free(&images[0]);
    gp_image_free(&images[1]);
    assert_int_equal(
        comparison_page(names, pictures, &comparison, &comparison_defaults, &page, NULL), GP_OK);
    comparison_free(&comparison);
    picture_free(&pictures[0]);
    picture_free(&pictures[1]);
    return page;
}

static void expect_page(Text page, int pictures, const char *part)
{
    markup_check(page.data);
    assert_int_equal(markup_count(page.data, "src=\"data:image/png;base64,"), pictures);
    assert_int_equal(markup_count(page.data, "src="), pictures);
    assert_int_equal(markup_count(page.data, "http"), 0);
    assert_int_equal(markup_count(page.data, "href"), 0);
    assert_int_equal(markup_count(page.data, "url("), 0);
    assert_true(markup_count(page.data, "a&lt;b&gt;.png") >= 2);
    if (!strstr(page.data, part))
        fail_msg("no '%s' in:\n%s", part, page.data);
    text_free(&page);
}

static void a_page_has_every_view_and_the_worst_tile_and_nothing_from_elsewhere(void **state)
{
    (void)state;
    GpImage b = make_image(100, 70, 3, 0.25f);
    ((float *)b.data)[3 * (66 * 100 + 90)] = 1;
    expect_page(make_page(make_image(100, 70, 3, 0.25f), b), 8,
                "the one at (64, 64) has the largest sum of squared differences; 1 of its pixels");
}

static void equal_pictures_have_no_worst_tile_and_other_sizes_no_slider(void **state)
{
    (void)state;
    expect_page(make_page(make_image(5, 4, 2, 0.5f), make_image(5, 4, 3, 0.5f)), 4,
                "good\">same bits in all 5x4 pixels; only the first has alpha");
    expect_page(make_page(make_image(5, 4, 3, 0), make_image(4, 5, 3, 0)), 2,
                "bad\">different sizes: 5x4 and 4x5<");
}

static void differences_are_scaled_and_those_of_alpha_are_grey(void **state)
{
    (void)state;
    float a[] = { 0, 0, 0, 1, 0.5f, 0, 0, 0.5f }, b[] = { 0, 0.25f, 0, 1, 0.5f, 0, 0, 0.75f };
    const Picture pictures[2] = { { 2, 1, 4, a }, { 2, 1, 4, b } };
    static const float expected[] = { 0, 1, 0, 1, 1, 1 };
    Picture view;
    double scale;
    assert_int_equal(view_difference(pictures, 0.25, &view, &scale, NULL), GP_OK);
    assert_true(scale == 4);
    assert_memory_equal(view.values, expected, sizeof expected);
    picture_free(&view);
    assert_int_equal(view_difference(pictures, HUGE_VAL, &view, &scale, NULL), GP_OK);
    assert_true(scale == 0 && view.values[1] == 0.25f);
    picture_free(&view);
}

static void a_part_ends_where_the_picture_does(void **state)
{
    (void)state;
    float values[12];
    for (int i = 0; i < 12; i++)
        values[i] = (float)i;
    const Picture picture = { 4, 3, 1, values };
    static const float expected[] = { 6, 7, 10, 11 };
    Picture part;
    assert_int_equal(view_part(&picture, 2, 1, 64, &part, NULL), GP_OK);
    assert_true(part.width == 2 && part.height == 2);
    assert_memory_equal(part.values, expected, sizeof expected);
    picture_free(&part);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_page_has_every_view_and_the_worst_tile_and_nothing_from_elsewhere),
        cmocka_unit_test(equal_pictures_have_no_worst_tile_and_other_sizes_no_slider),
        cmocka_unit_test(differences_are_scaled_and_those_of_alpha_are_grey),
        cmocka_unit_test(a_part_ends_where_the_picture_does),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
