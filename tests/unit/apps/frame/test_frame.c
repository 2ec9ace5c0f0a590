/* Frames grow, and memory that runs short is told at the end, wherever it ran short. */
#include "apps/bench/cases.h"
#include "apps/techniques/registry.h"
#include "apps/techniques/voxel/options.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"

static const GpSurfaceDesc small = { .format = GP_R8, .width = 4, .height = 4 };

static void an_arena_has_room_for_anything(void **state)
{
    (void)state;
    enum { COUNT = 3000 };
    static uint8_t *blocks[COUNT];
    Arena arena = { .result = GP_OK };
    for (size_t i = 0; i < COUNT; i++) {
        const size_t size = i % 7 == 0 ? 100000 : 1 + i % 300;
        blocks[i] = arena_alloc(&arena, 1, size);
        assert_non_null(blocks[i]);
        assert_int_equal((uintptr_t)blocks[i] % 64, 0);
        for (size_t k = 0; k < size; k++)
            assert_int_equal(blocks[i][k], 0);
        memset(blocks[i], (int)(1 + i % 255), size);
    }
    for (size_t i = 0; i < COUNT; i++)
        assert_int_equal(blocks[i][0], 1 + i % 255);
    for (size_t i = 0; i < COUNT; i++)
        assert_non_null(arena_surface(&arena, &small));
    assert_non_null(arena_alloc(&arena, 0, 10));
    assert_int_equal(arena_result(&arena, NULL), GP_OK);
    arena_free(&arena);
    assert_null(arena.chunks);
}

/* Draws of passes that were there, and of those that come, stay one behind the other. */
static void room_for_draws_can_be_made_at_once(void **state)
{
    (void)state;
    static const float black[4] = { 0 };
    Frame frame = { .color = NULL };
    GpSurface *surface = frame_surface(&frame, GP_R8, 4, 4, 1);
    const GpGeometry geometry = { .vertex_count = 3 };
    for (uint32_t pass = 0; pass < 3; pass++) {
        frame_pass(&frame, "pass", surface, NULL, black);
        frame_reserve(&frame, 1000);
        const uint32_t room = frame.draw_room;
        for (uint32_t i = 0; i < 1000; i++)
            frame_draw(&frame, NULL, NULL, &geometry)->name = pass == 1 ? "second" : "other";
        assert_int_equal(frame.draw_room, room);
    }
    for (uint32_t pass = 0; pass < 3; pass++) {
        assert_int_equal(frame.list.passes[pass].draw_count, 1000);
        assert_string_equal(frame.list.passes[pass].draws[0].name, pass == 1 ? "second" : "other");
        assert_string_equal(frame.list.passes[pass].draws[999].name,
                            pass == 1 ? "second" : "other");
    }
    frame_free(&frame);
}

static void an_arena_keeps_its_first_failure(void **state)
{
    (void)state;
    Arena arena = { .result = GP_OK };
    GpError error = { "" };
    assert_null(arena_alloc(&arena, SIZE_MAX / 2, 3));
    assert_null(arena_alloc(&arena, 1, 1));
    assert_null(arena_surface(&arena, &small));
    assert_null(arena_surface(&arena, &(GpSurfaceDesc){ .format = GP_R8 }));
    assert_int_equal(arena_result(&arena, &error), GP_ERROR_MEMORY);
    assert_string_equal(error.text, "out of memory");
    arena_free(&arena);

    assert_null(arena_surface(&arena, &(GpSurfaceDesc){ .format = GP_R8 }));
    assert_int_equal(arena_result(&arena, NULL), GP_ERROR_INVALID);
    arena_free(&arena);
}

/* Passes and draws stay what they were where they move. */
static void a_list_has_any_number_of_passes_and_draws(void **state)
{
    (void)state;
    enum { PASSES = 300 };
    Frame frame = { .color = NULL };
    GpSurface *target = frame_surface(&frame, GP_R8, 4, 4, 1);
    for (uint32_t p = 0; p < PASSES; p++) {
        frame_pass(&frame, "pass", target, NULL, (const float[4]){ (float)p })
            ->depth.stencil_value = (uint8_t)p;
        for (uint32_t d = 0; d < p % 9; d++)
            frame_draw(&frame, NULL, NULL, &(GpGeometry){ .vertex_count = 100 * p + d });
    }
    assert_int_equal(frame_result(&frame, NULL), GP_OK);
    assert_int_equal(frame.list.pass_count, PASSES);
    for (uint32_t p = 0; p < PASSES; p++) {
        const GpPass *pass = &frame.list.passes[p];
        assert_int_equal(pass->draw_count, p % 9);
        assert_int_equal(pass->depth.stencil_value, (uint8_t)p);
        assert_float_equal(pass->color[0].clear_color[0], p, 0);
        for (uint32_t d = 0; d < p % 9; d++)
            assert_int_equal(pass->draws[d].geometry.vertex_count, 100 * p + d);
    }
    frame_free(&frame);
}

/* --- memory that runs short ------------------------------------------------------------------- */

/* Builds again and again, with one piece of memory more each time, until it has all. */
static void fail_at_each(const TechniqueStage *stage, const char *options)
{
    GpResult result = GP_ERROR_MEMORY;
    uint32_t n = 0;
    while (result) {
        Frame frame = { .arena = { .fails = ++n } };
        GpError error = { "" };
        result =
            technique_build(stage->technique, stage->scene, options, stage->device, &frame, &error);
        if (result && result != GP_ERROR_MEMORY)
            fail_msg("%s %s: %u pieces: %s", stage->technique->name, options, n, error.text);
        assert_true(result || frame.arena.calls < n);
        frame_free(&frame);
    }
    assert_true(n > 5);
}

static void a_frame_without_memory_is_refused_wherever_it_ends(void **state)
{
    (void)state;
    static const char scene[] =
        "{ 'size': [32, 24], 'lights': [ { 'position': [2, 3, 1], 'at': [0, 0, 0] } ],"
        "  'objects': [ { 'mesh': 'builtin:cube' }, { 'mesh': 'builtin:plane' } ] }";
    static const struct {
        const char *technique, *scene, *options;
    } cases[] = {
        { "shadow", scene, "--map 64" },
        { "shadow", scene, "--map 64 --fit adaptive" },
        { "shadow", scene, "--map 64 --method plain" },
        { "voxelize", "builtin:cube", "--size 40" },
        { "voxelize", "builtin:cube", "--size 40 --method thin" },
        { "voxelize", "builtin:cube", "--size 40 --kind solid" },
        { "voxelize", "builtin:cube", "--size 40 --method sheets" },
        { "voxelize", "builtin:cube", "--size 40 --method sheets --bits 8" },
        { "voxelize", "builtin:cube", "--size 40 --method sheets --kind solid" },
        { "voxelize", "builtin:cube", "--size 8 --method slices" },
        { "voxelize", "builtin:cube", "--size 40 --method ldi" },
        { "voxelize", "builtin:cube", "--size 40 --method faces --kind solid" },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        TechniqueStage stage;
        GpError error = { "" };
        const Technique *technique = technique_find(technique_registry, cases[i].technique);
        if (!technique || technique_stage_open(technique, cases[i].scene, 0, 0, &stage, &error))
            fail_msg("%s: %s", cases[i].scene, error.text);
        fail_at_each(&stage, cases[i].options);
        technique_stage_close(&stage);
    }
}

/* Two models, what they have in common, and a picture of both. */
static GpResult build_pair(VoxelScene scenes[2], Frame *frame, GpError *error)
{
    const VoxelSetting setting = { .size = 16, .bits = 1, .axes = 3 };
    const VoxelPair pair = { .scenes = { &scenes[0], &scenes[1] },
                             .names = { "first", "second" },
                             .combine = VOXEL_TOUCHING };
    VoxelPicture picture = voxel_option_defaults.picture;
    VoxelPairMade made;
    picture.width = picture.height = 16;
    picture.shows_both = true;
    GpResult result = voxel_pair_build(&pair, &setting, frame, &made, error);
    return result ? result : voxel_picture_build(&picture, &made, NULL, frame, error);
}

static void a_picture_of_volumes_without_memory_is_refused(void **state)
{
    (void)state;
    static const char *const names[][2] = { { "implicit:quartic", "builtin:cube" },
                                            { "parametric:teapot", "parametric:torus" } };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        VoxelScene scenes[2];
        GpResult result = GP_ERROR_MEMORY;
        for (int k = 0; k < 2; k++)
            assert_int_equal(voxel_scene_open(names[i][k], &scenes[k], NULL), GP_OK);
        for (uint32_t n = 1; result; n++) {
            Frame frame = { .arena = { .fails = n } };
            result = build_pair(scenes, &frame, NULL);
            assert_true(result == GP_OK || result == GP_ERROR_MEMORY);
            assert_true(result || frame.arena.calls < n);
            frame_free(&frame);
        }
        for (int k = 0; k < 2; k++)
            voxel_scene_close(&scenes[k]);
    }
}

static void benchmark_cases_without_memory_are_refused(void **state)
{
    (void)state;
    static const char *const names[] = { "clear",       "fill",   "fill_tex_tri", "discard_tex",
                                         "small_draws", "sheets", "voxel_union",  "voxel_collide" };
    size_t found = 0;
    for (size_t i = 0; i < GP_COUNT(names); i++)
        for (const BenchCase *bench = bench_cases; bench < bench_cases + bench_case_count;
             bench++) {
            GpResult result = strcmp(bench->name, names[i]) ? GP_OK : GP_ERROR_MEMORY;
            for (uint32_t n = 1; result; n += n < 12 ? 1 : 500) {
                Frame frame = { .arena = { .fails = n } };
                result = bench->build(bench, &frame, NULL);
                assert_true(result == GP_OK || result == GP_ERROR_MEMORY);
                assert_true(!result == (frame.arena.calls < n));
                found += !result;
                frame_free(&frame);
            }
        }
    assert_int_equal(found, GP_COUNT(names));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_arena_has_room_for_anything),
        cmocka_unit_test(room_for_draws_can_be_made_at_once),
        cmocka_unit_test(an_arena_keeps_its_first_failure),
        cmocka_unit_test(a_list_has_any_number_of_passes_and_draws),
        cmocka_unit_test(a_frame_without_memory_is_refused_wherever_it_ends),
        cmocka_unit_test(a_picture_of_volumes_without_memory_is_refused),
        cmocka_unit_test(benchmark_cases_without_memory_are_refused),
    };
    return cmocka_run_group_tests_name("frame", tests, NULL, NULL);
}
