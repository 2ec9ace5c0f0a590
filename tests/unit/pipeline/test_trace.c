/* Traces: what is told of a frame, of which part of it, and that telling changes no bit. */
#include <math.h>

#include "pipeline/resources/compare.h"
#include "tests/support/lists/drawing.h"
#include "tests/support/random_list.h"

typedef struct Seen {
    int count[GP_TRACE_KINDS];
    int last_kind;
    bool in_order;
} Seen;

static void note_event(void *user, const GpTraceEvent *event)
{
    Seen *seen = user;
    seen->count[event->kind]++;
    if (event->kind == GP_TRACE_VERTEX || event->kind == GP_TRACE_CLEAR)
        seen->last_kind = 0; /* a new primitive begins */
    seen->in_order = seen->in_order && (int)event->kind >= seen->last_kind;
    seen->last_kind = (int)event->kind;
    if (event->kind >= GP_TRACE_RASTER)
        assert_true(event->x == 20 && event->y == 30);
}

static void a_watched_pixel_reports_every_unit_in_order(void **state)
{
    (void)state;
    Seen seen = { .in_order = true };
    Drawing f = new_drawing(GP_A8R8G8B8);
    link_drawing(&f, 3, &exercise_discard, full_screen, 6);
    for (int i = 0; i < 3; i++)
        f.draw[i].state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    GpDeviceDesc desc = {
        .executor = GP_EXECUTOR_REFERENCE,
        .trace = { .event = note_event, .user = &seen, .one_pixel = true, .x = 20, .y = 30 }
    };
    assert_int_equal(run(&f.list, &desc, &f.error), GP_OK);
    assert_true(seen.in_order);
    assert_int_equal(seen.count[GP_TRACE_CLEAR], 1);
    assert_int_equal(seen.count[GP_TRACE_VERTEX], 9); /* one triangle of each draw covers it */
    assert_int_equal(seen.count[GP_TRACE_CLIP], 3);
    assert_int_equal(seen.count[GP_TRACE_SETUP], 3);
    assert_int_equal(seen.count[GP_TRACE_RASTER], 3);
    assert_int_equal(seen.count[GP_TRACE_INTERPOLATE], 3);
    assert_int_equal(seen.count[GP_TRACE_PIXEL], 3);
    assert_int_equal(seen.count[GP_TRACE_TEST], 3);
    assert_int_equal(seen.count[GP_TRACE_OUTPUT], 1); /* the first one wins, the others tie */
    free_drawing(&f);
}

/* Counts events, of which all must be of one pass, draw or primitive. */
typedef struct Only {
    const GpTrace *filter;
    int count[GP_TRACE_KINDS];
} Only;

static void note_only(void *user, const GpTraceEvent *event)
{
    Only *only = user;
    const GpTrace *filter = only->filter;
    assert_true(!filter->one_pass || event->pass == filter->pass);
    if (event->kind != GP_TRACE_CLEAR) {
        assert_true(!filter->one_draw || event->draw == filter->draw);
        assert_true(!filter->one_primitive || event->primitive == filter->primitive);
    }
    only->count[event->kind]++;
}

/* Three draws of two triangles in each of two passes, the second of each culled. */
static void a_trace_tells_of_one_pass_draw_or_primitive_alone(void **state)
{
    (void)state;
    static const struct {
        bool pass, draw, primitive;
        int seen; /* triangles set up */
    } rows[] = { { false, false, false, 12 }, { true, false, false, 6 }, { false, true, false, 4 },
                 { false, false, true, 6 },   { true, true, false, 2 },  { true, false, true, 3 },
                 { false, true, true, 2 },    { true, true, true, 1 } };
    Corner corners[6];
    memcpy(corners, full_screen, sizeof corners);
    corners[4] = full_screen[5];
    corners[5] = full_screen[4];
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        for (uint32_t primitive = 0; primitive < 2; primitive++) {
            Drawing f = new_drawing(GP_A8R8G8B8);
            link_drawing(&f, 3, &exercise_color, corners, 6);
            const GpCull front = i % 2 ? GP_CULL_CW : GP_CULL_CCW;
            for (int k = 0; k < 3; k++)
                f.draw[k].state.raster.cull = front;
            GpPass passes[2] = { f.pass, f.pass };
            Only only = { .filter = NULL };
            GpDeviceDesc desc = { .executor = GP_EXECUTOR_REFERENCE,
                                  .trace = { .event = note_only,
                                             .user = &only,
                                             .missed = true,
                                             .one_pass = rows[i].pass,
                                             .pass = 1,
                                             .one_draw = rows[i].draw,
                                             .draw = 2,
                                             .one_primitive = rows[i].primitive,
                                             .primitive = primitive } };
            only.filter = &desc.trace;
            assert_int_equal(run(&(GpList){ passes, 2 }, &desc, &f.error), GP_OK);
            assert_int_equal(only.count[GP_TRACE_SETUP], rows[i].seen);
            if (rows[i].primitive) {
                const bool drawn = only.count[GP_TRACE_RASTER] > 0;
                assert_true(drawn != (only.count[GP_TRACE_MISSED] > 0));
            }
            free_drawing(&f);
        }
}

/* Sums the varyings of a triangle's vertices by the shares that the trace reports. */
typedef struct Shares {
    float corner[3][4]; /* of the colour */
    int corners;
    int checked;
} Shares;

static void check_shares(void *user, const GpTraceEvent *event)
{
    Shares *shares = user;
    if (event->kind == GP_TRACE_VERTEX)
        memcpy(shares->corner[shares->corners++ % 3], event->vertex.varyings + 2,
               sizeof shares->corner[0]);
    if (event->kind != GP_TRACE_INTERPOLATE)
        return;
    for (int c = 0; c < 4; c++) {
        float sum = 0;
        for (int k = 0; k < 3; k++)
            sum += event->interpolate.barycentric[k] * shares->corner[k][c];
        assert_true(fabsf(sum - event->interpolate.varyings[2 + c]) < 1e-5f);
    }
    shares->checked++;
}

static void traced_shares_are_those_of_the_vertices_in_their_order(void **state)
{
    (void)state;
    Corner corners[3] = { { { -1, -1, 0.5f, 1 }, { 1, 0, 0, 1 }, { 0, 0 } },
                          { { 3, -1, 0.5f, 1 }, { 0, 1, 0, 1 }, { 0, 0 } },
                          { { -1, 3, 0.5f, 1 }, { 0, 0, 1, 1 }, { 0, 0 } } };
    for (int turn = 0; turn < 2; turn++) { /* counter-clockwise, then clockwise */
        Shares shares = { .corners = 0 };
        Drawing f = new_drawing(GP_A8R8G8B8);
        link_drawing(&f, 1, &exercise_depth, corners, 3);
        GpDeviceDesc desc = {
            .executor = GP_EXECUTOR_REFERENCE,
            .trace = { .event = check_shares, .user = &shares, .one_pixel = true, .x = 9, .y = 40 }
        };
        assert_int_equal(run(&f.list, &desc, &f.error), GP_OK);
        assert_int_equal(shares.checked, 1);
        free_drawing(&f);
        Corner swap = corners[1];
        corners[1] = corners[2];
        corners[2] = swap;
    }
}

static void watching_changes_no_bit(void **state)
{
    (void)state;
    RandomList *random = gp_alloc(1, sizeof *random);
    long events = 0;
    for (uint64_t seed = 300; seed < 330; seed++) {
        uint64_t hash[2];
        for (int watched = 0; watched < 2; watched++) {
            GpError error;
            GpDeviceDesc desc = { .executor = GP_EXECUTOR_REFERENCE };
            if (watched)
                desc.trace = (GpTrace){ .event = ignore_event, .user = &events };
            assert_true(random_list_create(seed, 24, random));
            assert_int_equal(run(&random->list, &desc, &error), GP_OK);
            hash[watched] = random_list_hash(random);
            random_list_destroy(random);
        }
        assert_true(hash[0] == hash[1]);
    }
    assert_true(events > 10000);
    gp_free(random);
}

/* How many tests of each unit there were, that passed and that did not. */
typedef struct Tests {
    int stencil[2], depth[2];
    /* the pixel whose stencil test failed last, as a number; -1: another event came since */
    int stopped;
} Tests;

static void check_test(void *user, const GpTraceEvent *event)
{
    Tests *tests = user;
    const GpTraceTest *test = &event->test;
    const int stopped = tests->stopped, pixel = event->y * 256 + event->x;
    tests->stopped = -1;
    if (event->kind != GP_TRACE_TEST)
        return;
    const bool is_stencil = strcmp(test->unit, "stencil") == 0;
    if (is_stencil) {
        assert_int_equal(test->passed, gp_compare_codes(test->compare, (uint32_t)test->incoming,
                                                        (uint32_t)test->stored));
        tests->stencil[test->passed]++;
        tests->stopped = test->passed ? -1 : pixel;
    } else if (strcmp(test->unit, "depth") == 0 && !test->ternary) {
        assert_true(pixel != stopped); /* what the stencil test stops is not asked for its depth */
        assert_int_equal(test->passed,
                         gp_compare_codes(test->compare, test->incoming_code, test->stored_code));
        tests->depth[test->passed]++;
    }
}

/* Whatever pixel of its quad a fragment is. */
static void what_a_test_says_is_what_its_comparison_does(void **state)
{
    (void)state;
    RandomList *random = gp_alloc(1, sizeof *random);
    Tests tests = { .stopped = -1 };
    for (uint64_t seed = 400; seed < 440; seed++) {
        GpError error;
        const GpDeviceDesc desc = { .executor = GP_EXECUTOR_REFERENCE,
                                    .trace = { .event = check_test, .user = &tests } };
        assert_true(random_list_create(seed, 24, random));
        assert_int_equal(run(&random->list, &desc, &error), GP_OK);
        random_list_destroy(random);
    }
    for (int passed = 0; passed < 2; passed++)
        assert_true(tests.stencil[passed] > 1000 && tests.depth[passed] > 1000);
    gp_free(random);
}

/* Events of each kind; those of wanted pixels mixed in their order. */
typedef struct Heard {
    int count[GP_TRACE_KINDS];
    uint64_t mix;
    uint32_t width, height; /* of the largest pass: nobody is asked for pixels that are not there */
} Heard;

static bool is_chosen(void *user, int32_t x, int32_t y)
{
    const Heard *heard = user;
    assert_true(x >= 0 && y >= 0 && (uint32_t)x < heard->width && (uint32_t)y < heard->height);
    return (x * 31 + y * 17) % 23 == 0;
}

static void mix(Heard *heard, const void *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++)
        heard->mix = (heard->mix ^ ((const uint8_t *)bytes)[i]) * 0x100000001b3;
}

static void hear(void *user, const GpTraceEvent *event)
{
    Heard *heard = user;
    heard->count[event->kind]++;
    if (event->x < 0)
        return;
    mix(heard, &event->kind, sizeof event->kind);
    mix(heard, &event->x, sizeof event->x);
    mix(heard, &event->y, sizeof event->y);
    mix(heard, &event->draw, sizeof event->draw);
    mix(heard, &event->primitive, sizeof event->primitive);
    if (event->kind == GP_TRACE_OUTPUT)
        mix(heard, event->output.result, sizeof event->output.result);
    if (event->kind == GP_TRACE_INTERPOLATE)
        mix(heard, event->interpolate.varyings,
            (size_t)event->interpolate.components * sizeof(float));
}

static uint64_t run_random(uint64_t seed, const GpDeviceDesc *desc)
{
    RandomList *random = calloc(1, sizeof *random);
    Heard *heard = desc->trace.user;
    GpError error = { "" };
    assert_true(random && random_list_create(seed, 48, random));
    for (uint32_t p = 0; p < random->list.pass_count; p++) {
        uint32_t width, height;
        gp_pass_size(&random->passes[p], &width, &height);
        heard->width = width > heard->width ? width : heard->width;
        heard->height = height > heard->height ? height : heard->height;
    }
    if (run(&random->list, desc, &error))
        fail_msg("list %llu: %s", (unsigned long long)seed, error.text);
    const uint64_t hash = random_list_hash(random);
    random_list_destroy(random);
    free(random);
    return hash;
}

static void expect_alike(uint64_t seed, GpTrace trace, Heard heard[2])
{
    uint64_t hash[2];
    for (int turn = 0; turn < 2; turn++) {
        heard[turn] = (Heard){ .mix = 1 };
        trace.event = hear;
        trace.user = &heard[turn];
        trace.only_wanted = turn == 1;
        const GpExecutor executor = turn ? GP_EXECUTOR_FAST : GP_EXECUTOR_REFERENCE;
        hash[turn] =
            run_random(seed, &(GpDeviceDesc){ .executor = executor, .threads = 2, .trace = trace });
    }
    assert_true(hash[0] == hash[1]);
    assert_memory_equal(heard[0].count, heard[1].count, sizeof heard[0].count);
    assert_true(heard[0].mix == heard[1].mix);
}

static void watched_at_speed_the_events_are_those_of_the_reference_executor(void **state)
{
    (void)state;
    int outputs = 0, missed = 0;
    for (uint64_t seed = 1; seed <= 80; seed++) {
        Heard heard[2];
        expect_alike(seed, (GpTrace){ .wants = is_chosen, .missed = true, .steps = true }, heard);
        outputs += heard[0].count[GP_TRACE_OUTPUT];
        missed += heard[0].count[GP_TRACE_MISSED];
        expect_alike(seed, (GpTrace){ .one_pixel = true, .x = 5, .y = 7, .missed = true }, heard);
        expect_alike(seed,
                     (GpTrace){ .one_pass = true, .pass = (uint32_t)seed % 3, .wants = is_chosen },
                     heard);
        expect_alike(seed, (GpTrace){ .one_draw = true, .draw = 1, .wants = is_chosen }, heard);
    }
    assert_true(outputs > 1000 && missed > 1000);
}

static void each_executor_has_traces_of_its_own_kind(void **state)
{
    (void)state;
    GpDevice *device = NULL;
    for (int executor = 0; executor < GP_EXECUTORS; executor++) {
        GpError error = { "" };
        const GpDeviceDesc desc = { .executor = (GpExecutor)executor,
                                    .trace = { .event = hear,
                                               .only_wanted = executor != GP_EXECUTOR_FAST } };
        assert_int_equal(gp_device_create(&desc, &device, &error), GP_ERROR_INVALID);
        assert_non_null(strstr(error.text, "trace"));
        assert_null(device);
    }
}

static void kinds_that_are_left_out_change_no_other(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 3 * GP_TRACE_KINDS; seed++) {
        const uint32_t kind = (uint32_t)seed % GP_TRACE_KINDS;
        Heard heard[2] = { { .mix = 1 }, { .mix = 1 } };
        uint64_t hash[2];
        for (int turn = 0; turn < 2; turn++) {
            const GpTrace trace = { .event = hear,
                                    .user = &heard[turn],
                                    .missed = true,
                                    .steps = true,
                                    .without = turn ? 1u << kind : 0 };
            hash[turn] = run_random(
                seed, &(GpDeviceDesc){ .executor = GP_EXECUTOR_REFERENCE, .trace = trace });
        }
        assert_true(hash[0] == hash[1]);
        assert_int_equal(heard[1].count[kind], 0);
        heard[0].count[kind] = 0;
        assert_memory_equal(heard[0].count, heard[1].count, sizeof heard[0].count);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_watched_pixel_reports_every_unit_in_order),
        cmocka_unit_test(a_trace_tells_of_one_pass_draw_or_primitive_alone),
        cmocka_unit_test(traced_shares_are_those_of_the_vertices_in_their_order),
        cmocka_unit_test(watching_changes_no_bit),
        cmocka_unit_test(what_a_test_says_is_what_its_comparison_does),
        cmocka_unit_test(watched_at_speed_the_events_are_those_of_the_reference_executor),
        cmocka_unit_test(each_executor_has_traces_of_its_own_kind),
        cmocka_unit_test(kinds_that_are_left_out_change_no_other),
    };
    return cmocka_run_group_tests_name("trace", tests, NULL, NULL);
}
