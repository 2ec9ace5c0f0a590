/* Surfaces: sizes, limits, windows, memory of the caller's, reading. */
#include <sys/resource.h>

#include "tests/support/surfaces/texels.h"

/* --- life ------------------------------------------------------------------------------------- */

static void create_makes_zeroed_levels_of_every_format(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, 13, 6, GP_MAX_LEVELS);
        static const uint32_t sizes[][2] = { { 13, 6 }, { 6, 3 }, { 3, 1 }, { 1, 1 } };
        assert_int_equal(s->levels, GP_COUNT(sizes));
        for (uint32_t i = 0; i < s->levels; i++) {
            const GpLevel *level = &s->level[i];
            assert_int_equal(level->width, sizes[i][0]);
            assert_int_equal(level->height, sizes[i][1]);
            assert_int_equal(level->pitch, level->width * gp_format_info(format)->bytes);
            for (size_t b = 0; b < level->pitch * level->height; b++)
                assert_int_equal(level->texels[b], 0);
        }
        gp_surface_destroy(&s);
    }
}

static void create_levels_zero_means_one_and_many_means_all(void **state)
{
    (void)state;
    static const uint32_t cases[][4] = {
        /* width height levels -> levels */
        { 8192, 1, GP_MAX_LEVELS, 14 },
        { 1, 8192, 1000, 14 },
        { 4, 4, 0, 1 },
        { 4, 4, 1, 1 },
        { 4, 4, 3, 3 },
        { 4, 4, 14, 3 },
        { 1, 1, 14, 1 },
        { 5, 3, 2, 2 },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        GpSurface *s = make(GP_R8, cases[i][0], cases[i][1], cases[i][2]);
        assert_int_equal(s->levels, cases[i][3]);
        gp_surface_destroy(&s);
    }
}

static void create_refuses_what_no_device_has(void **state)
{
    (void)state;
    static const GpSurfaceDesc bad[] = {
        { .format = GP_FORMAT_NONE, .width = 4, .height = 4 },
        { .format = GP_FORMATS, .width = 4, .height = 4 },
        { .format = (GpFormat)99, .width = 4, .height = 4 },
        { .format = GP_R8, .width = 0, .height = 4 },
        { .format = GP_R8, .width = 4, .height = 0 },
        { .format = GP_R8, .width = GP_MAX_SIZE + 1, .height = 4 },
        { .format = GP_R8, .width = 4, .height = GP_MAX_SIZE + 1 },
        { .format = GP_R8, .width = 0xffffffffu, .height = 0xffffffffu },
        { .format = GP_R8, .width = 4, .height = 4, .levels = 4 },
        { .format = GP_R8, .width = 4095, .height = 1, .levels = 13 },
    };
    for (size_t i = 0; i < GP_COUNT(bad); i++) {
        GpSurface untouched, *surface = &untouched;
        GpError error = { .text = "" };
        assert_int_equal(gp_surface_create(&bad[i], &surface, &error), GP_ERROR_INVALID);
        assert_ptr_equal(surface, &untouched);
        assert_int_not_equal(error.text[0], '\0');
        assert_int_equal(gp_surface_create(&bad[i], &surface, NULL), GP_ERROR_INVALID);
    }
}

static void create_reports_missing_memory_and_leaks_nothing(void **state)
{
    (void)state;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    skip(); /* sanitizers reserve more address space than any limit that bites */
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    skip();
#endif
#endif
    struct rlimit before;
    assert_int_equal(getrlimit(RLIMIT_AS, &before), 0);
    struct rlimit small = { .rlim_cur = 512u << 20, .rlim_max = before.rlim_max };
    GpSurface untouched, *surface = &untouched;
    GpSurfaceDesc desc = {
        .format = GP_A32B32G32R32F, .width = 8192, .height = 8192, .levels = 14
    };
    GpError error = { .text = "" };
    assert_int_equal(setrlimit(RLIMIT_AS, &small), 0);
    GpResult result = gp_surface_create(&desc, &surface, &error);
    assert_int_equal(setrlimit(RLIMIT_AS, &before), 0);
    assert_int_equal(result, GP_ERROR_MEMORY);
    assert_ptr_equal(surface, &untouched);
    assert_int_not_equal(error.text[0], '\0');
}

/* Windows of a picture of 512 x 300, and of one that is larger than a surface may be. */
static void create_refuses_windows_that_are_no_part(void **state)
{
    (void)state;
    static uint8_t memory[4];
    static const struct {
        GpRect window;
        const char *says; /* NULL: there is such a window */
        uint32_t width, levels;
        void *memory;
    } rows[] = {
        { { 128, 128, 256, 256 }, NULL, 512, 0, NULL },
        { { 384, 256, 512, 300 }, NULL, 512, 1, NULL },
        { { 0, 128, 128, 300 }, NULL, 512, 1, NULL },
        { { 0, 0, 128, 300 }, NULL, 512, 1, NULL },
        { { 0, 0, 0, 128 }, "is not inside", 512, 1, NULL },
        { { 0, 0, 128, 0 }, "is not inside", 512, 1, NULL },
        { { 0, 128, 0, 0 }, "is not inside", 512, 1, NULL },
        { { 128, 0, 0, 0 }, "is not inside", 512, 1, NULL },
        { { 0, 0, 128, 128 }, "a window has one level, of its own", 512, 2, NULL },
        { { 0, 0, 128, 128 }, "a window has one level, of its own", 512, 1, memory },
        { { -128, 0, 128, 128 }, "[-128, 128) x [0, 128) is not inside 512x300", 512, 1, NULL },
        { { 0, -128, 128, 128 }, "is not inside", 512, 1, NULL },
        { { 128, 0, 128, 128 }, "is not inside", 512, 1, NULL },
        { { 0, 128, 128, 128 }, "is not inside", 512, 1, NULL },
        { { 0, 0, 640, 128 }, "is not inside", 512, 1, NULL },
        { { 0, 0, 128, 384 }, "is not inside", 512, 1, NULL },
        { { 64, 0, 128, 128 }, "is not at multiples of 128", 512, 1, NULL },
        { { 0, 64, 128, 128 }, "is not at multiples of 128", 512, 1, NULL },
        { { 0, 0, 100, 128 }, "is not at multiples of 128", 512, 1, NULL },
        { { 0, 0, 128, 299 }, "is not at multiples of 128", 512, 1, NULL },
        { { 0, 0, 128, 128 }, NULL, GP_MAX_WHOLE, 1, NULL },
        { { 0, 0, 128, 128 }, "is not within 1..32768", GP_MAX_WHOLE + 1, 1, NULL },
        { { 0, 0, GP_MAX_SIZE + 128, 128 },
          "window 8320x128 is not within",
          GP_MAX_WHOLE,
          1,
          NULL },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const GpSurfaceDesc desc = { .format = GP_R8,
                                     .width = rows[i].width,
                                     .height = 300,
                                     .levels = rows[i].levels,
                                     .memory = rows[i].memory,
                                     .window = rows[i].window };
        GpSurface *s = NULL;
        GpError error = { "" };
        const GpResult result = gp_surface_create(&desc, &s, &error);
        if (result != (rows[i].says ? GP_ERROR_INVALID : GP_OK) ||
            (rows[i].says && !strstr(error.text, rows[i].says)))
            fail_msg("row %zu: '%s'", i, error.text);
        assert_true((s == NULL) == (result != GP_OK));
        gp_surface_destroy(&s);
    }
    const GpSurfaceDesc high = {
        .format = GP_R8, .width = 300, .height = 16384, .window = { 0, 0, 128, 8320 }
    };
    GpSurface *s = NULL;
    assert_int_equal(gp_surface_create(&high, &s, NULL), GP_ERROR_INVALID);
}

static void windows_become_whole_unless_that_is_too_large(void **state)
{
    (void)state;
    GpSurfaceDesc desc = {
        .format = GP_R8, .width = 300, .height = 200, .window = { 128, 0, 256, 128 }
    };
    GpSurface *s = NULL;
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    *texel_at(s, 0, 255, 127) = 7;
    for (int turn = 0; turn < 2; turn++) { /* the second changes nothing */
        assert_int_equal(gp_surface_make_whole(s, NULL), GP_OK);
        assert_true(gp_surface_is_whole(s));
        assert_int_equal(*texel_at(s, 0, 299, 199), turn ? 9 : 0);
        assert_int_equal(*texel_at(s, 0, 255, 127), 0);
        *texel_at(s, 0, 299, 199) = 9;
    }
    gp_surface_destroy(&s);
    desc.width = GP_MAX_WHOLE;
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    *texel_at(s, 0, 255, 127) = 7;
    GpError error;
    assert_int_equal(gp_surface_make_whole(s, &error), GP_ERROR_INVALID);
    assert_false(gp_surface_is_whole(s));
    assert_int_equal(*texel_at(s, 0, 255, 127), 7);
    gp_surface_destroy(&s);
}

/* One side of a rectangle is another: they differ; two that meet at one corner have nothing in
 * common. */
static void rectangles_are_equal_side_by_side(void **state)
{
    (void)state;
    const GpRect all = { 1, 2, 3, 4 },
                 others[] = { { 0, 2, 3, 4 }, { 1, 0, 3, 4 }, { 1, 2, 0, 4 }, { 1, 2, 3, 0 } };
    assert_true(gp_rect_equal(all, all));
    for (size_t i = 0; i < GP_COUNT(others); i++)
        assert_false(gp_rect_equal(all, others[i]));
    assert_false(gp_rect_is_empty(all));
    assert_true(gp_rect_is_empty((GpRect){ 3, 2, 3, 4 }));
    assert_true(gp_rect_is_empty((GpRect){ 1, 4, 3, 4 }));
    assert_true(gp_rect_is_empty(gp_rect_common(all, (GpRect){ 3, 4, 9, 9 })));
}

static void names_are_copied_and_cut(void **state)
{
    (void)state;
    char name[64] = "a name that is longer than the thirty-one characters kept";
    GpSurfaceDesc desc = { .format = GP_R8, .width = 1, .height = 1, .name = name };
    GpSurface *s = NULL;
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    name[0] = 'X';
    assert_string_equal(s->name, "a name that is longer than the ");
    gp_surface_destroy(&s);

    desc.name = NULL;
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    assert_string_equal(s->name, "");
    gp_surface_destroy(&s);
}

static void destroy_accepts_null_and_sets_null(void **state)
{
    (void)state;
    GpSurface *s = NULL;
    gp_surface_destroy(NULL);
    gp_surface_destroy(&s);
    s = make(GP_R8, 2, 2, 2);
    gp_surface_destroy(&s);
    assert_null(s);
}

/* --- memory of the caller's ------------------------------------------------------------------- */

static void borrowed_memory_is_kept_and_must_fit(void **state)
{
    (void)state;
    uint8_t memory[3 * 11 + 2];
    for (size_t i = 0; i < sizeof memory; i++)
        memory[i] = (uint8_t)i;
    GpSurfaceDesc desc = {
        .format = GP_A8R8G8B8, .width = 2, .height = 3, .memory = memory + 1, .pitch = 11
    };
    GpSurface *s = NULL;
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    assert_int_equal(s->level[0].pitch, 11);
    assert_ptr_equal(texel_at(s, 0, 1, 2), memory + 1 + 2 * 11 + 4);
    gp_surface_clear_color_rect(s, (GpRect){ 1, 2, 9, 9 }, (const float[4]){ 0 });
    gp_surface_destroy(&s);
    for (size_t i = 0; i < sizeof memory; i++)
        assert_int_equal(memory[i], i >= 27 && i < 31 ? 0 : i);

    static const struct {
        size_t pitch;
        uint32_t width, height, levels;
        bool no_memory;
    } bad[] = {
        { 7, 2, 3, 1, false },       { 11, 2, 3, 2, false },         { 8, 2, 3, 0, true },
        { 1 << 28, 2, 8, 1, false }, { (size_t)-1, 2, 1, 1, false },
    };
    for (size_t i = 0; i < GP_COUNT(bad); i++) {
        GpError error = { "" };
        desc = (GpSurfaceDesc){ .format = GP_A8R8G8B8,
                                .width = bad[i].width,
                                .height = bad[i].height,
                                .levels = bad[i].levels,
                                .memory = bad[i].no_memory ? NULL : memory,
                                .pitch = bad[i].pitch };
        assert_int_equal(gp_surface_create(&desc, &s, &error), GP_ERROR_INVALID);
        assert_int_not_equal(error.text[0], '\0');
    }
}

/* Every pair of windows in one memory, against a look at each byte. */
static void surfaces_share_where_a_texel_of_one_is_a_texel_of_the_other(void **state)
{
    (void)state;
    enum { BYTES = 60, WINDOWS = 8 };
    static const struct {
        size_t start, pitch;
        uint32_t width, height;
    } windows[WINDOWS] = { { 0, 10, 5, 6 },  { 5, 10, 5, 5 }, { 4, 10, 2, 3 }, { 30, 10, 4, 3 },
                           { 19, 10, 3, 2 }, { 8, 10, 4, 2 }, { 55, 5, 5, 1 }, { 29, 10, 1, 1 } };
    uint8_t memory[BYTES];
    GpSurface *s[WINDOWS];
    for (int i = 0; i < WINDOWS; i++)
        assert_int_equal(gp_surface_create(&(GpSurfaceDesc){ .format = GP_R8,
                                                             .width = windows[i].width,
                                                             .height = windows[i].height,
                                                             .memory = memory + windows[i].start,
                                                             .pitch = windows[i].pitch },
                                           &s[i], NULL),
                         GP_OK);
    for (int i = 0; i < WINDOWS; i++)
        for (int j = 0; j < WINDOWS; j++) {
            bool expected = false;
            memset(memory, 0, BYTES);
            gp_surface_clear_color(s[i], (const float[4]){ 1, 1, 1, 1 });
            for (uint32_t y = 0; y < s[j]->height; y++)
                for (uint32_t x = 0; x < s[j]->width; x++)
                    expected = expected || *texel_at(s[j], 0, x, y);
            if (gp_surfaces_share(s[i], s[j]) != expected)
                fail_msg("windows %d and %d", i, j);
        }
    GpSurface *own = make(GP_R8, 3, 3, 2);
    assert_false(gp_surfaces_share(own, s[0]));
    assert_false(gp_surfaces_share(own, NULL));
    gp_surface_destroy(&own);

    /* of a window there is less than its sides say, and that elsewhere */
    GpSurface *window = NULL;
    const GpSurfaceDesc desc = {
        .format = GP_A8R8G8B8, .width = 1024, .height = 1024, .window = { 896, 896, 1024, 1024 }
    };
    assert_int_equal(gp_surface_create(&desc, &window, NULL), GP_OK);
    const GpLevel *level = &window->level[0];
    for (int i = 0; i < 4; i++) {
        uint8_t *texels = i < 3 ? gp_surface_texel(level, 4, 896, 896) + i * 128 * 128 * 4 - 65536
                                : level->texels;
        GpSurface *beside = NULL;
        assert_int_equal(gp_surface_create(&(GpSurfaceDesc){ .format = GP_A8R8G8B8,
                                                             .width = 128,
                                                             .height = 128,
                                                             .memory = texels },
                                           &beside, NULL),
                         GP_OK);
        assert_int_equal(gp_surfaces_share(window, beside), i == 1);
        assert_int_equal(gp_surfaces_share(beside, window), i == 1);
        gp_surface_destroy(&beside);
    }
    gp_surface_destroy(&window);
    for (int i = 0; i < WINDOWS; i++)
        gp_surface_destroy(&s[i]);
}

/* --- reading ---------------------------------------------------------------------------------- */

static void reading_gives_texels_as_floats_and_as_they_are(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, 7, 5, 2);
        const size_t bytes = gp_format_info(format)->bytes;
        for (uint32_t l = 0; l < 2; l++)
            for (size_t i = 0; i < s->level[l].height * s->level[l].pitch; i++)
                s->level[l].texels[i] = (uint8_t)(i * 37 + 11 + l);
        const GpRect rect = { 2, 1, 5, 4 };
        float rgba[7 * 5 * 4], one[4];
        uint8_t raw[5 * 7 * 16 + 9 * 5];
        for (uint32_t l = 0; l < 2; l++)
            for (int part = 0; part < 2; part++) {
                if (l && part)
                    continue;
                const GpRect r = part ? rect : l ? (GpRect){ 0, 0, 3, 2 } : (GpRect){ 0, 0, 7, 5 };
                const uint32_t wide = (uint32_t)(r.x1 - r.x0), high = (uint32_t)(r.y1 - r.y0);
                const size_t pitch = part ? wide * bytes + 9 : 0;
                assert_int_equal(gp_surface_read_floats(s, l, part ? &rect : NULL, rgba, NULL), 0);
                assert_int_equal(gp_surface_read_bytes(s, l, part ? &rect : NULL, raw, pitch, NULL),
                                 0);
                for (uint32_t y = 0; y < high; y++)
                    for (uint32_t x = 0; x < wide; x++) {
                        const uint32_t at_x = (uint32_t)r.x0 + x, at_y = (uint32_t)r.y0 + y;
                        load(s, l, at_x, at_y, one);
                        assert_memory_equal(rgba + 4 * (y * wide + x), one, sizeof one);
                        assert_memory_equal(raw + y * (pitch ? pitch : wide * bytes) + x * bytes,
                                            texel_at(s, l, at_x, at_y), bytes);
                    }
            }
        gp_surface_destroy(&s);
    }
}

/* Of many texels codes are looked up: each of the 256 in each channel, where channels are bytes. */
static void many_texels_are_read_as_few_are(void **state)
{
    enum { WIDE = 37, HIGH = 31 };
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, WIDE, HIGH, 1);
        for (size_t i = 0; i < HIGH * s->level[0].pitch; i++)
            s->level[0].texels[i] = (uint8_t)(i * 37 + i / 251);
        static float rgba[WIDE * HIGH * 4];
        const GpRect inner = { 1, 2, WIDE - 1, HIGH };
        float one[4];
        assert_int_equal(gp_surface_read_floats(s, 0, &inner, rgba, NULL), GP_OK);
        for (uint32_t y = 2, i = 0; y < HIGH; y++)
            for (uint32_t x = 1; x < WIDE - 1; x++, i++) {
                load(s, 0, x, y, one);
                assert_memory_equal(rgba + (size_t)4 * i, one, sizeof one);
            }
        gp_surface_destroy(&s);
    }
}

static void reading_refuses_what_is_not_there(void **state)
{
    (void)state;
    static const GpRect bad[] = { { -1, 0, 2, 2 }, { 0, -1, 2, 2 }, { 0, 0, 5, 2 },
                                  { 0, 0, 2, 4 },  { 3, 0, 2, 1 },  { 0, 2, 2, 1 } };
    GpSurface *s = make(GP_R8, 4, 3, 1);
    uint8_t bytes[12];
    float rgba[48];
    GpError error = { "" };
    for (size_t i = 0; i < GP_COUNT(bad); i++) {
        assert_int_equal(gp_surface_read_bytes(s, 0, &bad[i], bytes, 0, &error), GP_ERROR_INVALID);
        assert_int_equal(gp_surface_read_floats(s, 0, &bad[i], rgba, &error), GP_ERROR_INVALID);
        assert_non_null(strstr(error.text, "'test'"));
    }
    assert_int_equal(gp_surface_read_floats(s, 1, NULL, rgba, &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, "surface 'test': level 1, but it has 1");
    assert_int_equal(gp_surface_read_bytes(s, 0, NULL, bytes, 3, &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, "surface 'test': pitch 3 is less than a row's 4 bytes");
    gp_surface_destroy(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(create_makes_zeroed_levels_of_every_format),
        cmocka_unit_test(create_levels_zero_means_one_and_many_means_all),
        cmocka_unit_test(create_refuses_what_no_device_has),
        cmocka_unit_test(create_reports_missing_memory_and_leaks_nothing),
        cmocka_unit_test(create_refuses_windows_that_are_no_part),
        cmocka_unit_test(windows_become_whole_unless_that_is_too_large),
        cmocka_unit_test(rectangles_are_equal_side_by_side),
        cmocka_unit_test(names_are_copied_and_cut),
        cmocka_unit_test(destroy_accepts_null_and_sets_null),
        cmocka_unit_test(borrowed_memory_is_kept_and_must_fit),
        cmocka_unit_test(surfaces_share_where_a_texel_of_one_is_a_texel_of_the_other),
        cmocka_unit_test(reading_gives_texels_as_floats_and_as_they_are),
        cmocka_unit_test(many_texels_are_read_as_few_are),
        cmocka_unit_test(reading_refuses_what_is_not_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
