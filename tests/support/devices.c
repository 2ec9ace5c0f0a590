#include "tests/support/devices.h"

#include "tests/support/unit.h"

/* The first is compared with. */
static const GpDeviceDesc devices[] = {
    { .executor = GP_EXECUTOR_REFERENCE },
    { .executor = GP_EXECUTOR_REFERENCE, .isa = "lanes4" },
    { .threads = 1 },
    { .threads = 1, .isa = "lanes4" },
    { .threads = 3, .isa = "lanes8" },
    { .threads = 3, .isa = "lanes16" },
};

/* False where the processor, or the build, has no such lanes. */
static bool run_on(const GpDeviceDesc *desc, const GpList *list)
{
    GpDevice *device = NULL;
    GpError error = { "" };
    if (gp_device_create(desc, &device, &error) == GP_ERROR_UNSUPPORTED)
        return false;
    if (!device || gp_device_run(device, list, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
    return true;
}

void run_list(const GpList *list)
{
    run_on(&(GpDeviceDesc){ .threads = 2 }, list);
}

static size_t level_bytes(const GpLevel *level)
{
    return level->pitch * level->height;
}

static uint64_t hash_surfaces(const Frame *frame)
{
    uint64_t hash = 0;
    for (int i = 0; i < frame->surface_count; i++)
        hash = hash * 3 + gp_surface_hash(frame->surfaces[i]);
    return hash;
}

void run_everywhere(const Frame *frame)
{
    uint8_t *before[FRAME_MAX_SURFACES] = { NULL };
    uint64_t first = 0;
    for (int i = 0; i < frame->surface_count; i++) {
        const GpLevel *level = &frame->surfaces[i]->level[0];
        assert_int_equal(frame->surfaces[i]->levels, 1);
        before[i] = gp_alloc(level_bytes(level), 1);
        assert_non_null(before[i]);
        memcpy(before[i], level->texels, level_bytes(level));
    }
    for (size_t d = 0; d < GP_COUNT(devices); d++) {
        for (int i = 0; i < frame->surface_count; i++) {
            const GpLevel *level = &frame->surfaces[i]->level[0];
            memcpy(level->texels, before[i], level_bytes(level));
        }
        if (!run_on(&devices[d], &frame->list))
            continue;
        const uint64_t hash = hash_surfaces(frame);
        first = d == 0 ? hash : first;
        if (hash != first)
            fail_msg("device %zu draws other bits", d);
    }
    for (int i = 0; i < frame->surface_count; i++)
        gp_free(before[i]);
}
