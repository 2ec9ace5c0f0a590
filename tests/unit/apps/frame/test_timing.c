/* What the times of frames come to: medians, quartiles, and when there are enough of them. */
#include "apps/frame/timing.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

static void a_median_has_as_many_below_as_above(void **state)
{
    (void)state;
    double one[] = { 7 }, two[] = { 4, 1 }, three[] = { 9, 1, 5 }, four[] = { 8, 1, 3, 100 };
    double many[101];
    for (int i = 0; i < 101; i++)
        many[i] = i * 37 % 101;
    assert_true(timing_median(one, 1) == 7);
    assert_true(timing_median(two, 2) == 2.5);
    assert_true(timing_median(three, 3) == 5);
    assert_true(timing_median(four, 4) == 5.5);
    assert_true(timing_median(many, 101) == 50);
    assert_true(timing_median(many, 100) == 49.5); /* sorted by then: 0 to 99 */
}

static void a_plan_ends_by_frames_and_seconds(void **state)
{
    (void)state;
    const TimingPlan plan = { .seconds = 1, .least_frames = 5, .most_seconds = 3 };
    assert_false(timing_is_over(&plan, 4, 1000));
    assert_false(timing_is_over(&plan, 4, 2999));
    assert_true(timing_is_over(&plan, 4, 3000));
    assert_false(timing_is_over(&plan, 5, 999));
    assert_true(timing_is_over(&plan, 5, 1000));
    assert_true(timing_is_over(&plan, TIMING_MAX_FRAMES, 0));
}

static void frames_are_ordered_by_their_times(void **state)
{
    (void)state;
    static double each[TIMING_MAX_FRAMES];
    const TimingPlan plan = { .least_frames = 9, .most_seconds = 3600 };
    GpError error = { "" };
    Frame frame = { .color = NULL };
    RunStatistics statistics;
    Timing timing;
    GpDevice *device = device_open(&(GpDeviceDesc){ .threads = 2 });
    frame_pass(&frame, "clear", frame_surface(&frame, GP_A8R8G8B8, 64, 64, 1), NULL,
               (float[4]){ 0 });
    if (run_first(device, &frame.list, &statistics, &error) ||
        timing_run(device, &frame.list, &plan, each, &statistics, &timing, &error))
        fail_msg("%s", error.text);
    assert_int_equal(timing.frames, 9);
    for (int i = 1; i < 9; i++)
        assert_true(each[i - 1] <= each[i]);
    assert_true(timing.min_ms == each[0] && timing.low_ms == each[2] && timing.ms == each[4] &&
                timing.high_ms == each[6] && timing.max_ms == each[8]);
    frame_free(&frame);
    gp_device_destroy(&device);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_median_has_as_many_below_as_above),
        cmocka_unit_test(a_plan_ends_by_frames_and_seconds),
        cmocka_unit_test(frames_are_ordered_by_their_times),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
