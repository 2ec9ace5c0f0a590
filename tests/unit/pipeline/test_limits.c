/* The limits of lists and devices: what is at one works, and what is one beyond is refused with the
 * reason. */
#include "pipeline/resources/surface_memory.h"
#include "shaders_c/materials/unlit.h"
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/limited.h"
#include "tests/support/unit.h"

#include <stdio.h>
#include <sys/resource.h>

static GpError error;

static const float corners[4][3] = { { -1, -1, 0 }, { -1, 1, 0 }, { 1, -1, 0 }, { 1, 1, 0 } };
static const UnlitUniforms uniforms = {
    .mvp = { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } },
    .color = { 1 / 255.0f, 2 / 255.0f, 3 / 255.0f, 1 },
};

static GpSurface *surface_of(uint32_t width, uint32_t height)
{
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = width, .height = height };
    GpSurface *surface = NULL;
    error.text[0] = '\0';
    if (gp_surface_create(&desc, &surface, &error))
        assert_null(surface);
    return surface;
}

/* A strip over all of the target, which adds its colour. */
static GpDraw strip(void)
{
    GpDraw draw = { .program = &unlit_program, .uniforms = &uniforms };
    draw.geometry.primitive = GP_TRIANGLE_STRIP;
    draw.geometry.vertex_count = 4;
    draw.geometry.streams[GP_POSITION] = (GpStream){ .data = corners, .components = 3 };
    draw.state.blend[0] = (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
    return draw;
}

static void expect_message(const char *part)
{
    if (!strstr(error.text, part))
        fail_msg("'%s' is not in: %s", part, error.text);
}

static void expect_texel(const GpSurface *surface, uint32_t x, uint32_t y, uint32_t expected)
{
    uint32_t texel;
    memcpy(&texel, gp_surface_texel(&surface->level[0], 4, x, y), sizeof texel);
    assert_int_equal(texel, expected);
}

/* --- targets ---------------------------------------------------------------------------------- */

static void targets_have_up_to_8192_texels_a_side(void **state)
{
    (void)state;
    static const uint32_t sides[][2] = { { GP_MAX_SIZE, 3 }, { 3, GP_MAX_SIZE } };
    for (size_t i = 0; i < GP_COUNT(sides); i++) {
        GpSurface *target = surface_of(sides[i][0], sides[i][1]);
        assert_non_null(target);
        const GpDraw draw = strip();
        const GpPass pass = { .color = { { .surface = target, .clear = true } },
                              .draws = &draw,
                              .draw_count = 1 };
        run_list(&(GpList){ &pass, 1 });
        expect_texel(target, sides[i][0] - 1, sides[i][1] - 1, 0xff010203);
        gp_surface_destroy(&target);
        const bool wide = sides[i][0] == GP_MAX_SIZE;
        assert_null(surface_of(sides[i][0] + wide, sides[i][1] + !wide));
        expect_message("8192");
    }
}

/* What a surface takes is known before, and said where there is not so much. */
static void memory_of_surfaces_is_predicted(void **state)
{
    (void)state;
    const GpSurfaceDesc large = { .format = GP_A32B32G32R32F, .width = 8192, .height = 8192 };
    const GpSurfaceDesc chain = {
        .format = GP_A8R8G8B8, .width = 5, .height = 3, .levels = GP_MAX_LEVELS
    };
    assert_true(gp_surface_bytes(&large) == (uint64_t)1 << 30);
    assert_true(gp_surface_bytes(&chain) == (5 * 3 + 2 * 1 + 1) * 4);
    const GpSurfaceDesc window = {
        .format = GP_A8R8G8B8, .width = 64, .height = 64, .window = { 3, 5, 10, 9 }
    };
    assert_true(gp_surface_bytes(&window) == 7 * 4 * 4);
    GpSurface *surface = NULL;
    assert_int_equal(gp_surface_create(&chain, &surface, &error), GP_OK);
    uint64_t bytes = 0;
    for (uint32_t i = 0; i < surface->levels; i++)
        bytes += surface->level[i].pitch * surface->level[i].height;
    assert_true(gp_surface_bytes(&chain) == bytes);
    gp_surface_destroy(&surface);
    if (!limits_hold())
        return;
    struct rlimit before, little;
    assert_int_equal(getrlimit(RLIMIT_AS, &before), 0);
    little = before;
    little.rlim_cur = (rlim_t)900 << 20;
    assert_int_equal(setrlimit(RLIMIT_AS, &little), 0);
    assert_int_equal(gp_surface_create(&large, &surface, &error), GP_ERROR_MEMORY);
    assert_int_equal(setrlimit(RLIMIT_AS, &before), 0);
    assert_null(surface);
    expect_message("8192x8192 A32B32G32R32F, 1024 MB");
}

/* --- threads ---------------------------------------------------------------------------------- */

static void devices_have_up_to_1024_threads(void **state)
{
    (void)state;
    GpDevice *device = NULL;
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 1024 }, &device, &error), GP_OK);
    assert_int_equal(gp_device_threads(device), 1024);
    gp_device_destroy(&device);
    for (int threads = -1; threads <= 1025; threads += 1026) {
        assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = threads }, &device, &error),
                         GP_ERROR_INVALID);
        assert_null(device);
        expect_message("expected 0 to 1024");
    }
}

/* --- passes, draws, primitives: as many as there is memory for -------------------------------- */

enum { PASSES = 3000, DRAWS = 9000, TRIANGLES = 300000 };

static void lists_have_any_number_of_passes(void **state)
{
    (void)state;
    GpSurface *target = surface_of(5, 4);
    GpPass *passes = gp_alloc(PASSES, sizeof *passes);
    const GpDraw draw = strip();
    for (int i = 0; i < PASSES; i++)
        passes[i] = (GpPass){ .color = { { .surface = target, .clear = i == PASSES - 7 } },
                              .draws = &draw,
                              .draw_count = 1 };
    run_list(&(GpList){ passes, PASSES });
    expect_texel(target, 4, 3, 0xff070e15); /* seven times 1, 2, 3 */
    gp_free(passes);
    gp_surface_destroy(&target);
}

static void passes_have_any_number_of_draws(void **state)
{
    (void)state;
    GpSurface *target = surface_of(5, 4);
    GpDraw *draws = gp_alloc(DRAWS, sizeof *draws);
    for (int i = 0; i < DRAWS; i++) {
        draws[i] = strip();
        draws[i].state.blend[0].op = i < DRAWS - 7 ? GP_BLEND_LOGIC_AND : GP_BLEND_ADD;
    }
    const GpPass pass = { .color = { { .surface = target, .clear = true } },
                          .draws = draws,
                          .draw_count = DRAWS };
    run_list(&(GpList){ &pass, 1 });
    expect_texel(target, 0, 0, 0xff070e15);
    gp_free(draws);
    gp_surface_destroy(&target);
}

/* Indices reach the last vertex, and none beyond. */
static void draws_have_any_number_of_triangles(void **state)
{
    (void)state;
    GpSurface *target = surface_of(4, 4);
    uint32_t *indices = gp_alloc(3 * TRIANGLES, sizeof *indices);
    GpDraw draw = strip();
    draw.geometry.primitive = GP_TRIANGLES;
    draw.geometry.indices = indices;
    draw.geometry.index_count = 3 * TRIANGLES;
    for (uint32_t i = 0; i < 3 * TRIANGLES; i++)
        indices[i] = i / 3 % 2 ? 1 + i % 3 : i % 3;
    const GpPass pass = { .color = { { .surface = target, .clear = true } },
                          .draws = &draw,
                          .draw_count = 1 };
    run_list(&(GpList){ &pass, 1 });
    expect_texel(target, 3, 0, 0xffffffff);
    indices[3 * TRIANGLES - 1] = 4;
    assert_int_equal(gp_list_check(&(GpList){ &pass, 1 }, &error), GP_ERROR_INVALID);
    expect_message("4");
    indices[3 * TRIANGLES - 1] = 3;
    draw.geometry.index_count--;
    assert_int_equal(gp_list_check(&(GpList){ &pass, 1 }, &error), GP_ERROR_INVALID);
    gp_free(indices);
    gp_surface_destroy(&target);
}

/* Nothing is read of so many: the check counts. */
static void draws_have_up_to_2_to_the_30_primitives(void **state)
{
    (void)state;
    GpSurface *target = surface_of(4, 4);
    GpDraw draws[2] = { strip(), strip() };
    GpPass pass = { .color = { { .surface = target, .clear = true } },
                    .draws = draws,
                    .draw_count = 1 };
    const GpList list = { &pass, 1 };
    draws[0].geometry.vertex_count = (1u << 30) + 2;
    assert_int_equal(gp_list_check(&list, &error), GP_OK);
    draws[0].geometry.vertex_count++;
    assert_int_equal(gp_list_check(&list, &error), GP_ERROR_INVALID);
    expect_message("1073741825 primitives, at most 1073741824");

    draws[0].geometry.vertex_count = draws[1].geometry.vertex_count = (1u << 29) + 2;
    pass.draw_count = 2;
    pass.order = GP_ORDER_DEPTH;
    assert_int_equal(gp_list_check(&list, &error), GP_OK);
    draws[1].geometry.vertex_count++;
    assert_int_equal(gp_list_check(&list, &error), GP_ERROR_INVALID);
    expect_message("1073741825 primitives in a pass that sorts");
    pass.order = GP_ORDER_SUBMITTED;
    assert_int_equal(gp_list_check(&list, &error), GP_OK);
    gp_surface_destroy(&target);
}

/* More primitives in a pass than bins can number, of which only those of the last two draws are on
 * the screen; the near plane cuts one of them. It takes some seconds, and is made where
 * GP_TEST_LARGE asks. */
static void passes_have_more_primitives_than_numbers(void **state)
{
    (void)state;
    enum { COUNT = 3 * 1000000, DRAWS_OF_A_MILLION = 2200 };
    static const float near_and_far[3][3] = { { -1, -1, -1 }, { -1, 3, 2 }, { 3, -1, 0.5f } };
    if (!getenv("GP_TEST_LARGE")) {
        print_message("# skipped: takes seconds; GP_TEST_LARGE=1 runs it\n");
        skip();
    }
    GpSurface *target = surface_of(4, 4), *expected = surface_of(4, 4);
    uint32_t *indices = gp_alloc(COUNT, sizeof *indices); /* all 0: no triangle has an area */
    GpDraw *draws = gp_alloc(DRAWS_OF_A_MILLION + 2, sizeof *draws);
    for (int i = 0; i < DRAWS_OF_A_MILLION; i++) {
        draws[i] = strip();
        draws[i].geometry.primitive = GP_TRIANGLES;
        draws[i].geometry.indices = indices;
        draws[i].geometry.index_count = COUNT;
    }
    GpDraw *last = &draws[DRAWS_OF_A_MILLION];
    last[0] = last[1] = strip();
    last->geometry.primitive = GP_TRIANGLES;
    last->geometry.vertex_count = 3;
    last->geometry.streams[GP_POSITION].data = near_and_far;
    GpPass pass = { .color = { { .surface = expected, .clear = true } },
                    .draws = last,
                    .draw_count = 2 };
    run_list(&(GpList){ &pass, 1 });
    pass.color[0].surface = target;
    pass.draws = draws;
    pass.draw_count = DRAWS_OF_A_MILLION + 2;
    run_list(&(GpList){ &pass, 1 });
    assert_true(gp_surface_hash(target) == gp_surface_hash(expected));
    gp_free(draws);
    gp_free(indices);
    gp_surface_destroy(&target);
    gp_surface_destroy(&expected);
}

static void six_clip_planes_exist(void **state)
{
    (void)state;
    GpSurface *target = surface_of(4, 4);
    GpDraw draw = strip();
    const GpPass pass = { .color = { { .surface = target, .clear = true } },
                          .draws = &draw,
                          .draw_count = 1 };
    draw.state.raster.clip_planes = 0x3f;
    assert_int_equal(gp_list_check(&(GpList){ &pass, 1 }, &error), GP_OK);
    draw.state.raster.clip_planes = 0x40;
    assert_int_equal(gp_list_check(&(GpList){ &pass, 1 }, &error), GP_ERROR_INVALID);
    expect_message("only 6 planes exist");
    gp_surface_destroy(&target);
}

/* Every input, and ten varyings, of four components, interpolated or not: of triangles with one
 * colour the sum is exact, and of others everywhere the same. Large triangles fill packets to the
 * last, small ones share them. */
static void shaders_have_every_input_and_40_components_of_varyings(void **state)
{
    (void)state;
    enum { SIDE = 150, TRIED = 60 };
    static float vertices[3 * TRIED][8];
    ExerciseUniforms unit = { .color = { 0 } };
    for (int i = 0; i < 4; i++)
        unit.matrix[i][i] = 1;
    for (int i = 0; i < 3 * TRIED; i++) {
        const bool large = i < 6;
        const float x = large ? -1 : (float)(i / 3 % 10) * 0.19f - 0.95f,
                    y = large ? 1 : 0.95f - (float)(i / 30) * 0.3f, size = large ? 4 : 0.2f;
        const float vertex[8] = { x + (i % 3 == 1 ? size : 0),
                                  y - (i % 3 == 2 ? size : 0),
                                  0,
                                  i < 3 ? 1 : 1 + (float)(i % 3),
                                  i < 3 ? 0.5f : (float)i,
                                  0.25f,
                                  i < 3 ? 2 : (float)(i % 7),
                                  1 };
        memcpy(vertices[i], vertex, sizeof vertex);
    }
    GpSurface *target = NULL;
    const GpSurfaceDesc desc = { .format = GP_A32B32G32R32F, .width = SIDE, .height = SIDE };
    assert_int_equal(gp_surface_create(&desc, &target, NULL), GP_OK);
    GpDraw draw = { .program = &exercise_wide, .uniforms = &unit };
    const uint32_t stride = sizeof vertices[0];
    draw.geometry.vertex_count = 3;
    for (GpSemantic i = 0; i < GP_SEMANTICS; i++)
        draw.geometry.streams[i] =
            (GpStream){ vertices[0] + (i == GP_POSITION ? 0 : 4), stride, 4, GP_FLOAT32 };
    const GpPass pass = { .color = { { .surface = target, .clear = true } },
                          .draws = &draw,
                          .draw_count = 1 };
    for (size_t d = 0; device_here(d); d++) {
        run_list_on(device_here(d), &(GpList){ &pass, 1 });
        for (uint32_t i = 0; i < SIDE * SIDE; i++) {
            const float *texel = (const float *)(const void *)target->level[0].texels + 4 * i;
            assert_true(texel[0] == 27.5f && texel[1] == 13.75f && texel[2] == 110);
        }
    }
    draw.geometry.vertex_count = 3 * TRIED;
    run_seed_everywhere(&pass, 0);
    gp_surface_destroy(&target);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(targets_have_up_to_8192_texels_a_side),
        cmocka_unit_test(memory_of_surfaces_is_predicted),
        cmocka_unit_test(devices_have_up_to_1024_threads),
        cmocka_unit_test(lists_have_any_number_of_passes),
        cmocka_unit_test(passes_have_any_number_of_draws),
        cmocka_unit_test(draws_have_any_number_of_triangles),
        cmocka_unit_test(draws_have_up_to_2_to_the_30_primitives),
        cmocka_unit_test(passes_have_more_primitives_than_numbers),
        cmocka_unit_test(six_clip_planes_exist),
        cmocka_unit_test(shaders_have_every_input_and_40_components_of_varyings),
    };
    return cmocka_run_group_tests_name("limits", tests, NULL, NULL);
}
