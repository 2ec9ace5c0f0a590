/* The fast executor with next to no memory for vertices and bins: what is there is drawn before
 * more is made, and the bits stay the same; so with next to none for fragments to be sorted, where
 * tiles come in slices, and in passes that repeat earlier ones. */
#include "pipeline/fast/draws/draw.h"
#include "pipeline/fast/fast.h"
#include "shaders_c/materials/unlit.h"
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/lists/random_order.h"
#include "tests/support/lists/random_repeats.h"
#include "tests/support/limited.h"
#include "tests/support/unit.h"

#include "pipeline/base/fpcontrol.h"

#include <malloc.h>
#include <stdio.h>
#include <sys/mman.h>
#include <sys/resource.h>

enum { SEEDS = 150, SIZE = 150, LANES = 4 /* always compiled */ };

static uint64_t draw(uint64_t seed, bool sorted, int threads, size_t limit, RandomList *random)
{
    GpFast *fast = NULL;
    GpCounters counters = { 0 };
    GpPhases phases = { 0 };
    assert_true(random_list_create(seed, SIZE, random));
    assert_true(!sorted || random_order_add(seed, random));
    if (seed % 2 && !sorted)
        random_repeats_add(seed, random);
    assert_int_equal(gp_fast_create(threads, &fast, NULL), GP_OK);
    if (limit)
        gp_fast_set_limit(fast, limit);
    GpFpControl control = gp_fp_enter();
    assert_int_equal(gp_fast_run(fast, &random->list, LANES, false, &counters, &phases, NULL),
                     GP_OK);
    gp_fp_leave(control);
    gp_fast_destroy(&fast);
    uint64_t hash = random_list_hash(random);
    random_list_destroy(random);
    return hash;
}

static void memory_limit_changes_no_bit(void **state)
{
    (void)state;
    static const size_t limits[] = { 1, 3000, 100000 };
    RandomList *random = gp_alloc(1, sizeof *random);
    for (uint64_t seed = 0; seed < SEEDS; seed++) {
        const bool sorted = seed % 32 == 15; /* a second each, with the least for fragments */
        uint64_t whole = draw(seed, sorted, 1, 0, random);
        for (size_t i = 0; i < (sorted ? 1 : GP_COUNT(limits)); i++)
            assert_true(draw(seed, sorted, 1 + (int)(seed % 3), limits[i], random) == whole);
    }
    gp_free(random);
}

/* --- what is predicted ------------------------------------------------------------------------ */

/* Bytes that the program has allocated; 0 where a sanitizer keeps the books. */
static uint64_t allocated(void)
{
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

/* Runs a list on a fresh executor: what it was said to take, and what it holds afterwards. */
static GpResult run_measured(const GpList *list, int threads, uint64_t *predicted, uint64_t *held,
                             GpError *error)
{
    GpFast *fast = NULL;
    GpCounters counters = { 0 };
    GpPhases phases = { 0 };
    const uint64_t before = allocated();
    assert_int_equal(gp_fast_create(threads, &fast, NULL), GP_OK);
    *predicted = gp_fast_memory(fast, list, LANES);
    GpFpControl control = gp_fp_enter();
    const GpResult result = gp_fast_run(fast, list, LANES, false, &counters, &phases, error);
    gp_fp_leave(control);
    *held = allocated() - before;
    gp_fast_destroy(&fast);
    return result;
}

static void lists_take_no_more_than_is_predicted(void **state)
{
    (void)state;
    RandomList *random = gp_alloc(1, sizeof *random);
    for (uint64_t seed = 0; seed < 60; seed++) {
        uint64_t predicted, held;
        assert_true(random_list_create(seed, SIZE, random));
        assert_true(seed % 3 || random_order_add(seed, random));
        assert_int_equal(run_measured(&random->list, 1 + (int)(seed % 3), &predicted, &held, NULL),
                         GP_OK);
        assert_true(held <= predicted);
        random_list_destroy(random);
    }
    gp_free(random);
}

enum { VERTICES = 3000000 };

/* A draw that is larger than all else: known within a factor, and said where there is not so
 * much. */
static void memory_of_a_large_draw_is_predicted_and_said(void **state)
{
    (void)state;
    static const UnlitUniforms uniforms = { .mvp = { [3] = { 0, 0, 0, 1 } } };
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = 8, .height = 8 };
    GpSurface *target;
    GpError error = { "" };
    uint64_t predicted, held;
    float *positions = gp_alloc(VERTICES, 3 * sizeof *positions);
    assert_int_equal(gp_surface_create(&desc, &target, NULL), GP_OK);
    GpDraw draw = { .program = &unlit_program, .uniforms = &uniforms };
    draw.geometry.vertex_count = VERTICES;
    draw.geometry.streams[GP_POSITION] = (GpStream){ .data = positions, .components = 3 };
    draw.state.raster.clip_planes = 63; /* distances, beside a vertex's place */
    const GpPass pass = { .color = { { .surface = target } }, .draws = &draw, .draw_count = 1 };
    const GpList list = { &pass, 1 };
    assert_int_equal(run_measured(&list, 2, &predicted, &held, &error), GP_OK);
    assert_true(held <= predicted);
    if (limits_hold()) { /* and held is known */
        assert_true(predicted <= 8 * held);
        struct rlimit before, little;
        assert_int_equal(getrlimit(RLIMIT_DATA, &before), 0);
        little = before;
        little.rlim_cur = 1 << 20; /* what is there stays; no more */
        assert_int_equal(setrlimit(RLIMIT_DATA, &little), 0);
        const GpResult result = run_measured(&list, 1, &predicted, &held, &error);
        assert_int_equal(setrlimit(RLIMIT_DATA, &before), 0);
        assert_int_equal(result, GP_ERROR_MEMORY);
        char expected[64];
        snprintf(expected, sizeof expected, "the list may take up to %.0f MB",
                 (double)predicted / (1 << 20));
        if (!strstr(error.text, expected))
            fail_msg("%s", error.text);
    }
    gp_surface_destroy(&target);
    gp_free(positions);
}

static uint64_t predicted_of_clear(uint32_t tiles_x, uint32_t tiles_y, int threads)
{
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8,
                                 .width = tiles_x * FAST_TILE,
                                 .height = tiles_y * FAST_TILE };
    GpSurface *target;
    GpFast *fast = NULL;
    assert_int_equal(gp_surface_create(&desc, &target, NULL), GP_OK);
    assert_int_equal(gp_fast_create(threads, &fast, NULL), GP_OK);
    const GpPass pass = { .color = { { .surface = target, .clear = true } } };
    const uint64_t predicted = gp_fast_memory(fast, &(GpList){ &pass, 1 }, LANES);
    gp_fast_destroy(&fast);
    gp_surface_destroy(&target);
    return predicted;
}

/* A thread without a tile takes nothing. */
static void memory_is_told_of_as_many_threads_as_have_tiles(void **state)
{
    (void)state;
    const uint64_t of_a_thread = predicted_of_clear(4, 4, 2) - predicted_of_clear(4, 4, 1);
    assert_true(of_a_thread > 0);
    for (int threads = 3; threads <= 18; threads++) {
        const uint64_t more =
            predicted_of_clear(4, 4, threads) - predicted_of_clear(4, 4, threads - 1);
        assert_int_equal(more, threads <= 16 ? of_a_thread : 0);
    }
    assert_int_equal(predicted_of_clear(1, 1, 8), predicted_of_clear(1, 1, 1));
}

/* Vertices of one packet whose colours lie gigabytes apart. */
static void strides_may_be_as_long_as_memory(void **state)
{
    (void)state;
    enum { FEW = 18 };
    const size_t stride = (size_t)1 << 30, bytes = FEW * stride;
    uint8_t *colors = mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (colors == MAP_FAILED)
        skip();
    float corners[FEW][4] = { { 0 } };
    for (size_t i = 0; i < FEW; i++) {
        corners[i][0] = (float)(i % 6) / 3 - 1;
        corners[i][1] = i % 3 == 1 ? 1.0f : -0.5f + (float)i / FEW;
        corners[i][3] = 1;
        memset(colors + i * stride, (int)(40 + 10 * i), 4);
    }
    GpSurface *surface = NULL;
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = SIZE, .height = SIZE };
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    ExerciseUniforms uniforms = { .color = { 1, 1, 1, 1 } };
    for (int i = 0; i < 4; i++)
        uniforms.matrix[i][i] = 1;
    GpDraw draw = { .program = &exercise_color, .uniforms = &uniforms };
    draw.geometry.vertex_count = FEW;
    draw.geometry.streams[GP_POSITION] = (GpStream){ corners[0], 0, 4, GP_FLOAT32 };
    draw.geometry.streams[GP_COLOR] = (GpStream){ colors, (uint32_t)stride, 4, GP_D3DCOLOR };
    draw.geometry.streams[GP_TEXCOORD0] = (GpStream){ corners[0], 16, 2, GP_FLOAT32 };
    const GpPass pass = { .color = { { surface, true, { 0 } } }, .draws = &draw, .draw_count = 1 };
    run_list_everywhere(&(GpList){ &pass, 1 }, "vertices that lie far apart");
    gp_surface_destroy(&surface);
    munmap(colors, bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(memory_limit_changes_no_bit),
        cmocka_unit_test(lists_take_no_more_than_is_predicted),
        cmocka_unit_test(memory_of_a_large_draw_is_predicted_and_said),
        cmocka_unit_test(memory_is_told_of_as_many_threads_as_have_tiles),
        cmocka_unit_test(strides_may_be_as_long_as_memory),
    };
    return cmocka_run_group_tests_name("fast memory", tests, NULL, NULL);
}
