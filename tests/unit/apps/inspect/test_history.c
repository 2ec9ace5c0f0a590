/* Histories end in what the targets hold: 10,000 pixels of random lists, chosen at random, of both
 * executors; and shaders' steps there end in the bits that were drawn. */
#include "tests/support/devices.h"
#include "tests/support/random_list.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <stdio.h>

enum { LISTS = 40, PIXELS = 250, LARGEST = 64 };

/* The last thing that was heard of a target's pixel. */
typedef struct Last {
    bool known;
    float result[4];
} Last;

typedef struct Watch {
    const GpList *list;
    Last (*last)[RANDOM_SURFACES]; /* [pixel of the largest size][surface] */
    const RandomList *random;
    uint64_t steps, vertices, disagree;
} Watch;

static int number_of(const RandomList *random, const GpSurface *surface)
{
    for (int i = 0; i < random->surface_count; i++)
        if (random->surfaces[i] == surface)
            return i;
    return -1;
}

static void take(void *user, const GpTraceEvent *event)
{
    Watch *watch = user;
    if (event->kind == GP_TRACE_STEPS) {
        watch->steps++;
        watch->vertices += event->steps.of_vertex;
        watch->disagree += !event->steps.agrees;
    }
    if (event->kind == GP_TRACE_CLEAR) {
        const GpPass *pass = event->clear.pass;
        for (int t = 0; t < GP_MAX_TARGETS; t++) {
            const int number =
                pass->color[t].clear ? number_of(watch->random, pass->color[t].surface) : -1;
            for (int i = 0; number >= 0 && i < LARGEST * LARGEST; i++)
                watch->last[i][number].known = false; /* until something is drawn there */
        }
    }
    if (event->kind != GP_TRACE_OUTPUT)
        return;
    const int number = number_of(watch->random, event->output.surface);
    Last *last = &watch->last[event->y * LARGEST + event->x][number];
    last->known = true;
    memcpy(last->result, event->output.result, sizeof last->result);
}

static bool wants(void *user, int32_t x, int32_t y)
{
    (void)user, (void)x, (void)y;
    return true;
}

static uint64_t run_on(const GpDeviceDesc *desc, int seed, RandomList *random)
{
    GpError error = { "" };
    GpDevice *device = NULL;
    assert_true(random_list_create((uint64_t)seed, LARGEST, random));
    assert_int_equal(gp_device_create(desc, &device, NULL), GP_OK);
    if (gp_device_run(device, &random->list, &error))
        fail_msg("list %d: %s", seed, error.text);
    gp_device_destroy(&device);
    return random_list_hash(random);
}

/* Random pixels of random targets: what was heard last is what is there. */
static int compare(const Watch *watch, int seed)
{
    Random source = { (uint64_t)seed };
    int found = 0;
    for (int i = 0; i < PIXELS * 8 && found < PIXELS; i++) {
        const int number = random_int(&source, 0, watch->random->surface_count - 1);
        const GpSurface *surface = watch->random->surfaces[number];
        const int32_t x = random_int(&source, 0, (int32_t)surface->width - 1);
        const int32_t y = random_int(&source, 0, (int32_t)surface->height - 1);
        const Last *last =
            x < LARGEST && y < LARGEST ? &watch->last[y * LARGEST + x][number] : NULL;
        float stored[4];
        if (!last || !last->known)
            continue;
        gp_texel_load(surface->format,
                      gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes,
                                       (uint32_t)x, (uint32_t)y),
                      stored);
        if (memcmp(stored, last->result, sizeof stored) != 0)
            fail_msg(
                "list %d, surface %d, pixel (%d, %d): the history ends in (%g, %g, %g, %g), the "
                "target has (%g, %g, %g, %g)",
                seed, number, x, y, (double)last->result[0], (double)last->result[1],
                (double)last->result[2], (double)last->result[3], (double)stored[0],
                (double)stored[1], (double)stored[2], (double)stored[3]);
        found++;
    }
    return found;
}

static void histories_end_in_what_the_targets_hold(void **state)
{
    (void)state;
    int pixels = 0;
    Watch watch = { .last = gp_alloc(LARGEST * LARGEST, sizeof *watch.last) };
    RandomList *random = gp_alloc(1, sizeof *random), *fast = gp_alloc(1, sizeof *fast);
    assert_true(watch.last && random && fast);
    for (int seed = 0; seed < 4 * LISTS && pixels < LISTS * PIXELS; seed++) {
        memset(watch.last, 0, LARGEST * LARGEST * sizeof *watch.last);
        watch.random = random;
        const GpDeviceDesc traced = {
            .executor = GP_EXECUTOR_REFERENCE,
            .trace = { .event = take,
                       .user = &watch,
                       .wants = wants,
                       .steps = true,
                       .missed = true },
        };
        const uint64_t hash = run_on(&traced, seed, random);
        pixels += compare(&watch, seed);
        if (run_on(&(GpDeviceDesc){ .threads = 2 }, seed, fast) != hash)
            fail_msg("list %d: the executors differ", seed);
        random_list_destroy(fast);
        random_list_destroy(random);
    }
    gp_free(fast);
    gp_free(random);
    gp_free(watch.last);
    if (watch.disagree)
        fail_msg("%llu of %llu runs by steps end in other bits", (unsigned long long)watch.disagree,
                 (unsigned long long)watch.steps);
    printf("# %d pixels, %llu shaders run by steps\n", pixels, (unsigned long long)watch.steps);
    assert_true(pixels >= LISTS * PIXELS);
    assert_true(watch.vertices > 0 && watch.steps > watch.vertices);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(histories_end_in_what_the_targets_hold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
