/* Lane widths by the processor: what it does not have is refused, and the rest serves every list,
 * those without draws too. Quick, so that it is run as other processors as well. */
#include <glasspipe/glasspipe.h>
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

/* A width is refused where the device is made or not at all: then lists run at it. */
static void a_width_that_is_not_here_is_refused_at_creation(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int lanes;
    } widths[] = { { "lanes4", 4 }, { "lanes8", 8 }, { "lanes16", 16 } };
    for (size_t w = 0; w < GP_COUNT(widths); w++) {
        const GpProgramCode *code = gp_program_code(&exercise_color, widths[w].lanes);
        const GpDeviceDesc desc = { .threads = 1, .isa = widths[w].name };
        GpDevice *device = NULL;
        GpError error = { "" };
        const GpResult result = gp_device_create(&desc, &device, &error);
        bool here = code != NULL;
#if defined(__x86_64__)
        if (code && strcmp(code->isa, "avx2") == 0)
            here = __builtin_cpu_supports("avx2");
        if (code && strcmp(code->isa, "avx512") == 0)
            here = __builtin_cpu_supports("avx512bw");
#endif
        assert_int_equal(result, here ? GP_OK : GP_ERROR_UNSUPPORTED);
        assert_true(here == (device != NULL));
        if (!here)
            assert_non_null(strstr(error.text, widths[w].name));
        gp_device_destroy(&device);
    }
}

static void lists_without_draws_run_on_every_device(void **state)
{
    (void)state;
    enum { SIZE = 20 };
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = SIZE, .height = SIZE };
    GpSurface *surface = NULL;
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    const GpPass clear = { .color[0] = { surface, true, { 0, 0, 1, 0 } } };
    uint8_t *texels = surface->level[0].texels;
    for (size_t d = 0; device_here(d); d++) {
        run_list_on(device_here(d), &(GpList){ NULL, 0 });
        memset(texels, 0x5a, SIZE * SIZE * 4);
        run_list_on(device_here(d), &(GpList){ &clear, 1 });
        for (int i = 0; i < SIZE * SIZE; i++)
            assert_memory_equal(texels + 4 * i, "\xff\0\0\0", 4);
    }
    gp_surface_destroy(&surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_width_that_is_not_here_is_refused_at_creation),
        cmocka_unit_test(lists_without_draws_run_on_every_device),
    };
    return cmocka_run_group_tests_name("widths", tests, NULL, NULL);
}
