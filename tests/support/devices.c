#include "tests/support/devices.h"

#include "tests/support/unit.h"

#include <stdio.h>

/* --- the list --------------------------------------------------------------------------------- */

enum { MOST_DEVICES = 16 };

static GpDeviceDesc devices[MOST_DEVICES];
static size_t device_count;

/* Adds a device where there is one; false where the processor, or the build, has no such lanes. */
static bool add_device(const GpDeviceDesc *desc)
{
    GpDevice *device = NULL;
    GpError error = { "" };
    const GpResult result = gp_device_create(desc, &device, &error);
    gp_device_destroy(&device);
    if (result && result != GP_ERROR_UNSUPPORTED)
        fail_msg("%s: %s", device_name(desc), error.text);
    assert_true(device_count < MOST_DEVICES);
    if (!result)
        devices[device_count++] = *desc;
    return !result;
}

static void find_devices(void)
{
    static const char *const widths[] = { "lanes4", "lanes8", "lanes16" };
    const char *widest = NULL;
    char missing[64] = "";
    add_device(&(GpDeviceDesc){ .executor = GP_EXECUTOR_REFERENCE });
    add_device(&(GpDeviceDesc){ .threads = 2 });
    for (size_t w = 0; w < GP_COUNT(widths); w++) {
        if (add_device(&(GpDeviceDesc){ .threads = 1, .isa = widths[w] }) &&
            add_device(&(GpDeviceDesc){ .threads = 3, .isa = widths[w] }))
            widest = widths[w];
        else
            strcat(strcat(missing, " "), widths[w]);
    }
    add_device(&(GpDeviceDesc){ .executor = GP_EXECUTOR_REFERENCE, .isa = widest });
    char text[40 * MOST_DEVICES] = "# devices: ";
    for (size_t d = 0; d < device_count; d++)
        strcat(strcat(text, d ? "; " : ""), device_name(&devices[d]));
    print_message("%s\n# not on this processor, or not built:%s\n", text,
                  missing[0] ? missing : " none");
}

const GpDeviceDesc *device_here(size_t number)
{
    if (!device_count)
        find_devices();
    return number < device_count ? &devices[number] : NULL;
}

const char *device_name(const GpDeviceDesc *desc)
{
    static char name[40];
    const char *isa = desc->isa ? desc->isa : "auto";
    if (desc->executor == GP_EXECUTOR_REFERENCE)
        snprintf(name, sizeof name, "reference %s", isa);
    else
        snprintf(name, sizeof name, "fast %s x%d", isa, desc->threads);
    return name;
}

/* --- runs ------------------------------------------------------------------------------------- */

GpDevice *device_open(const GpDeviceDesc *desc)
{
    GpDevice *device = NULL;
    GpError error = { "" };
    if (gp_device_create(desc, &device, &error))
        fail_msg("%s: %s", device_name(desc), error.text);
    return device;
}

void run_list_on(const GpDeviceDesc *desc, const GpList *list)
{
    GpDevice *device = device_open(desc);
    GpError error = { "" };
    if (gp_device_run(device, list, &error))
        fail_msg("%s: %s", device_name(desc), error.text);
    gp_device_destroy(&device);
}

void run_list(const GpList *list)
{
    run_list_on(&(GpDeviceDesc){ .threads = 2 }, list);
}

uint64_t hash_targets(const GpList *list)
{
    uint64_t hash = 0;
    for (uint32_t p = 0; p < list->pass_count; p++) {
        const GpPass *pass = &list->passes[p];
        for (int t = 0; t < GP_MAX_TARGETS && pass->color[t].surface; t++)
            hash = hash * 31 + gp_surface_hash(pass->color[t].surface);
        if (pass->depth.surface)
            hash = hash * 31 + gp_surface_hash(pass->depth.surface);
    }
    return hash;
}

/* The texels that there are of level 0. */
static uint8_t *first_texel(const GpSurface *surface)
{
    return gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes,
                            (uint32_t)surface->window.x0, (uint32_t)surface->window.y0);
}

static size_t texel_bytes(const GpSurface *surface)
{
    return surface->level[0].pitch * (size_t)(surface->window.y1 - surface->window.y0);
}

/* What a list draws into, each once. */
typedef struct Targets {
    const GpSurface *surface[64];
    uint8_t *before[64]; /* level 0 of it */
    size_t count;
} Targets;

static void add_target(Targets *targets, const GpSurface *surface)
{
    for (size_t i = 0; i < targets->count; i++)
        if (targets->surface[i] == surface)
            return;
    uint8_t *before = gp_alloc(texel_bytes(surface), 1);
    assert_true(targets->count < GP_COUNT(targets->surface) && before && surface->levels == 1);
    memcpy(before, first_texel(surface), texel_bytes(surface));
    targets->before[targets->count] = before;
    targets->surface[targets->count++] = surface;
}

static void find_targets(const GpList *list, Targets *targets)
{
    for (uint32_t p = 0; p < list->pass_count; p++) {
        const GpPass *pass = &list->passes[p];
        for (int t = 0; t < GP_MAX_TARGETS && pass->color[t].surface; t++)
            add_target(targets, pass->color[t].surface);
        if (pass->depth.surface)
            add_target(targets, pass->depth.surface);
    }
}

void run_list_everywhere(const GpList *list, const char *what)
{
    Targets targets = { .count = 0 };
    uint64_t first = 0;
    find_targets(list, &targets);
    for (size_t d = 0; device_here(d); d++) {
        for (size_t i = 0; i < targets.count; i++)
            memcpy(first_texel(targets.surface[i]), targets.before[i],
                   texel_bytes(targets.surface[i]));
        run_list_on(device_here(d), list);
        const uint64_t hash = hash_targets(list);
        first = d == 0 ? hash : first;
        if (hash != first)
            fail_msg("%s: %s draws other bits", what, device_name(device_here(d)));
    }
    for (size_t i = 0; i < targets.count; i++)
        gp_free(targets.before[i]);
}

void run_everywhere(const Frame *frame)
{
    run_list_everywhere(&frame->list, "the frame");
}

static uint64_t hash_pass(const GpPass *pass, const GpDeviceDesc *desc)
{
    const GpList list = { pass, 1 };
    run_list_on(desc, &list);
    return hash_targets(&list);
}

void run_seed_everywhere(const GpPass *pass, int seed)
{
    const uint64_t expected = hash_pass(pass, device_here(0));
    for (size_t d = 1; device_here(d); d++)
        if (hash_pass(pass, device_here(d)) != expected)
            fail_msg("seed %d, %s: other bits", seed, device_name(device_here(d)));
}
