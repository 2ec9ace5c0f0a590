/* The steps of the printed method, as tables measure them: each pass belongs to one, and memory is
 * counted once. No time is judged. */
#include "apps/techniques/voxel/models.h"
#include "apps/techniques/voxel/sheets_time.h"
#include "apps/base/machine.h"
#include "apps/techniques/voxel/technique.h"
#include "tests/support/unit.h"

typedef struct Stage {
    void *scene;
    Frame frame;
    TechniqueClock clock;
} Stage;

static void set_up(Stage *stage, const char *options)
{
    GpError error = { "" };
    *stage = (Stage){ .clock = { .plan = { 0, 1, 0 },
                                 .each = gp_alloc(TIMING_MAX_FRAMES, sizeof(double)) } };
    assert_int_equal(
        gp_device_create(&(GpDeviceDesc){ .threads = 1 }, &stage->clock.device, &error), GP_OK);
    assert_int_equal(technique_open(&voxel_technique, "builtin:cube", 0, 0, &stage->scene, &error),
                     GP_OK);
    if (technique_build(&voxel_technique, stage->scene, options, stage->clock.device, &stage->frame,
                        &error))
        fail_msg("%s", error.text);
}

static void tear_down(Stage *stage)
{
    frame_free(&stage->frame);
    voxel_technique.close(stage->scene);
    gp_device_destroy(&stage->clock.device);
    gp_free(stage->clock.each);
}

/* The names that the steps go by. */
static void the_printed_method_has_passes_of_all_steps(void **state)
{
    (void)state;
    Stage stage;
    uint32_t along = 0, gather = 0, others = 0;
    set_up(&stage, "--method sheets --size 64");
    for (uint32_t i = 0; i < stage.frame.list.pass_count; i++) {
        const char *name = stage.frame.list.passes[i].name;
        along += strncmp(name, "along ", 6) == 0;
        gather += strcmp(name, "gather") == 0;
        others += strcmp(name, "found") == 0 || strncmp(name, "turn ", 5) == 0;
    }
    assert_int_equal(along, 3);
    assert_int_equal(gather, 3);
    assert_int_equal(others, 4);
    assert_int_equal(along + gather + others, stage.frame.list.pass_count);
    tear_down(&stage);
}

/* Each took time, and all of them no more than the clock on the wall says. */
static void every_step_takes_time(void **state)
{
    (void)state;
    Stage stage;
    GpError error = { "" };
    SheetsTimes steps = { 0, 0, 0 };
    double sort = 0, begin, elapsed;
    set_up(&stage, "--method sheets --size 64");
    begin = machine_clock_ms(CLOCK_MONOTONIC);
    if (sheets_time_steps(&stage.clock, &stage.frame, &steps, &error))
        fail_msg("%s", error.text);
    elapsed = machine_clock_ms(CLOCK_MONOTONIC) - begin;
    assert_true(steps.raster > 0 && steps.texelize > 0 && steps.synthesize > 0);
    assert_true(steps.raster + steps.texelize + steps.synthesize <= elapsed);
    begin = machine_clock_ms(CLOCK_MONOTONIC);
    assert_int_equal(sheets_time_sort(&stage.clock, &((const VoxelModels *)stage.scene)->scene, 512,
                                      &sort, &error),
                     GP_OK);
    assert_true(sort > 0 && sort <= machine_clock_ms(CLOCK_MONOTONIC) - begin);
    tear_down(&stage);
}

/* At 64 voxels a side: three flat textures of 64 x 128 texels, four targets of one patch, and, for
 * the turns, 8 octets a row of each of 2 slabs. */
static void memory_is_that_of_all_surfaces_once(void **state)
{
    (void)state;
    const size_t texel = 4, sheets = 3 * 64 * 128, targets = 4 * 64 * 64, found = 8 * 2 * 64;
    Stage stage;
    set_up(&stage, "--method sheets --size 64");
    assert_int_equal(sheets_bytes(&stage.frame.list), texel * (sheets + targets + found));
    tear_down(&stage);
    set_up(&stage, "--method sheets --axes 1 --size 64");
    assert_int_equal(sheets_bytes(&stage.frame.list), texel * (sheets / 3 + targets));
    tear_down(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_printed_method_has_passes_of_all_steps),
        cmocka_unit_test(every_step_takes_time),
        cmocka_unit_test(memory_is_that_of_all_surfaces_once),
    };
    return cmocka_run_group_tests_name("sheets time", tests, NULL, NULL);
}
