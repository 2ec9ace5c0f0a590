/* Whole frames through the device: what must hold between units. */
#include <glasspipe/glasspipe.h>
#include "tests/support/devices.h"
#include "tests/support/lists/drawing.h"
#include "tests/support/random_list.h"
#include "tests/support/unit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

static int pixels_not_zero(const GpSurface *surface)
{
    int count = 0;
    for (uint32_t i = 0; i < surface->width * surface->height; i++) {
        uint32_t texel;
        memcpy(&texel, surface->level[0].texels + 4 * i, 4);
        count += texel != 0;
    }
    return count;
}

/* --- rules ------------------------------------------------------------------------------------ */

static void r01_d3d9_centres_draw_the_picture_of_a_moved_viewport(void **state)
{
    (void)state;
    static const Corner triangle[3] = { { { -0.9f, 0.7f, 0, 1 }, { 1, 0, 0, 1 }, { 0, 0 } },
                                        { { 0.8f, 0.3f, 0, 1 }, { 0, 1, 0, 1 }, { 0, 0 } },
                                        { { -0.1f, -0.8f, 0, 1 }, { 0, 0, 1, 1 }, { 0, 0 } } };
    uint64_t hash[2];
    for (int i = 0; i < 2; i++) {
        Drawing f = new_drawing(GP_A8R8G8B8);
        link_drawing(&f, 1, &exercise_color, triangle, 3);
        float shift = i ? 0 : 0.5f;
        f.draw[0].viewport = (GpViewport){
            .x = shift, .y = shift, .width = SIZE, .height = SIZE, .d3d9_centers = i == 1
        };
        run_list_everywhere(&f.list, "the drawing");
        hash[i] = gp_surface_hash(f.color);
        free_drawing(&f);
    }
    assert_true(hash[0] == hash[1]);
}

static void r04_sliver_that_snaps_to_zero_area_draws_nothing(void **state)
{
    (void)state;
    const float y = 0.5f / SIZE, tiny = 1e-5f; /* under half a sub-pixel step high */
    const Corner sliver[3] = { { { -1, y, 0, 1 }, { 1, 1, 1, 1 }, { 0, 0 } },
                               { { 1, y, 0, 1 }, { 1, 1, 1, 1 }, { 0, 0 } },
                               { { 0, y + tiny, 0, 1 }, { 1, 1, 1, 1 }, { 0, 0 } } };
    Drawing f = new_drawing(GP_A8R8G8B8);
    link_drawing(&f, 1, &exercise_color, sliver, 3);
    run_list_everywhere(&f.list, "the drawing");
    assert_int_equal(pixels_not_zero(f.color), 0);
    free_drawing(&f);
}

static void r15_batching_changes_no_bit(void **state)
{
    (void)state;
    RandomList *all = gp_alloc(1, sizeof *all), *split = gp_alloc(1, sizeof *split);
    for (uint64_t seed = 100; seed < 130; seed++) {
        assert_true(random_list_create(seed, SIZE, all));
        assert_true(random_list_create(seed, SIZE, split));
        GpError error;
        assert_int_equal(run(&all->list, &(GpDeviceDesc){ 0 }, &error), GP_OK);
        /* the same passes, run as lists of their own */
        for (uint32_t p = 0; p < split->list.pass_count; p++)
            assert_int_equal(run(&(GpList){ &split->passes[p], 1 }, &(GpDeviceDesc){ 0 }, &error),
                             GP_OK);
        assert_true(random_list_hash(all) == random_list_hash(split));
        random_list_destroy(all);
        random_list_destroy(split);
    }
    gp_free(all);
    gp_free(split);
}

static void r54_devices_change_no_bit(void **state)
{
    (void)state;
    RandomList *random = gp_alloc(1, sizeof *random);
    for (uint64_t seed = 200; seed < 260; seed++) {
        char what[32];
        snprintf(what, sizeof what, "seed %d", (int)seed);
        assert_true(random_list_create(seed, SIZE, random));
        run_list_everywhere(&random->list, what);
        random_list_destroy(random);
    }
    gp_free(random);
}

#if defined(__SSE__)
static void r29_control_word_is_set_and_restored(void **state)
{
    (void)state;
    /* texture coordinates and colours that are denormal: flushed to zero they would vanish */
    static const Corner faint[3] = {
        { { -1, 3, 0, 1 }, { 1e-40f, 1e-40f, 1e-40f, 1 }, { 0, 0 } },
        { { 3, -1, 0, 1 }, { 1e-40f, 1e-40f, 1e-40f, 1 }, { 0, 0 } },
        { { -1, -1, 0, 1 }, { 1e-40f, 1e-40f, 1e-40f, 1 }, { 0, 0 } }
    };
    /* flush, denormals zero, truncate; up, and numbers that are none end the program */
    static const unsigned wild[] = { 0x1f80 | 0x8000 | 0x0040 | 0x6000, 0x1900 | 0x4000 };
    uint64_t hash[1 + GP_COUNT(wild)];
    unsigned before = _mm_getcsr();
    for (size_t i = 0; i < GP_COUNT(hash); i++) {
        const unsigned control = i ? wild[i - 1] : before;
        Drawing f = new_drawing(GP_A32B32G32R32F);
        link_drawing(&f, 1, &exercise_targets4, faint, 3);
        f.draw[0].program = &exercise_color;
        f.uniforms.color[0] = 1e-40f;
        _mm_setcsr(control);
        const GpResult checked = gp_list_check(&f.list, &f.error);
        GpResult result = run(&f.list, &(GpDeviceDesc){ 0 }, &f.error);
        unsigned after = _mm_getcsr();
        _mm_setcsr(before);
        assert_int_equal(checked, GP_OK);
        assert_int_equal(result, GP_OK);
        assert_int_equal(after & 0xffc0u, control & 0xffc0u);
        hash[i] = gp_surface_hash(f.color);
        float red;
        memcpy(&red, f.color->level[0].texels, sizeof red);
        assert_true(red > 0 && red < 1.2e-38f); /* a denormal came through */
        free_drawing(&f);
    }
    assert_true(hash[0] == hash[1] && hash[0] == hash[2]);
}
#endif

static void r35_fragments_arrive_in_primitive_order(void **state)
{
    (void)state;
    /* Twenty layers over the screen with a blend that does not commute: d = s*0.5 + d*0.5. */
    Corner layers[60];
    float expected = 0;
    for (int i = 0; i < 20; i++) {
        float shade = (float)((i * 7) % 11) / 10;
        expected = shade * 0.5f + expected * 0.5f;
        for (int k = 0; k < 3; k++)
            layers[3 * i + k] = (Corner){ { k == 1 ? 3.0f : -1.0f, k == 0 ? 3.0f : -1.0f, 0.5f, 1 },
                                          { shade, shade, shade, 0.5f },
                                          { 0, 0 } };
    }
    Drawing f = new_drawing(GP_A32B32G32R32F);
    link_drawing(&f, 1, &exercise_discard, layers, 60);
    f.draw[0].state.blend[0] =
        (GpBlend){ .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA };
    run_list_everywhere(&f.list, "the drawing");
    for (int i = 0; i < SIZE * SIZE; i++) {
        float red;
        memcpy(&red, f.color->level[0].texels + 16 * i, sizeof red);
        assert_true(red == expected);
    }
    free_drawing(&f);
}

static void r37_kept_channels_keep_their_bits(void **state)
{
    (void)state;
    Drawing f = new_drawing(GP_A8R8G8B8);
    link_drawing(&f, 1, &exercise_discard, full_screen, 6);
    f.pass.color[0].clear_color[1] = 1;
    f.draw[0].state.blend[0].keep = 1 << 1 | 1 << 3; /* green and alpha */
    run_list_everywhere(&f.list, "the drawing");
    const uint8_t *texel = f.color->level[0].texels; /* B G R A */
    assert_int_equal(texel[0], 0);
    assert_int_equal(texel[1], 255);
    assert_int_equal(texel[2], 255);
    assert_int_equal(texel[3], 0);
    free_drawing(&f);
}

static void stencil_scissor_and_alpha_test_stop_fragments(void **state)
{
    (void)state;
    for (int test = 0; test < 4; test++) {
        Drawing f = new_drawing(GP_A8R8G8B8);
        link_drawing(&f, 1, &exercise_depth, full_screen, 6);
        GpState *s = &f.draw[0].state;
        int expected = SIZE * SIZE;
        if (test == 1) {
            s->raster.scissor = true;
            s->raster.scissor_x0 = 3, s->raster.scissor_x1 = 10;
            s->raster.scissor_y0 = 5, s->raster.scissor_y1 = 6;
            expected = 7;
        } else if (test == 2) {
            s->alpha_test = (GpAlphaTest){ GP_GREATER, 128 }; /* alpha is 0.5 < 128/255 */
            expected = 0;
        } else if (test == 3) {
            s->stencil = (GpStencilState){
                .enable = true, .reference = 1, .front.test = GP_EQUAL, .back.test = GP_EQUAL
            };
            expected = 0;
        }
        run_list_everywhere(&f.list, "the drawing");
        assert_int_equal(pixels_not_zero(f.color), expected);
        free_drawing(&f);
    }
}

static void a_viewport_of_depth_0_writes_0(void **state)
{
    (void)state;
    for (int said = 0; said < 2; said++) {
        Drawing f = new_drawing(GP_A8R8G8B8);
        link_drawing(&f, 2, &exercise_color, full_screen, 6);
        for (int i = 0; i < 2; i++) {
            f.draw[i].viewport.has_depth_range = said;
            f.draw[i].state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
        }
        run_list_everywhere(&f.list, "the drawing");
        uint32_t code;
        memcpy(&code, f.depth->level[0].texels, sizeof code);
        const float depth = gp_depth_from_code(GP_D24S8, code >> 8);
        assert_true(said ? depth == 0 : fabsf(depth - 0.5f) < 1e-6f);
        free_drawing(&f);
    }
}

/* --- errors ----------------------------------------------------------------------------------- */

static void an_invalid_draw_is_named_and_changes_nothing(void **state)
{
    (void)state;
    Drawing f = new_drawing(GP_A8R8G8B8);
    link_drawing(&f, 2, &exercise_texture, full_screen, 6); /* no textures bound */
    f.draw[0].program = &exercise_color;
    memset(f.color->level[0].texels, 0x5a, SIZE * SIZE * 4);
    uint64_t before = gp_surface_hash(f.color);
    assert_int_equal(run(&f.list, &(GpDeviceDesc){ 0 }, &f.error), GP_ERROR_INVALID);
    assert_string_equal(f.error.text,
                        "pass 0 'main', draw 1 'triangles': textures[0].surface: not bound, but "
                        "exercise_texture reads slot 0");
    assert_true(gp_surface_hash(f.color) == before);
    free_drawing(&f);
}

static void devices_refuse_what_they_cannot_be(void **state)
{
    (void)state;
    GpDevice *device = NULL;
    GpError error;
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = -1 }, &device, &error),
                     GP_ERROR_INVALID);
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .isa = "mmx" }, &device, &error),
                     GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "'mmx'"));
    assert_int_equal(
        gp_device_create(&(GpDeviceDesc){ .executor = (GpExecutor)9 }, &device, &error),
        GP_ERROR_INVALID);
    assert_int_equal(
        gp_device_create(&(GpDeviceDesc){ .trace.event = ignore_event }, &device, &error),
        GP_ERROR_INVALID); /* the fast executor cannot be watched */
    assert_null(device);
}

/* Widths that a program lacks: asked for, they are an error, else a narrower one serves. */
static void a_program_is_drawn_at_a_width_that_it_has(void **state)
{
    (void)state;
    static const Corner corners[3] = { { .position = { -1, -1, 0, 1 } },
                                       { .position = { 3, -1, 0, 1 } },
                                       { .position = { -1, 3, 0, 1 } } };
    GpProgram narrow = exercise_color;
    narrow.code[1] = narrow.code[2] = NULL;
    Drawing f = new_drawing(GP_A8R8G8B8);
    link_drawing(&f, 1, &narrow, corners, 3);
    GpDevice *device = NULL;
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 1 }, &device, &f.error), GP_OK);
    if (!getenv("GP_ISA")) {
        assert_int_equal(gp_device_run(device, &f.list, &f.error), GP_OK);
        assert_string_equal(gp_device_isa(device), narrow.code[0]->isa);
    }
    gp_device_destroy(&device);
    gp_device_destroy(&device); /* NULL already */
    for (int lanes = 8; lanes <= 16; lanes *= 2) {
        char isa[24];
        snprintf(isa, sizeof isa, "lanes%d", lanes);
        if (gp_device_create(&(GpDeviceDesc){ .threads = 1, .isa = isa }, &device, &f.error)) {
            assert_non_null(
                strstr(f.error.text, "this processor, or this build, does not have it"));
            continue;
        }
        assert_int_equal(gp_device_run(device, &f.list, &f.error), GP_ERROR_UNSUPPORTED);
        assert_non_null(strstr(f.error.text, "was not compiled for"));
        gp_device_destroy(&device);
    }
    free_drawing(&f);
}

static void another_machines_instructions_are_refused(void **state)
{
    (void)state;
#ifdef __x86_64__
    const char *other = "neon";
#else
    const char *other = "avx512";
#endif
    GpDevice *device = NULL;
    GpError error = { "" };
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .isa = other }, &device, &error),
                     GP_ERROR_UNSUPPORTED);
    assert_non_null(strstr(error.text, "this processor, or this build, does not have it"));
    assert_null(device);
}

static void an_empty_isa_of_the_environment_is_none(void **state)
{
    (void)state;
    const char *before = getenv("GP_ISA");
    char *kept = before ? strdup(before) : NULL;
    GpDevice *device = NULL;
    assert_int_equal(setenv("GP_ISA", "", 1), 0);
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ 0 }, &device, NULL), GP_OK);
    assert_string_equal(gp_device_isa(device), "auto");
    gp_device_destroy(&device);
    gp_device_destroy(NULL);
    assert_int_equal(kept ? setenv("GP_ISA", kept, 1) : unsetenv("GP_ISA"), 0);
    free(kept);
}

/* A triangle that the near plane cuts is one, however many parts are left of it. */
static void a_clipped_primitive_is_drawn_once(void **state)
{
    (void)state;
    static const Corner through[3] = { { { -1, -1, 0.5f, 1 }, { 1, 1, 1, 1 }, { 0, 0 } },
                                       { { 0, 1, 0.5f, 1 }, { 1, 1, 1, 1 }, { 0, 0 } },
                                       { { 1, -1, -0.3f, 1 }, { 1, 1, 1, 1 }, { 0, 0 } } };
    Drawing f = new_drawing(GP_A8R8G8B8);
    link_drawing(&f, 1, &exercise_color, through, 3);
    GpDevice *device = device_open(&(GpDeviceDesc){ .executor = GP_EXECUTOR_REFERENCE });
    assert_int_equal(gp_device_run(device, &f.list, &f.error), GP_OK);
    const GpCounters *counters = gp_device_counters(device);
    assert_int_equal(counters->primitives, 1);
    assert_int_equal(counters->primitives_clipped, 1);
    assert_int_equal(counters->primitives_drawn, 1);
    gp_device_destroy(&device);
    free_drawing(&f);
}

/* --- groups ----------------------------------------------------------------------------------- */

static void passes_that_read_in_place_form_a_group(void **state)
{
    (void)state;
    GpSurface *s[4];
    for (int i = 0; i < 4; i++)
        assert_int_equal(
            gp_surface_create(
                &(GpSurfaceDesc){ .format = GP_A8R8G8B8, .width = i == 3 ? 32 : 64, .height = 64 },
                &s[i], NULL),
            GP_OK);
    GpDraw in_place = { .program = &exercise_local, .textures[3].surface = s[0] };
    GpDraw anywhere = { .program = &exercise_texture, .textures[0].surface = s[1] };
    GpPass passes[4] = {
        { .color[0].surface = s[0] },
        { .color[0].surface = s[1], .draws = &in_place, .draw_count = 1 },
        { .color[0].surface = s[2], .draws = &anywhere, .draw_count = 1 },
        { .color[0].surface = s[3] },
    };
    uint32_t group[4];
    assert_int_equal(gp_list_groups(&(GpList){ passes, 4 }, group), 3);
    assert_true(group[0] == 0 && group[1] == 0 && group[2] == 1 && group[3] == 2);
    for (int i = 0; i < 4; i++)
        gp_surface_destroy(&s[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r01_d3d9_centres_draw_the_picture_of_a_moved_viewport),
        cmocka_unit_test(r04_sliver_that_snaps_to_zero_area_draws_nothing),
        cmocka_unit_test(r15_batching_changes_no_bit),
        cmocka_unit_test(r54_devices_change_no_bit),
#if defined(__SSE__)
        cmocka_unit_test(r29_control_word_is_set_and_restored),
#endif
        cmocka_unit_test(r35_fragments_arrive_in_primitive_order),
        cmocka_unit_test(r37_kept_channels_keep_their_bits),
        cmocka_unit_test(stencil_scissor_and_alpha_test_stop_fragments),
        cmocka_unit_test(a_viewport_of_depth_0_writes_0),
        cmocka_unit_test(an_invalid_draw_is_named_and_changes_nothing),
        cmocka_unit_test(devices_refuse_what_they_cannot_be),
        cmocka_unit_test(a_program_is_drawn_at_a_width_that_it_has),
        cmocka_unit_test(another_machines_instructions_are_refused),
        cmocka_unit_test(an_empty_isa_of_the_environment_is_none),
        cmocka_unit_test(a_clipped_primitive_is_drawn_once),
        cmocka_unit_test(passes_that_read_in_place_form_a_group),
    };
    return cmocka_run_group_tests_name("device", tests, NULL, NULL);
}
